//! How many workers help with bands of a large input: measured on one core, simulated for up to a thousand.
//!
//! `cargo bench -p sweep-cdt-benches --bench bands` measures bands of even inputs of 1e8 points, and prints a table.
//! `-- full` goes on to 1e10 points, with up to 4 GB of memory, and writes the figure `docs/workers.svg`. `-- check COMMAND`
//! takes the path of `sweep-cdt`, runs it with one worker and with two, and prints times beside those of the simulation.

mod check;
mod figure;
mod measure;
mod simulate;

use measure::Band;
use simulate::{Plan, Run, best};

/// Bands have so many rows of points.
const ROWS: [u64; 4] = [16, 32, 64, 128];
/// Larger bands take too much memory.
const LARGEST: u64 = 7_000_000;

fn main() {
    // Cargo itself adds an argument, `--bench`.
    let arguments = std::env::args().skip(1);
    let arguments: Vec<String> = arguments.filter(|text| text != "--bench").collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["check", command] => check::run(command.as_ref()),
        ["full"] => report(&[100_000_000, 1_000_000_000, 10_000_000_000], true),
        _ => report(&[100_000_000], false),
    }
}

fn report(totals: &[u64], draws: bool) {
    let sort = [1_000_000, 20_000_000].map(measure::sort);
    println!(
        "sort: {:.2} and {:.2} ns for each point and step of log n",
        1e9 * sort[0],
        1e9 * sort[1]
    );
    println!(
        "disk: {:.2} GB a second, written and read",
        measure::disk() / 1e9
    );
    println!(
        "\n| points | a band | cut, ns a point | ns a point | a rest | by the root | bytes | left of eight | join of eight | ns a vertex | GB, band | GB, join |"
    );
    println!("|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
    let mut all: Vec<Vec<Band>> = Vec::new();
    for &total in totals {
        let root = total.isqrt();
        let sizes = ROWS.map(|rows| rows * root);
        let bands = sizes.into_iter().filter(|&size| size < LARGEST);
        let bands: Vec<Band> = bands.map(|size| measure::band(total, size)).collect();
        for band in &bands {
            let [of_band, of_join] = band.memory.map(|bytes| bytes as f64 / 1e9);
            println!(
                "| {total:.0e} | {} | {:.0} | {:.0} | {:.0} | {:.2} | {:.0} | {:.0} | {:.2} s | {:.0} | {of_band:.2} | {of_join:.2} |",
                band.size,
                1e9 * band.cutting / band.size as f64,
                1e9 * band.seconds / band.size as f64,
                band.rest,
                band.rest / root as f64,
                band.rest_bytes,
                band.left,
                band.join.at(8.0 * band.rest),
                1e9 * band.join.at(8.0 * band.rest) / (8.0 * band.rest),
            );
        }
        all.push(bands);
    }
    simulated(&all, sort[1]);
    if draws {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/workers.svg");
        std::fs::write(path, figure::svg(&all, sort[1])).expect("the folder docs");
        println!("\nwritten: docs/workers.svg");
    }
}

/// The table of simulated runs.
fn simulated(all: &[Vec<Band>], sort: f64) {
    println!(
        "\n| points | workers | a band | time | speed-up | joins alone | limit | fan 2 | one machine sorts | a disk each | speed-up | joins alone |"
    );
    println!("|---:|---:|---:|---:|---:|---:|---|---:|---:|---:|---:|---:|");
    for bands in all {
        let one = best(bands, sort, Plan::of(1));
        for workers in [1, 10, 100, 1000] {
            let plan = Plan::of(workers);
            let run = best(bands, sort, plan);
            let apart = best(
                bands,
                sort,
                Plan {
                    served: workers,
                    ..plan
                },
            );
            let other = |plan| best(bands, sort, plan).total();
            let losses = [
                ("work", run.total() / 10.0),
                ("disk", run.total() - apart.total()),
                ("joins", run.joins),
            ];
            let limit = losses.into_iter().max_by(|a, b| a.1.total_cmp(&b.1));
            println!(
                "| {:.0e} | {workers} | {} | {:.1} s | {:.1} | {:.1} s | {} | {:.1} s | {:.1} s | {:.1} s | {:.1} | {:.1} s |",
                bands[0].total as f64,
                run.band,
                run.total(),
                one.total() / run.total(),
                run.joins,
                limit.expect("three").0,
                other(Plan { fan: 2, ..plan }),
                other(Plan {
                    sorted_by_one: true,
                    ..plan
                }),
                apart.total(),
                one.total() / apart.total(),
                apart.joins,
            );
        }
        let Run {
            sort,
            bands,
            joins,
            joining,
            ..
        } = one;
        println!(
            "one worker: {sort:.0} s sort and cut, {:.0} s bands, {joining:.0} s joins",
            bands + joins - joining
        );
    }
}

//! Tables of names and numbers, and that of `--stats`; the object of `--stats-json`.

use std::io::{self, Write};
use std::time::Duration;

use serde::Serialize;
use sweep_cdt::{ByCause, Stats};

/// The width of the names.
pub(crate) const NAME: usize = 26;
/// The width of the numbers, which end in one column.
pub(crate) const NUMBER: usize = 12;

/// Writes names and numbers in columns.
pub(crate) fn rows(out: &mut impl Write, rows: &[(&str, u64)]) -> io::Result<()> {
    for (name, number) in rows {
        writeln!(out, "{name:NAME$}{:>NUMBER$}", grouped(*number))?;
    }
    Ok(())
}

/// A number with commas between its thousands.
pub(crate) fn grouped(number: u64) -> String {
    if number < 1000 {
        return number.to_string();
    }
    format!("{},{:03}", grouped(number / 1000), number % 1000)
}

/// Writes the numbers of a run, in groups; the phases are those of the paper's table 2.
pub(crate) fn write_statistics(stats: &Stats, out: &mut impl Write) -> io::Result<()> {
    let count = stats.counters;
    let size = |number: usize| number as u64;
    rows(
        out,
        &[
            ("points", size(stats.points)),
            ("duplicates", size(stats.duplicates)),
            ("edges", size(stats.edges)),
            ("triangles", size(stats.triangles)),
            ("hull", size(stats.hull)),
        ],
    )?;

    let algorithm = if stats.is_divided {
        "divide and conquer"
    } else {
        "sweep"
    };
    writeln!(out, "\n{:NAME$}{algorithm}", "algorithm")?;

    // The times of the phases, each with its share of their sum.
    let phases = [
        ("initialization", stats.initialization),
        ("sweeping", stats.sweeping),
        ("finalization", stats.finalization),
    ];
    let total: Duration = phases.iter().map(|(_, time)| *time).sum();
    writeln!(out)?;
    for (name, time) in phases.into_iter().chain([("total", total)]) {
        let share = 100.0 * time.as_secs_f64() / total.as_secs_f64().max(f64::MIN_POSITIVE);
        let time = time.as_secs_f64() * 1e3;
        writeln!(out, "{name:NAME$}{time:>NUMBER$.3} ms {share:6.1} %")?;
    }
    let each = stats.memory as f64 / stats.points.max(1) as f64;
    let memory = stats.memory as f64 / 1e6;
    writeln!(
        out,
        "\n{:NAME$}{memory:>NUMBER$.3} MB {each:6.1} bytes a point\n",
        "memory"
    )?;

    // How signs were decided, and then the work of each part of the sweep.
    rows(
        out,
        &[
            ("orientation: filter", count.orient2d_filtered),
            ("  integers", count.orient2d_integers),
            ("  expansions", count.orient2d_expansions),
            ("  big integers", count.orient2d_big),
            ("  own arithmetic", count.orient2d_own),
            ("in circle: filter", count.in_circle_filtered),
            ("  integers", count.in_circle_integers),
            ("  expansions", count.in_circle_expansions),
            ("  big integers", count.in_circle_big),
            ("  own arithmetic", count.in_circle_own),
            ("artificial, by rule", count.symbolic),
            ("cocircular", count.cocircular),
        ],
    )?;
    writeln!(out)?;
    rows(
        out,
        &[
            ("point events", count.point_events),
            ("front steps", count.front_steps),
            ("front: greatest length", count.longest_front),
        ],
    )?;
    mean(out, "front: mean length", count.mean_front())?;
    rows(
        out,
        &[
            ("legalization: tests", count.legalization_tests),
            ("  flips", count.flips),
            ("  most tests of one", count.most_tests),
            ("  most flips of one", count.most_flips),
        ],
    )?;
    mean(out, "  mean tests of one", count.mean_tests())?;
    mean(out, "  mean flips of one", count.mean_flips())?;
    rows(
        out,
        &[
            ("edges there already", count.edges_present),
            ("edges inserted", count.edges_inserted),
            ("triangles pierced", count.pierced),
        ],
    )?;

    // The triangles by cause: how many were made, and how many of them are in the result.
    writeln!(
        out,
        "\n{:NAME$}{:>NUMBER$}{:>NUMBER$}",
        "triangles", "made", "survived"
    )?;
    let [made, survived] = [count.made, count.survived].map(by_cause);
    for ((name, made), (_, survived)) in made.into_iter().zip(survived) {
        let [made, survived] = [made, survived].map(grouped);
        writeln!(out, "{name:NAME$}{made:>NUMBER$}{survived:>NUMBER$}")?;
    }
    Ok(())
}

/// Writes a mean in the column of the numbers.
fn mean(out: &mut impl Write, name: &str, mean: f64) -> io::Result<()> {
    writeln!(out, "{name:NAME$}{mean:>NUMBER$.3}")
}

/// The causes in the words of the table.
fn by_cause(count: ByCause) -> [(&'static str, u64); 11] {
    [
        ("  first", count.first),
        ("  middle case", count.middle),
        ("  left case", count.left),
        ("  narrow corners", count.narrow_corners),
        ("  basins", count.basins),
        ("  pockets", count.pockets),
        ("  pseudo-polygons", count.pseudo_polygons),
        ("  hull", count.hull),
        ("  divide and conquer", count.divide_and_conquer),
        ("  flips", count.flips),
        ("  all", count.sum()),
    ]
}

/// The numbers of a run as they stand in a file, with what is computed of them.
#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    version: &'static str,
    #[serde(flatten)]
    stats: &'a Stats,
    means: Means,
}

#[derive(Serialize)]
struct Means {
    tests: f64,
    flips: f64,
    front: f64,
}

/// Writes the numbers of a run as a JSON object.
pub(crate) fn write_json(stats: &Stats, out: &mut impl Write) -> io::Result<()> {
    let count = stats.counters;
    let document = Document {
        program: env!("CARGO_PKG_NAME"),
        version: env!("CARGO_PKG_VERSION"),
        stats,
        means: Means {
            tests: count.mean_tests(),
            flips: count.mean_flips(),
            front: count.mean_front(),
        },
    };
    serde_json::to_writer_pretty(&mut *out, &document)?;
    writeln!(out)
}

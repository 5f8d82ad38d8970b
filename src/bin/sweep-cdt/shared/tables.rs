//! Tables of names and numbers, and that of `--stats`.

use std::io::{self, Write};
use std::time::Duration;

use sweep_cdt::Stats;

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
fn grouped(number: u64) -> String {
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
            ("flips", count.flips),
            ("front steps", count.front_steps),
            ("left cases", count.left_cases),
            ("triangles: narrow corners", count.narrow_corners),
            ("triangles: basins", count.basin_triangles),
            ("triangles: pockets", count.pocket_triangles),
            ("triangles: hull", count.hull_triangles),
            ("edges there already", count.edges_present),
            ("edges inserted", count.edges_inserted),
            ("triangles pierced", count.pierced),
        ],
    )
}

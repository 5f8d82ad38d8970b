//! Running the verifier, and what it found in words.

use std::fmt::Display;
use std::io::{self, Write};
use std::sync::Mutex;

use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::{Level, Report, Verifier, Violation};
use sweep_cdt_engine::Answer;
use sweep_cdt_formats::{Coordinate, GraphFile, Triangles};

use super::glossary::meaning;
use super::resources::Progress;
use super::tables::{NAME, NUMBER, grouped};

/// Verifies on all cores, with a progress bar where that takes long.
pub(crate) fn verify<T: Scalar + Sync>(
    verifier: Verifier<'_>,
    points: &[[T; 2]],
    edges: &[[usize; 2]],
    triangles: &[[usize; 3]],
) -> Answer {
    let progress = Mutex::new(Progress::new("verifying"));
    let show = |done, all| {
        // If another thread is drawing the bar, this report is not needed.
        if let Ok(mut progress) = progress.try_lock() {
            progress.show(done, all);
        }
    };
    verifier
        .progress(&show)
        .verify_parallel(points, edges, triangles)
}

/// The counts of an answer.
pub(crate) fn report(answer: &Answer) -> &Report {
    match answer {
        Ok(report) => report,
        Err(violations) => &violations.report,
    }
}

/// The violations of an answer that are listed, and how many there are in all.
pub(crate) fn violations(answer: &Answer) -> (&[Violation], usize) {
    match answer {
        Ok(_) => (&[], 0),
        Err(violations) => (&violations.list, violations.found),
    }
}

/// The name of the highest level reached.
pub(crate) fn reached(report: &Report) -> &'static str {
    report.level.map_or("none", Level::name)
}

/// Writes a figure, and below it what it is, if that is asked for.
fn write_figure(
    name: &str,
    figure: impl Display,
    explain: bool,
    out: &mut impl Write,
) -> io::Result<()> {
    writeln!(out, "{name:NAME$}{figure:>NUMBER$}")?;
    if explain {
        writeln!(out, "  {}", meaning(name))?;
    }
    Ok(())
}

/// Writes the counts.
pub(crate) fn write_counts(report: &Report, explain: bool, out: &mut impl Write) -> io::Result<()> {
    let counts = [
        ("points", report.points),
        ("distinct points", report.distinct_points),
        ("edges", report.edges),
        ("triangles", report.triangles),
        ("boundary sides", report.boundary_sides),
        ("constrained sides", report.constrained_sides),
        ("free sides", report.free_sides),
        ("cocircular ties", report.cocircular_sides),
        ("ties not canonical", report.uncanonical_sides),
    ];
    let added = [
        ("added points", report.added_points),
        ("split edges", report.split_edges),
    ];
    let is_shown = |_: &(&str, usize)| report.added_points > 0;
    for (name, number) in counts.into_iter().chain(added.into_iter().filter(is_shown)) {
        write_figure(name, grouped(number as u64), explain, out)?;
    }
    write_figure("highest level", reached(report), explain, out)?;
    let all = (report.filtered + report.exact).max(1);
    for (name, number) in [("by filter", report.filtered), ("exact", report.exact)] {
        let share = 100.0 * number as f64 / all as f64;
        writeln!(
            out,
            "{:NAME$}{share:>NUMBER$.3} %",
            format!("signs: {name}")
        )?;
        if explain {
            writeln!(out, "  {}", meaning(&format!("signs: {name}")))?;
        }
    }
    Ok(())
}

/// Writes how many violations are how deep, by decades.
pub(crate) fn write_depths(answer: &Answer, explain: bool, out: &mut impl Write) -> io::Result<()> {
    let Err(violations) = answer else {
        return Ok(());
    };
    let Some(greatest) = violations.depths.greatest else {
        return Ok(());
    };
    writeln!(out, "\ndepths of violations")?;
    for (&decade, &count) in &violations.depths.decades {
        let name = format!("1e{decade} to 1e{}", decade + 1);
        write_figure(&name, grouped(count as u64), explain, out)?;
    }
    match violations.found - violations.depths.measured() {
        0 => {}
        others => write_figure("not measured", grouped(others as u64), explain, out)?,
    }
    write_figure("the deepest", greatest.to_string(), explain, out)
}

/// Writes the violations, with all things numbered as in their files and where they are.
pub(crate) fn write_violations<S: Coordinate>(
    answer: &Answer,
    file: &GraphFile<S>,
    triangles: &Triangles,
    out: &mut impl Write,
) -> io::Result<()> {
    let (list, found) = violations(answer);
    for &violation in list {
        let numbered = triangles.as_numbered(file, violation);
        writeln!(out, "\n{}: {numbered}", violation.name())?;
        let places: Vec<String> = triangles
            .vertices_of(&file.graph, violation)
            .into_iter()
            .map(|v| {
                let [x, y] = file.graph.points[v].each_ref().map(S::text);
                format!("{} ({x}, {y})", v + file.numbering.vertex)
            })
            .collect();
        if !places.is_empty() {
            writeln!(out, "  {}", places.join(", "))?;
        }
        if let Some(depth) = violation.depth() {
            let unit = match violation {
                Violation::NotDelaunay { .. } => "of the squared radius",
                Violation::BentEdge { .. } => "of the length of the edge",
                Violation::BentBoundary { .. } => "of the distance of the two ends",
                _ => "of the distance of the vertices beside it",
            };
            writeln!(out, "  by {depth} {unit}")?;
        }
    }
    match found - list.len() {
        0 => {}
        more if list.is_empty() => writeln!(out, "\n{more} violations are not listed")?,
        more => writeln!(out, "\nand {more} more")?,
    }
    Ok(())
}

//! The tables and the plot.

mod csv;
mod markdown;
mod plot;
mod text;

use crate::judge::Verdict;
use crate::measure::{Cell, Outcome, Row};
use crate::process::Failure;
use crate::programs::OURS;

pub(crate) use csv::csv;
pub(crate) use markdown::markdown;
pub(crate) use plot::plot;
pub(crate) use text::text;

/// The columns of the main table.
const COLUMNS: [&str; 10] = [
    "data",
    "points",
    "edges",
    "best correct peer",
    "ns",
    OURS,
    "of best",
    "of spade",
    "aim",
    "bytes",
];

/// A row of the main table: what is behind `best correct peer` is its nanoseconds a point, this crate's, the
/// share that this is of the best and of spade, and of spade or the best the aim; this crate's bytes a point.
fn columns(row: &Row) -> [String; COLUMNS.len()] {
    let ours = row.right(OURS);
    let best = row.best(false);
    let spade = row.right("spade");
    let share = |other: Option<Outcome>| match (ours, other) {
        (Some(ours), Some(other)) => format!("{:.2}", ours.time[0] / other.time[0]),
        _ => String::new(),
    };
    let times = if row.inputs == 1 {
        String::new()
    } else {
        format!("{} x ", row.inputs)
    };
    let aim = row.aim().map(|aim| match spade {
        Some(spade) => format!("{:.2}", aim / spade.time[0]),
        None => format!("{aim:.0} ns"),
    });
    [
        row.name.clone(),
        format!("{times}{}", row.size[0]),
        row.size[1].to_string(),
        best.map_or("none", |(cell, _)| cell.program).to_owned(),
        best.map_or(String::new(), |(_, outcome)| time(outcome)),
        row.cells
            .iter()
            .find(|cell| cell.program == OURS)
            .map_or(String::new(), entry),
        share(best.map(|(_, outcome)| outcome)),
        share(spade),
        aim.unwrap_or_default(),
        ours.map_or(String::new(), bytes),
    ]
}

/// A program's nanoseconds a point with their spread and the verdict, if that is not the best.
fn entry(cell: &Cell) -> String {
    match cell.outcome {
        Ok(outcome) => match outcome.verdict {
            Verdict::Delaunay => time(outcome),
            Verdict::Triangulation => format!("{}, not Delaunay", time(outcome)),
            Verdict::Wrong => format!("{}, WRONG", time(outcome)),
        },
        Err(failure) => word(failure).to_owned(),
    }
}

fn word(failure: Failure) -> &'static str {
    match failure {
        Failure::Crash => "crash",
        Failure::TooLong => "too long",
    }
}

/// The median, and by how many percent of it the others differ at most.
fn time(outcome: Outcome) -> String {
    let [median, least, most] = outcome.time;
    let spread = 100.0 * (median - least).max(most - median) / median;
    format!("{median:.0} ±{spread:.0} %")
}

fn bytes(outcome: Outcome) -> String {
    outcome
        .bytes
        .map_or(String::new(), |bytes| format!("{bytes:.0}"))
}

/// All programs of these rows, in the order of their first row.
fn programs<'a>(rows: impl Iterator<Item = &'a Row>) -> Vec<&'static str> {
    let mut programs = Vec::new();
    for cell in rows.flat_map(|row| &row.cells) {
        if !programs.contains(&cell.program) {
            programs.push(cell.program);
        }
    }
    programs
}

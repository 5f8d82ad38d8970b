//! The tables: as plain text, as Markdown and as CSV.

use crate::data::Kind;
use crate::measure::{Calls, Cell, Failure, Outcome, Row, Verdict};
use crate::programs::OURS;

/// Of the columns in plain text.
const WIDTHS: [usize; COLUMNS.len()] = [26, 12, 8, 18, 12, 12, 8, 9, 7, 6];

/// The tables as plain text, row by row: a row, below the names of the columns if it is the first, and above each program's time.
pub(crate) fn text(row: &Row, is_first: bool) -> String {
    let mut text = String::new();
    if is_first {
        text.push_str(&text_line(&COLUMNS.map(str::to_owned)));
    }
    text.push_str(&text_line(&columns(row, Calls::First)));
    let mut last = columns(row, Calls::Last);
    last[0] = "  last calls".to_owned();
    text.push_str(&text_line(&last));
    for cell in &row.cells {
        let [first, last] = [Calls::First, Calls::Last].map(|calls| entry(cell, calls));
        text.push_str(&format!("    {:16} {first}, last {last}\n", cell.program));
    }
    text
}

fn text_line(columns: &[String]) -> String {
    let columns = columns.iter().zip(WIDTHS).enumerate();
    let columns = columns.map(|(i, (text, width))| match i {
        0 => format!("{text:width$}"),
        _ => format!(" {text:>width$}"),
    });
    columns.chain(["\n".to_owned()]).collect()
}

/// The tables as Markdown: the main table, and one of all programs for each kind of data: nanoseconds and bytes a point.
pub(crate) fn markdown(machine: &str, rows: &[Row]) -> String {
    let mut text = String::new();
    for line in machine.lines() {
        text.push_str(&format!("- {line}\n"));
    }
    text.push_str("\nNanoseconds a point are medians; after ± the largest distance from them.\n");
    for calls in [Calls::First, Calls::Last] {
        text.push_str(&format!("\n{}:\n\n", title(calls)));
        text.push_str(&markdown_line(&COLUMNS.map(str::to_owned)));
        text.push_str(&markdown_rule(COLUMNS.len()));
        for row in rows {
            text.push_str(&markdown_line(&columns(row, calls)));
        }
    }
    for (kind, name) in [
        (Kind::Points, "points"),
        (Kind::Edges, "points and edges"),
        (Kind::Polygons, "polygons"),
    ] {
        let of_kind = |row: &&Row| row.kind == kind;
        for calls in [Calls::First, Calls::Last] {
            table(
                &mut text,
                &format!("{}, nanoseconds a point, {name}", title(calls)),
                rows.iter().filter(of_kind),
                |cell| entry(cell, calls),
            );
        }
        table(
            &mut text,
            &format!("Bytes a point beyond the input, {name}"),
            rows.iter().filter(of_kind),
            |cell| cell.outcome.map_or(String::new(), bytes),
        );
    }
    text
}

fn title(calls: Calls) -> &'static str {
    match calls {
        Calls::First => "First calls",
        Calls::Last => "Last calls",
    }
}

/// A table of all programs, without rows that have no entry.
fn table<'a>(
    text: &mut String,
    title: &str,
    rows: impl Iterator<Item = &'a Row>,
    entry: impl Fn(&Cell) -> String,
) {
    let has_entry = |row: &&Row| row.cells.iter().any(|cell| !entry(cell).is_empty());
    let rows: Vec<&Row> = rows.filter(has_entry).collect();
    let programs = programs(rows.iter().copied());
    if rows.is_empty() {
        return;
    }
    text.push_str(&format!("\n{title}:\n\n"));
    let names = programs.iter().map(|&name| name.to_owned());
    text.push_str(&markdown_line(
        &["data".to_owned()]
            .into_iter()
            .chain(names)
            .collect::<Vec<_>>(),
    ));
    text.push_str(&markdown_rule(programs.len() + 1));
    for row in rows {
        let entries = programs.iter().map(|program| {
            let cell = row.cells.iter().find(|cell| cell.program == *program);
            cell.map_or(String::new(), &entry)
        });
        let cells: Vec<_> = [row.name.clone()].into_iter().chain(entries).collect();
        text.push_str(&markdown_line(&cells));
    }
}

fn markdown_line(columns: &[String]) -> String {
    format!("| {} |\n", columns.join(" | "))
}

fn markdown_rule(columns: usize) -> String {
    format!("|---|{}\n", "---:|".repeat(columns - 1))
}

/// All measurements as CSV, one line for each program on each data set.
pub(crate) fn csv(rows: &[Row]) -> String {
    let mut text =
        "data,points,edges,inputs,program,answer,ns_median,ns_least,ns_most,last_median,last_least,last_most,bytes\n"
            .to_owned();
    for row in rows {
        for cell in &row.cells {
            // A name holds a comma, but no quotes.
            let [points, edges] = row.size;
            text.push_str(&format!(
                "\"{}\",{points},{edges},{},{},",
                row.name, row.inputs, cell.program
            ));
            text.push_str(&match cell.outcome {
                Ok(outcome) => {
                    let verdict = match outcome.verdict {
                        Verdict::Delaunay => "delaunay",
                        Verdict::Triangulation => "not delaunay",
                        Verdict::Wrong => "wrong",
                    };
                    let times = [Calls::First, Calls::Last].map(|calls| {
                        let [median, least, most] = outcome.time(calls);
                        format!("{median:.1},{least:.1},{most:.1}")
                    });
                    format!("{verdict},{},{}\n", times.join(","), bytes(outcome))
                }
                Err(failure) => format!("{},,,,,,,\n", word(failure)),
            });
        }
    }
    text
}

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
fn columns(row: &Row, calls: Calls) -> [String; COLUMNS.len()] {
    let cell = row.ours(calls);
    let ours = cell.and_then(|cell| row.right(cell.program));
    let best = row.best(false, calls);
    let spade = row.right("spade");
    let share = |other: Option<Outcome>| match (ours, other) {
        (Some(ours), Some(other)) => {
            format!("{:.2}", ours.time(calls)[0] / other.time(calls)[0])
        }
        _ => String::new(),
    };
    let times = if row.inputs == 1 {
        String::new()
    } else {
        format!("{} x ", row.inputs)
    };
    let aim = row.aim(calls).map(|aim| match spade {
        Some(spade) => format!("{:.2}", aim / spade.time(calls)[0]),
        None => format!("{aim:.0} ns"),
    });
    [
        row.name.clone(),
        format!("{times}{}", row.size[0]),
        row.size[1].to_string(),
        best.map_or("none", |(cell, _)| cell.program).to_owned(),
        best.map_or(String::new(), |(_, outcome)| time(outcome, calls)),
        cell.map_or(String::new(), |cell| entry(cell, calls)),
        share(best.map(|(_, outcome)| outcome)),
        share(spade),
        aim.unwrap_or_default(),
        ours.map_or(String::new(), bytes),
    ]
}

/// A program's nanoseconds a point with their spread and the verdict, if that is not the best.
fn entry(cell: &Cell, calls: Calls) -> String {
    match cell.outcome {
        Ok(outcome) => match outcome.verdict {
            Verdict::Delaunay => time(outcome, calls),
            Verdict::Triangulation => format!("{}, not Delaunay", time(outcome, calls)),
            Verdict::Wrong => format!("{}, WRONG", time(outcome, calls)),
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
fn time(outcome: Outcome, calls: Calls) -> String {
    let [median, least, most] = outcome.time(calls);
    let spread = 100.0 * (median - least).max(most - median) / median;
    format!("{median:.0} ±{spread:.0} %")
}

fn bytes(outcome: Outcome) -> String {
    outcome
        .bytes
        .map_or(String::new(), |bytes| format!("{bytes:.0}"))
}

/// All programs of these rows, in the order of their first row.
pub(crate) fn programs<'a>(rows: impl Iterator<Item = &'a Row>) -> Vec<&'static str> {
    let mut programs = Vec::new();
    for cell in rows.flat_map(|row| &row.cells) {
        if !programs.contains(&cell.program) {
            programs.push(cell.program);
        }
    }
    programs
}

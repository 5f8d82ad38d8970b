//! The tables as Markdown.

use super::{COLUMNS, columns, entry, programs};
use crate::data::Kind;
use crate::measure::{Cell, Row};

/// The main table, and one of all programs for each kind of data: nanoseconds and bytes a point.
pub(crate) fn markdown(machine: &str, rows: &[Row]) -> String {
    let mut text = String::new();
    for line in machine.lines() {
        text.push_str(&format!("- {line}\n"));
    }
    text.push_str("\nNanoseconds a point are medians; after ± the largest distance from them.\n\n");
    text.push_str(&line(&COLUMNS.map(str::to_owned)));
    text.push_str(&rule(COLUMNS.len()));
    for row in rows {
        text.push_str(&line(&columns(row)));
    }
    for (kind, name) in [
        (Kind::Points, "points"),
        (Kind::Edges, "points and edges"),
        (Kind::Polygons, "polygons"),
    ] {
        let of_kind = |row: &&Row| row.kind == kind;
        table(
            &mut text,
            &format!("Nanoseconds a point, {name}"),
            rows.iter().filter(of_kind),
            entry,
        );
        table(
            &mut text,
            &format!("Bytes a point beyond the input, {name}"),
            rows.iter().filter(of_kind),
            |cell| cell.outcome.map_or(String::new(), super::bytes),
        );
    }
    text
}

/// A table of all programs.
fn table<'a>(
    text: &mut String,
    title: &str,
    rows: impl Iterator<Item = &'a Row>,
    entry: impl Fn(&Cell) -> String,
) {
    let rows: Vec<&Row> = rows.collect();
    let programs = programs(rows.iter().copied());
    if rows.is_empty() {
        return;
    }
    text.push_str(&format!("\n{title}:\n\n"));
    let names = programs.iter().map(|&name| name.to_owned());
    text.push_str(&line(
        &["data".to_owned()]
            .into_iter()
            .chain(names)
            .collect::<Vec<_>>(),
    ));
    text.push_str(&rule(programs.len() + 1));
    for row in rows {
        let entries = programs.iter().map(|program| {
            let cell = row.cells.iter().find(|cell| cell.program == *program);
            cell.map_or(String::new(), &entry)
        });
        let cells: Vec<_> = [row.name.clone()].into_iter().chain(entries).collect();
        text.push_str(&line(&cells));
    }
}

fn line(columns: &[String]) -> String {
    format!("| {} |\n", columns.join(" | "))
}

fn rule(columns: usize) -> String {
    format!("|---|{}\n", "---:|".repeat(columns - 1))
}

//! What was found, as tables in Markdown.

use std::fmt::Write;

use sweep_cdt_properties::TARGETS;

use crate::Fault;

/// How the page begins.
const HEAD: &str = "\
# Planted faults

Written by

    cd fuzz && cargo run --release -p sweep-cdt-planted-faults > ../docs/planted-faults.md

[docs/testing.md](testing.md#planted-faults) explains how the faults are planted and how to read the numbers.

## What finds what

";

/// What a target found.
#[derive(Clone, Debug)]
pub struct Find {
    /// The execution that failed, or "died" if the process ended with it.
    pub execution: String,
    /// What it said.
    pub message: String,
}

/// For each target what it found.
pub type Row = Vec<Option<Find>>;

/// The whole page: for each kind of fault a table, after one of what all kinds came to.
pub fn page(faults: &[Fault], none: &Row, rows: &[Row]) -> String {
    let kinds: Vec<(&[Fault], &[Row])> = kinds(faults, rows);
    let mut text = HEAD.to_owned();
    text += &head("kind of fault (how many)");
    for (faults, rows) in &kinds {
        let name = format!("{} ({})", faults[0].kind, faults.len());
        text += &line(&name, &counts(rows, |_| true));
    }
    let name = format!("**all ({})**", faults.len());
    text += &line(&name, &counts(rows, |_| true));
    text += &line("found by it alone", &counts(rows, |row| found(row) == 1));
    text += &line("no fault", &cells(none));
    for (faults, rows) in kinds {
        write!(text, "\n## {}\n\n", faults[0].kind).expect("memory takes it");
        text += &table(faults, rows);
    }
    text
}

/// One row for each fault.
pub fn table(faults: &[Fault], rows: &[Row]) -> String {
    let mut text = head("fault");
    for (fault, row) in faults.iter().zip(rows) {
        let name = format!("`{}`: {}", fault.name, fault.what);
        text += &line(&name, &cells(row));
    }
    text
}

/// Faults of one kind, with their rows, one kind after the other.
fn kinds<'a>(faults: &'a [Fault], mut rows: &'a [Row]) -> Vec<(&'a [Fault], &'a [Row])> {
    let mut kinds = Vec::new();
    for faults in faults.chunk_by(|a, b| a.kind == b.kind) {
        let (of_kind, others) = rows.split_at(faults.len());
        kinds.push((faults, of_kind));
        rows = others;
    }
    kinds
}

/// How many targets found a fault.
fn found(row: &Row) -> usize {
    row.iter().flatten().count()
}

/// How many faults each target found, of the rows that the function picks.
fn counts(rows: &[Row], is_asked: impl Fn(&Row) -> bool) -> Vec<String> {
    let count = |i: usize| {
        let asked = rows.iter().filter(|row| is_asked(row));
        asked.filter(|row| row[i].is_some()).count()
    };
    (0..TARGETS.len()).map(|i| count(i).to_string()).collect()
}

fn cells(row: &Row) -> Vec<String> {
    row.iter()
        .map(|find| {
            find.as_ref()
                .map_or("-".to_owned(), |find| find.execution.clone())
        })
        .collect()
}

fn head(first: &str) -> String {
    let names: Vec<String> = TARGETS.iter().map(|t| t.name.to_owned()).collect();
    line(first, &names) + "|---|" + &"---:|".repeat(TARGETS.len()) + "\n"
}

fn line(first: &str, cells: &[String]) -> String {
    format!("| {first} | {} |\n", cells.join(" | "))
}

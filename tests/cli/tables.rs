//! The tables of numbers, exactly: `--stats`, with its times masked, and the report of `verify`.
//!
//! `INSTA_UPDATE=always cargo test --test cli` writes the snapshots anew, to be read before they are
//! committed.

use std::fmt::Write;
use std::fs;

use crate::verify::verify;
use crate::{CONTOURS, FORMATS, folder, printed, run, run_with_input};

/// Where the times end: after columns for the name and the number.
const UNIT: &str = " ms ";

#[test]
fn statistics_of_a_lattice() {
    // 1,005 vertices: a number with a zero after its comma.
    let output = run_with_input("- --input-format json --stats", lattice(201, 5).as_bytes());
    assert_table("statistics_of_a_lattice", printed(&output));
}

#[test]
fn statistics_of_contours() {
    let output = run(FORMATS, &format!("{CONTOURS} --stats"));
    assert_table("statistics_of_contours", printed(&output));
}

#[test]
fn shares_of_time_are_those_of_the_times() {
    let output = run(FORMATS, &format!("{CONTOURS} --stats"));
    let rows: Vec<(&str, f64, f64)> = printed(&output).lines().filter_map(time).collect();
    let names: Vec<&str> = rows.iter().map(|(name, ..)| *name).collect();
    let phases = ["initialization", "sweeping", "finalization", "total"];
    assert_eq!(names, phases);
    let (_, total, whole) = rows[3];
    let is_whole = (whole - 100.0).abs() < 0.05;
    assert!(total > 0.0 && is_whole, "{total} ms, {whole} %");
    let sum: f64 = rows[..3].iter().map(|(_, time, _)| time).sum();
    // Times are printed to a thousandth, shares to a tenth.
    assert!((sum - total).abs() < 0.0025, "{sum} of {total} ms");
    for (name, time, share) in rows {
        let expected = 100.0 * time / total;
        let error = (share - expected).abs();
        assert!(
            error < 0.051 + 0.1 / total,
            "{name}: {share}, not {expected}"
        );
    }
}

#[test]
fn the_report_of_contours() {
    let folder = folder(&[]);
    printed(&run(&folder, &format!("{CONTOURS} -o r.json")));
    let report = verify(&folder, &format!("{CONTOURS} r.json"));
    let report = printed(&report).replace(CONTOURS, "contours.poly");
    assert_snapshot("report_of_contours", &report);
}

#[test]
fn tables_are_printed_on_demand_only() {
    let folder = folder(&[]);
    let input = format!("{FORMATS}/ten.poly");
    assert_eq!(printed(&run(&folder, &format!("{input} -o ten.svg"))), "");
    assert!(fs::exists(folder.path().join("ten.svg")).expect("a folder"));
}

/// The points of a lattice, as JSON.
fn lattice(columns: usize, rows: usize) -> String {
    let mut points = String::new();
    for x in 0..columns {
        for y in 0..rows {
            let comma = if points.is_empty() { "" } else { "," };
            write!(points, "{comma}[{x},{y}]").expect("strings grow");
        }
    }
    format!("{{\"points\":[{points}]}}")
}

/// Name, milliseconds and share of a line with a time.
fn time(line: &str) -> Option<(&str, f64, f64)> {
    let (start, share) = line.split_once(UNIT)?;
    let (name, time) = start.split_once(' ')?;
    let number = |text: &str| text.trim().parse().expect("a number");
    let share = share.strip_suffix(" %").expect("a share");
    Some((name, number(time), number(share)))
}

/// Compares a table with a snapshot in which times and their shares are masked.
fn assert_table(name: &str, table: &str) {
    let mut masked = String::new();
    for line in table.lines() {
        let text = match time(line) {
            Some((name, ..)) => {
                assert_eq!(line.find(UNIT), Some(38), "{line}");
                format!("{name:26}{:>12}{UNIT}{:>6} %", "(time)", "(..)")
            }
            None => line.to_owned(),
        };
        writeln!(masked, "{text}").expect("strings grow");
    }
    assert_snapshot(name, &masked);
}

fn assert_snapshot(name: &str, text: &str) {
    let mut settings = insta::Settings::new();
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

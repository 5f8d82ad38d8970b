//! Settings and summary; and the tables of numbers, exactly: `--stats`, with its times masked, and the report of `verify`.
//!
//! `INSTA_UPDATE=always cargo test --test cli` writes the snapshots anew, to be read before they are
//! committed.

use std::fmt::Write;
use std::fs;

use crate::verify::verify;
use crate::{
    CONTOURS, FORMATS, folder, printed, printed_despite_losses, printed_without_triangles, run,
    run_with_input,
};

#[test]
fn inputs_without_triangles_are_no_errors() {
    let inputs = [
        (r#"{"points":[]}"#, "points 0, duplicates 0, edges 0"),
        (
            r#"{"points":[[1,2],[1,2]],"edges":[[0,1]]}"#,
            "points 2, duplicates 1, edges 1",
        ),
        (
            r#"{"points":[[0,0],[1,1],[5,5]],"edges":[[0,2]]}"#,
            "points 3, duplicates 0, edges 1",
        ),
        (
            r#"{"points":[[-1.7e308,0],[1.7e308,0]]}"#,
            "points 2, duplicates 0, edges 0",
        ),
    ];
    for (input, counts) in inputs {
        let output = run_with_input("- --input-format json", input.as_bytes());
        assert_eq!(
            printed_without_triangles(&output),
            format!("standard input: {counts}, triangles 0, hull 0\n")
        );
        for format in ["ele", "json", "obj", "svg"] {
            let output = run_with_input(
                &format!("- --input-format json -o - --output-format {format}"),
                input.as_bytes(),
            );
            let shown = printed_without_triangles(&output);
            assert!(!shown.contains("NaN"), "{format} of {input}");
        }
    }
}

#[test]
fn settings_change_no_byte() {
    let settings = [
        "--front skip-list",
        "--front linear",
        "--scalar rational",
        "--heuristics paper",
        "--heuristics off",
        "--no-narrow-corners",
        "--no-basins",
        "--no-narrow-corners --no-basins --front skip-list --scalar rational",
    ];
    let all = ["ele", "json", "obj", "svg"].as_slice();
    for (input, formats) in [
        ("ten.poly", all),
        ("thirds.json", all),
        (CONTOURS, &["json"]),
    ] {
        for format in formats {
            let run = |more: &str| {
                run(
                    FORMATS,
                    &format!("{input} -o - --output-format {format} {more}"),
                )
            };
            let expected = run("");
            for more in settings {
                assert!(
                    printed_despite_losses(&run(more)) == printed_despite_losses(&expected),
                    "{input} to {format} {more}"
                );
            }
        }
    }
}

/// Enough points for several bands, and every other piece of a path through all of them.
#[test]
fn threads_change_no_byte() {
    const N: u64 = 120_000;
    let point = |i: u64| format!("[{},{i}]", i * i % 307);
    let list = |text: Vec<String>| text.join(",");
    let points = list((0..N).map(point).collect());
    let edges = list(
        (0..N / 2)
            .map(|i| format!("[{},{}]", 2 * i, 2 * i + 1))
            .collect(),
    );
    let input = format!(r#"{{"points":[{points}],"edges":[{edges}]}}"#);
    let run = |more: &str| {
        let arguments = "- --input-format json -o - --output-format json";
        run_with_input(&format!("{arguments} {more}"), input.as_bytes())
    };
    let expected = run("--threads 1");
    // Of 100,000 threads most are of no use, and are not started.
    for more in ["", "--threads 2", "--threads 3", "--threads 100000"] {
        assert!(printed(&run(more)) == printed(&expected), "{more}");
    }
}

/// The number in a row of `--stats`.
fn row(settings: &str, name: &str) -> u64 {
    let output = run(
        FORMATS,
        &format!("{CONTOURS} --stats --heuristics paper {settings}"),
    );
    let number = |line: &str| {
        let numbers = line.strip_prefix(name)?;
        let first = numbers.split_whitespace().next()?;
        first.replace(',', "").parse().ok()
    };
    let found = printed(&output).lines().find_map(number);
    found.expect("a row of that name")
}

#[test]
fn each_setting_is_heeded() {
    for (setting, name) in [
        ("--no-narrow-corners", "  narrow corners"),
        ("--no-basins", "  basins"),
        ("--front skip-list", "front steps"),
    ] {
        assert!(row("", name) > 0, "{name}");
        assert_eq!(row(setting, name), 0, "{setting}");
    }
}

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

//! Plants the faults, builds the targets, and reports how many executions each target needs for each fault.
//!
//! In `fuzz`, `cargo run --release -p sweep-cdt-planted-faults > planted-faults.md` writes the page
//! of all faults. With words as arguments, the command prints the faults whose names contain one of them.
//!
//! Each target gets [`FEW`] executions for each fault. If none has found it by then, one target after the
//! other gets [`MANY`] until one finds it. For the page, each target also gets [`MANY`] executions of the
//! crate without a fault and must not fail. The command fails if a target does, or if a fault is not found.

use std::env;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::sync::Mutex;
use std::thread;

use sweep_cdt_planted_faults::{CHOICE, Fault, copy, faults, root};
use sweep_cdt_properties::{TARGETS, Target, seeds};

/// Executions for each fault and target.
const FEW: u64 = 4_000;
/// Executions for a fault that is hard to find.
const MANY: u64 = 100_000;

fn main() -> ExitCode {
    let words: Vec<String> = env::args().skip(1).collect();
    let runner = build();
    let is_asked =
        |fault: &Fault| words.is_empty() || words.iter().any(|word| fault.name.contains(word));
    let numbered = faults().into_iter().enumerate();
    let (numbers, faults): (Vec<usize>, Vec<Fault>) =
        numbered.filter(|(_, fault)| is_asked(fault)).unzip();
    let numbers = numbers.into_iter();
    // What takes longest comes first.
    let no_fault = words.is_empty().then_some(None);
    let jobs: Vec<Option<usize>> = no_fault.into_iter().chain(numbers.map(Some)).collect();
    let mut rows = in_parallel(&jobs, |number| {
        let row = row(&runner, number);
        eprintln!("fault {number:?}:\n{}", messages(&row));
        row
    });
    let none = no_fault.map(|_| rows.remove(0));
    let mut is_good = rows.iter().all(|row| row.iter().any(Option::is_some));
    if let Some(none) = none {
        is_good &= none.iter().all(Option::is_none);
        print!("{}", page(&faults, &none, &rows));
    } else {
        print!("{}", table(&faults, &rows));
    }
    if is_good {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// Makes a row for each fault, and one for none, as many at a time as the machine has cores.
fn in_parallel(numbers: &[Option<usize>], make: impl Fn(Option<usize>) -> Row + Sync) -> Vec<Row> {
    let left = Mutex::new(numbers.iter().enumerate());
    let done = Mutex::new(vec![Row::new(); numbers.len()]);
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let next = left.lock().expect("no panic").next();
                    let Some((place, &number)) = next else { break };
                    let row = make(number);
                    done.lock().expect("no panic")[place] = row;
                }
            });
        }
    });
    done.into_inner().expect("no panic")
}

/// The finds of each target with a fault, or without one.
fn row(runner: &Path, number: Option<usize>) -> Row {
    let run = |target: &Target, executions| run(runner, number, target.name, executions);
    let mut row: Row = TARGETS.iter().map(|target| run(target, FEW)).collect();
    if row.iter().all(Option::is_none) {
        let mut places = row.iter_mut().zip(TARGETS);
        places.any(|(find, target)| {
            *find = run(target, MANY);
            find.is_some()
        });
    }
    row
}

/// The finds of each target.
fn messages(row: &Row) -> String {
    let found = TARGETS.iter().zip(row);
    found
        .filter_map(|(target, find)| Some((target.name, find.as_ref()?)))
        .map(|(name, find)| format!("  {name}, {}: {}\n", find.execution, find.message))
        .collect()
}

/// Makes the copy with the faults and builds it.
fn build() -> PathBuf {
    let folder = root().join("fuzz/target/planted-faults");
    let target = folder.join("target");
    std::fs::create_dir_all(folder.join("fuzz")).expect("a folder for the copy");
    copy(&folder, &faults()).expect("a copy with all faults");
    let status = Command::new(env!("CARGO"))
        .args(["build", "--locked", "--profile", "planted"])
        .args([
            "--package",
            "sweep-cdt-planted-faults",
            "--bin",
            "executions",
        ])
        .arg("--target-dir")
        .arg(&target)
        .current_dir(folder.join("fuzz"))
        .status();
    assert!(
        status.is_ok_and(|status| status.success()),
        "the copy does not build"
    );
    target.join("planted/executions")
}

/// Runs a target until it fails; without a number the crate has no fault.
fn run(runner: &Path, fault: Option<usize>, target: &str, executions: u64) -> Option<Find> {
    let mut command = Command::new(runner);
    if let Some(number) = fault {
        command.env(CHOICE, number.to_string());
    }
    let output = command
        .args([target, &executions.to_string()])
        .arg(seeds::path(target))
        .stderr(Stdio::null())
        .output()
        .expect("the runner starts");
    let line = String::from_utf8_lossy(&output.stdout);
    if line.trim() == "none" {
        return None;
    }
    let mut words = line.trim().splitn(3, ' ').skip(1).map(str::to_owned);
    Some(Find {
        execution: words.next().unwrap_or_else(|| "died".to_owned()),
        message: words.next().unwrap_or_default(),
    })
}

/// How the page begins.
const HEAD: &str = "\
# Planted faults

Written by

    cd fuzz && cargo run --release -p sweep-cdt-planted-faults > planted-faults.md

docs/testing.md explains how the faults are planted and how to read the numbers.

## What finds what

";

/// A find of a target.
#[derive(Clone, Debug)]
struct Find {
    /// The execution that failed, or "died" if the process ended with it.
    execution: String,
    /// The message.
    message: String,
}

/// For each target what it found.
type Row = Vec<Option<Find>>;

/// The whole page in Markdown: for each kind of fault a table, after one of what all kinds came to.
fn page(faults: &[Fault], none: &Row, rows: &[Row]) -> String {
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
fn table(faults: &[Fault], rows: &[Row]) -> String {
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

//! Plants the faults, builds the targets, and prints how many executions each target needs for each
//! fault: `cargo run --release -p sweep-cdt-nursery [NAME ...]`, in `fuzz`, for all faults or for those
//! whose names contain one of the words.
//!
//! Each target gets [`FEW`] executions for each fault; a fault that none has found then gets [`MANY`].
//! The first row is the crate without a fault, which gets [`MANY`] and must not fail. The command fails
//! if that does, or if a fault is not found at all.

use std::env;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};

use sweep_cdt_nursery::{CHOICE, copy, faults, root};
use sweep_cdt_properties::TARGETS;

/// Executions for each fault and target.
const FEW: u64 = 10_000;
/// Executions for a fault that is hard to find.
const MANY: u64 = 100_000;

fn main() -> ExitCode {
    let words: Vec<String> = env::args().skip(1).collect();
    let runner = build();
    let faults = faults();
    println!(
        "| fault | {} |",
        TARGETS
            .iter()
            .map(|t| t.name)
            .collect::<Vec<_>>()
            .join(" | ")
    );
    println!("|---|{}", "---:|".repeat(TARGETS.len()));

    let mut is_good = true;
    if words.is_empty() {
        let found = TARGETS
            .iter()
            .map(|target| run(&runner, None, target.name, MANY));
        let found: Vec<_> = found.collect();
        print("(none)", &found);
        is_good = found.iter().all(Option::is_none);
    }
    for (number, fault) in faults.iter().enumerate() {
        if !words.is_empty() && !words.iter().any(|word| fault.name.contains(word)) {
            continue;
        }
        let run = |executions| -> Vec<Option<Find>> {
            let each = TARGETS.iter();
            each.map(|target| run(&runner, Some(number), target.name, executions))
                .collect()
        };
        let mut found = run(FEW);
        if found.iter().all(Option::is_none) {
            found = run(MANY);
        }
        print(&fault.name, &found);
        is_good &= found.iter().any(Option::is_some);
    }
    if is_good {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// What a target found.
struct Find {
    executions: String,
    message: String,
}

/// Prints a row of the table, and on the error stream what the finds were.
fn print(name: &str, found: &[Option<Find>]) {
    let cells: Vec<&str> = found
        .iter()
        .map(|find| find.as_ref().map_or("-", |find| &find.executions))
        .collect();
    println!("| {name} | {} |", cells.join(" | "));
    for (target, find) in TARGETS.iter().zip(found) {
        if let Some(Find { message, .. }) = find {
            eprintln!("{name}, {}: {message}", target.name);
        }
    }
}

/// Makes the copy with the faults and builds it.
fn build() -> PathBuf {
    let folder = root().join("fuzz/target/nursery");
    let target = folder.join("target");
    std::fs::create_dir_all(folder.join("fuzz")).expect("a folder for the copy");
    copy(&folder, &faults()).expect("a copy with all faults");
    let status = Command::new(env!("CARGO"))
        .args(["build", "--locked", "--profile", "nursery"])
        .args(["--package", "sweep-cdt-nursery", "--bin", "executions"])
        .arg("--target-dir")
        .arg(&target)
        .current_dir(folder.join("fuzz"))
        .status();
    assert!(
        status.is_ok_and(|status| status.success()),
        "the copy does not build"
    );
    target.join("nursery/executions")
}

/// Runs a target until it fails; without a number the crate has no fault.
fn run(runner: &Path, fault: Option<usize>, target: &str, executions: u64) -> Option<Find> {
    let mut command = Command::new(runner);
    if let Some(number) = fault {
        command.env(CHOICE, number.to_string());
    }
    let output = command
        .args([target, &executions.to_string()])
        .arg(root().join("fuzz/seeds").join(target))
        .stderr(Stdio::null())
        .output()
        .expect("the runner starts");
    let line = String::from_utf8_lossy(&output.stdout);
    if line.trim() == "none" {
        return None;
    }
    let mut words = line.trim().splitn(3, ' ').skip(1).map(str::to_owned);
    Some(Find {
        executions: words.next().unwrap_or_else(|| "died".to_owned()),
        message: words.next().unwrap_or_default(),
    })
}

//! On what, with what and when a run measures.

use std::fs;
use std::process::Command;

use crate::programs::Program;

/// A few lines: date, machine, compiler, programs with their versions, rounds, arguments.
pub(crate) fn describe(programs: &[Program], rounds: usize) -> String {
    let mut versions = Vec::new();
    for program in programs {
        let version = format!("{} {}", program.name, program.version);
        if !versions.contains(&version) {
            versions.push(version);
        }
    }
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    [
        format!("Date: {}", output("date", &["-u", "+%Y-%m-%d"])),
        format!("Machine: {}, {cores} cores", processor()),
        format!(
            "Compilers: {}; {}",
            output("rustc", &["-V"]),
            output("c++", &["--version"])
        ),
        format!("Programs: {}", versions.join(", ")),
        format!("Rounds: {rounds}; arguments: {}", arguments.join(" ")),
    ]
    .join("\n")
}

/// The first line that a command prints.
fn output(command: &str, arguments: &[&str]) -> String {
    let output = Command::new(command).args(arguments).output();
    let bytes = output.map(|output| output.stdout).unwrap_or_default();
    let text = String::from_utf8_lossy(&bytes);
    text.lines().next().unwrap_or("unknown").to_owned()
}

fn processor() -> String {
    let text = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = text
        .lines()
        .find_map(|line| line.strip_prefix("model name"));
    name.map_or("unknown processor".to_owned(), |name| {
        name.trim_start_matches([' ', '\t', ':']).to_owned()
    })
}

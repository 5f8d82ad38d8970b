//! How many instructions a triangulation takes, against the numbers of the last recording.
//!
//! `cargo bench -p sweep-cdt-benches --bench instructions` fails if one differs by more than 2 % from benches/instructions.txt;
//! `-- --record` writes that file anew. Instructions are counted by `valgrind`, without which the check says so
//! and passes: first for a process that only makes the input, then for one that triangulates it too. The
//! difference varies by less than 0.1 %.
//!
//! The counts depend on the compiler, on the machine's instructions and a little on the system's library. These stand
//! in the first lines of the file; where they are others, the counts are printed and nothing is compared.

use std::fs;
use std::hint::black_box;
use std::process::{Command, ExitCode};

use sweep_cdt_testing::{Input, clouds, data, segments};

/// By how much a count may differ.
const TOLERANCE: f64 = 0.02;

const FILE: &str = "benches/instructions.txt";

/// Makes an input.
type Make = fn() -> Input;

const INPUTS: [(&str, Make); 6] = [
    ("uniform", || clouds::uniform(100_000)),
    ("clusters", || clouds::clusters(100_000)),
    ("contours", data::contours),
    ("lattice", || clouds::shuffled_lattice(100_000)),
    ("circle", || clouds::circle(100_000)),
    ("segments", || segments(100_000)),
];

fn main() -> ExitCode {
    // Cargo itself adds an argument, `--bench`.
    let arguments = std::env::args().skip(1);
    let arguments: Vec<String> = arguments.filter(|text| text != "--bench").collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => check(false),
        ["--record"] => check(true),
        ["run", name, times] => {
            run(name, times.parse().expect("a number"));
            ExitCode::SUCCESS
        }
        _ => panic!("unknown arguments: {arguments:?}"),
    }
}

/// The work that is counted: makes an input, and triangulates it so many times.
fn run(name: &str, times: usize) {
    let input = INPUTS.iter().find(|(other, _)| *other == name);
    let input = input.expect("an input").1();
    for _ in 0..times {
        let result = sweep_cdt::triangulate(&input.points, &input.edges);
        black_box(result.expect("a valid input"));
    }
}

fn check(is_recording: bool) -> ExitCode {
    let Some(place) = place() else {
        println!("not checked: there is no valgrind");
        return ExitCode::SUCCESS;
    };
    let path = data::path(FILE);
    let recorded = fs::read_to_string(&path).unwrap_or_default();
    let is_compared = !is_recording && recorded.starts_with(&place);
    let mut text = place.clone();
    let mut is_good = true;
    for (name, _) in INPUTS {
        let count = count(name, 1) - count(name, 0);
        text.push_str(&format!("{name} {count}\n"));
        let old = recorded
            .lines()
            .find_map(|line| line.strip_prefix(name)?.trim().parse::<f64>().ok());
        let change = old.map_or(f64::NAN, |old| count as f64 / old - 1.0);
        println!("{name:10} {count:>12} {:>+7.2} %", 100.0 * change);
        is_good &= change.abs() <= TOLERANCE;
    }
    if is_recording {
        fs::write(path, text).expect("a file for the counts");
    } else if !is_compared {
        println!("not checked: {FILE} was recorded elsewhere; here it would begin\n{place}");
    } else if !is_good {
        println!(
            "more than 2 % from {FILE}; if it is meant: cargo bench -p sweep-cdt-benches --bench instructions -- --record"
        );
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}

/// The instructions of a process that triangulates an input so many times.
fn count(name: &str, times: usize) -> u64 {
    let this = std::env::current_exe().expect("this program");
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(this)
        .args(["run", name, &times.to_string()])
        .output()
        .expect("valgrind");
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{text}");
    let count = text
        .lines()
        .find_map(|line| line.split_once("Collected : "));
    let count = count.and_then(|(_, count)| count.trim().parse().ok());
    count.unwrap_or_else(|| panic!("no count of instructions in\n{text}"))
}

/// The place of the counts, a line each for the compiler, the machine, the system's library and valgrind; none without
/// valgrind.
fn place() -> Option<String> {
    let valgrind = first_line("valgrind", "--version")?;
    let compiler = first_line("rustc", "--version").unwrap_or_default();
    let library = first_line("ldd", "--version").unwrap_or_default();
    let machine = std::env::consts::ARCH;
    Some(format!(
        "# {compiler}\n# {machine}{}\n# {library}\n# {valgrind}\n",
        extensions()
    ))
}

/// The extensions that the libraries choose their code by, as far as valgrind has them.
fn extensions() -> &'static str {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") {
        return " with avx2";
    }
    ""
}

/// The first line that a command prints, if there is such a command.
fn first_line(command: &str, argument: &str) -> Option<String> {
    let output = Command::new(command).arg(argument).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    text.lines().next().map(str::to_owned)
}

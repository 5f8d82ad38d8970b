//! sweep-cdt beside other programs, on the same inputs, in one run.
//!
//! ```sh
//! cargo run --release --manifest-path benches/peers/Cargo.toml -- [--quick] [--data FOLDER] [--output FOLDER]
//! ```
//!
//! Every program runs on every data set in processes of its own, in turn with the others, and the medians
//! count. A process triangulates its data set three times: the first call gets its memory from the system, the
//! last one may have what the others had. What is timed is the call that triangulates; reading the input, bringing it
//! into the program's types and asking for its triangles are not. The verifier judges one answer of each program on
//! each data set: the last one of its first process. A wrong answer, a crash and a run beyond the time limit are marked.
//!
//! `--quick` takes smaller inputs and fewer rounds. `--data` names a folder with further `.poly` files, which
//! may be compressed with gzip. The tables are printed; as Markdown and CSV, and with a plot, they are
//! written to the folder `--output`.

mod cgal;
mod crates;
mod data;
mod measure;
mod plot;
mod programs;
mod report;
mod serve;

use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::time::Duration;

use clap::{Parser, Subcommand};

use crate::programs::Program;

/// sweep-cdt beside other programs, whose answers are verified.
#[derive(Parser)]
struct Arguments {
    /// Smaller inputs and fewer rounds: about two minutes.
    #[arg(long)]
    quick: bool,
    /// A folder with further `.poly` and `.poly.gz` files.
    #[arg(long, value_name = "FOLDER")]
    data: Option<PathBuf>,
    /// Where the tables and the plot are written.
    #[arg(long, value_name = "FOLDER", default_value = "target/peers")]
    output: PathBuf,
    /// How often each program runs on each data set.
    #[arg(long)]
    rounds: Option<usize>,
    /// How often a process triangulates its data set.
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u8).range(1..))]
    calls: u8,
    /// How many seconds a process may take.
    #[arg(long, default_value_t = 60)]
    limit: u64,
    /// Only data sets whose names contain this.
    #[arg(long, value_name = "WORD", default_value = "")]
    only: String,
    /// The Python that imports `triangle`.
    #[arg(long, default_value = "python3")]
    python: PathBuf,
    #[command(subcommand)]
    cell: Option<Cell>,
}

/// The tasks of one process.
#[derive(Subcommand)]
enum Cell {
    /// Answers the questions of sweep-cdt-judge by one crate, line by line.
    Serve {
        /// The crate: spade, delaunator, cdt, ghx, "cdt inside", ...
        program: String,
    },
    /// Runs one program on one data set.
    #[command(hide = true)]
    Cell {
        program: String,
        input: PathBuf,
        calls: usize,
        answer: Option<PathBuf>,
    },
}

fn main() {
    let arguments = Arguments::parse();
    match arguments.cell {
        Some(Cell::Cell {
            program,
            input,
            calls,
            answer,
        }) => return programs::run(&program, &input, calls, answer.as_deref()),
        Some(Cell::Serve { program }) => {
            return serve::serve(&program).expect("questions as lines of JSON");
        }
        None => {}
    }
    let folder = tempfile::tempdir().expect("a folder for temporary files");
    let programs = programs::all(folder.path(), &arguments.python);
    let settings = measure::Settings {
        rounds: arguments
            .rounds
            .unwrap_or(if arguments.quick { 3 } else { 5 }),
        calls: usize::from(arguments.calls),
        limit: Duration::from_secs(arguments.limit),
        folder: folder.path(),
    };
    let machine = describe(&programs, settings.rounds);
    println!("{machine}");

    let mut rows = Vec::new();
    for set in data::sets(arguments.quick, arguments.data.as_deref()) {
        if set.name.contains(&arguments.only) {
            let row = measure::row(set, &programs, &settings);
            print!("{}", report::text(&row, rows.is_empty()));
            rows.push(row);
        }
    }
    fs::create_dir_all(&arguments.output).expect("a folder for the tables");
    let write = |name: &str, text: String| {
        fs::write(arguments.output.join(name), text).expect("a file of results");
    };
    write("peers.md", report::markdown(&machine, &rows));
    write("peers.csv", report::csv(&rows));
    write("peers.svg", plot::plot(&rows));
}

/// On what, with what and when a run measures, in a few lines: date, machine, compiler, programs with their versions, rounds, arguments.
fn describe(programs: &[Program], rounds: usize) -> String {
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

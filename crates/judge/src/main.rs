//! The command `sweep-cdt-judge`: is a program right, in any language?
//!
//! A program reads a line of JSON for each question and writes one (`docs/judging.md`). `campaign` asks many questions
//! within the program's claims and makes what is wrong small; `ask` asks one; `suite` asks those of the suite of
//! conformance; `cases` makes that suite.
//!
//! Exit status: 0 without findings, 1 with some, 2 for wrong usage and where the program cannot be started.

mod ask;
mod campaign;
mod cases;
mod claims;
mod findings;
mod process;
mod suite;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// Judges a program that triangulates: it reads a line of JSON for each question, and writes a line with the answer.
#[derive(Parser)]
#[command(name = "sweep-cdt-judge", version, max_term_width = 100)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Campaign(campaign::Campaign),
    Ask(ask::Ask),
    Suite(suite::Suite),
    Cases(cases::Cases),
}

fn main() -> ExitCode {
    // Whether nothing was found, or why the command could not be run.
    let ending = match Cli::parse().command {
        Command::Campaign(command) => command.run(),
        Command::Ask(command) => command.run(),
        Command::Suite(command) => command.run(),
        Command::Cases(command) => command.run(),
    };
    match ending {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
    }
}

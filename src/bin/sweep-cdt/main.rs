//! The command `sweep-cdt`: one file a subcommand, and what they share.
//!
//! Exit status: 0; 1 with one `error:` line where the input is wrong or a file cannot be read or
//! written, or with a report where a result is not correct; 2 for wrong usage. A reader that closes
//! its end of the pipe early ends the run quietly.

mod certificate;
mod replay;
mod shared;
mod statistics;
mod trace;
mod triangulate;
mod verify;

use std::io::{self, Write};
use std::process::ExitCode;

use clap::{CommandFactory, Parser, Subcommand};

use shared::failure::Failure;

/// Exact constrained Delaunay triangulation by a sweep line.
///
/// Reads points and edges in the plane and finds their constrained Delaunay triangulation, or verifies
/// one made by any program. All decisions are exact: every finite input without crossing edges has one
/// result, the same for all settings.
#[derive(Parser)]
#[command(name = "sweep-cdt", version, max_term_width = 100)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Triangulate(triangulate::Triangulate),
    Verify(verify::Verify),
    Trace(trace::Trace),
    Replay(replay::Replay),
}

fn main() -> ExitCode {
    let outcome = match Cli::parse().command {
        Command::Triangulate(command) => command.run(),
        Command::Verify(command) => command.run(),
        Command::Trace(command) => command.run(),
        Command::Replay(command) => command.run(),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure::Usage(message)) => Cli::command()
            .error(clap::error::ErrorKind::ValueValidation, message)
            .exit(),
        Err(Failure::Error(message)) => {
            // If standard error is closed, the message has no reader.
            let _ = writeln!(
                io::stderr(),
                "error: {}",
                message.replace(['\n', '\r'], " ")
            );
            ExitCode::FAILURE
        }
        Err(Failure::Wrong) => ExitCode::FAILURE,
    }
}

//! The command `sweep-cdt`: its subcommands, and what they share.
//!
//! Exit status: 0; 1 with one `error:` line where the input is wrong or a file cannot be read or written,
//! or with a report where a result is not correct or edges cross; 2 for wrong usage, which includes outputs that
//! would overwrite what they must not; 3 where a result is right but for what --max-depth allows. A signal ends the
//! run as it would have done by itself, after one `error:` line. A reader that closes its end of the pipe early ends
//! it quietly.

mod advice;
mod bounded;
mod completed;
mod contours;
mod crossings;
mod generate;
mod heights;
mod mesh;
mod record;
mod refine;
mod replay;
mod shared;
mod stream;
mod trace;
mod triangulate;
mod verify;
mod voronoi;

use std::io::{self, Write};
use std::process::ExitCode;

use clap::{CommandFactory, Parser, Subcommand};

use shared::failure::{Failure, printable, printable_lines, wait_for_signals};

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
    Stream(stream::StreamCommand),
    Join(stream::Join),
    Refine(refine::Refine),
    Voronoi(voronoi::Voronoi),
    Crossings(crossings::Crossings),
    Contours(contours::Contours),
    Heights(heights::Heights),
    Trace(trace::Trace),
    Replay(replay::Replay),
    Generate(generate::Generate),
}

fn main() -> ExitCode {
    wait_for_signals();
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => return refused(&error),
    };
    let (name, outcome) = match cli.command {
        Command::Triangulate(command) => ("triangulate", command.run()),
        Command::Verify(command) => ("verify", command.run()),
        Command::Stream(command) => ("stream", command.run()),
        Command::Join(command) => ("join", command.run()),
        Command::Refine(command) => ("refine", command.run()),
        Command::Voronoi(command) => ("voronoi", command.run()),
        Command::Crossings(command) => ("crossings", command.run()),
        Command::Contours(command) => ("contours", command.run()),
        Command::Heights(command) => ("heights", command.run()),
        Command::Trace(command) => ("trace", command.run()),
        Command::Replay(command) => ("replay", command.run()),
        Command::Generate(command) => ("generate", command.run()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure::Usage(message)) => wrong_usage(name, &message),
        Err(Failure::Error(message)) => {
            // If standard error is closed, the message has no reader.
            let _ = writeln!(io::stderr(), "error: {}", printable(&message));
            ExitCode::FAILURE
        }
        Err(Failure::Wrong) => ExitCode::FAILURE,
        Err(Failure::Rounded) => ExitCode::from(3),
    }
}

/// Ends with arguments of a subcommand that do not fit together.
fn wrong_usage(subcommand: &str, message: &str) -> ExitCode {
    let mut cli = Cli::command();
    cli.build();
    let command = cli
        .find_subcommand_mut(subcommand)
        .expect("the subcommand that ran");
    let message = printable(message);
    refused(&command.error(clap::error::ErrorKind::ValueValidation, message))
}

/// Ends with arguments that were not understood, or with the help.
fn refused(error: &clap::Error) -> ExitCode {
    let text = printable_lines(&error.to_string());
    // If the stream is closed, the text has no reader.
    let _ = if error.use_stderr() {
        write!(io::stderr(), "{text}")
    } else {
        write!(io::stdout(), "{text}")
    };
    ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2))
}

//! The program: its arguments, the structures that take part, and errors as lines for the user.

use std::error::Error;
use std::ffi::OsString;
use std::process::ExitCode;

use clap::Parser;

use crate::command::{self, Command};
use crate::{Contestant, standard};

/// Runs the program, with these structures beside the standard ones: in every count, table and plot of the
/// experiments that compare structures.
///
/// ```no_run
/// use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch};
/// use sweep_cdt_experiments::{Contestant, fronts::Structure, main_with};
///
/// /// Starts at the right end.
/// #[derive(Clone)]
/// struct RightEnd;
///
/// impl FrontSearch for RightEnd {
///     fn begin(&mut self, _: FrontInput<'_>) {}
///
///     fn locate(&mut self, _x: f64, front: &Front) -> FrontNode {
///         front.right_end()
///     }
/// }
///
/// impl Structure for RightEnd {}
///
/// main_with([Contestant::new("from the right end", RightEnd).linear()]);
/// ```
pub fn main_with(own: impl IntoIterator<Item = Contestant>) -> ExitCode {
    match run(own, std::env::args_os()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// The program with arguments of your own, the name of the program first.
///
/// # Errors
/// Each is a line for the user. Arguments that cannot be understood, and `--help`, end the program.
pub fn run(
    own: impl IntoIterator<Item = Contestant>,
    arguments: impl IntoIterator<Item = impl Into<OsString> + Clone>,
) -> Result<(), Box<dyn Error>> {
    let mut contestants = standard();
    contestants.extend(own);
    let names = |i: usize| contestants[i].name();
    let twice = (0..contestants.len()).find(|&i| (0..i).any(|j| names(i) == names(j)));
    if let Some(i) = twice {
        return Err(format!("two structures have the name {}", names(i)).into());
    }
    command::run(Command::parse_from(arguments), &contestants)
}

//! Experiments with search structures for the advancing front of the sweep-line algorithm of Domiter and
//! Žalik (2008), and with its heuristics, phases and scalars.
//!
//! ```sh
//! cargo run --release -p sweep-cdt-experiments -- fronts --quick
//! ```
//!
//! An experiment is a list of *cells*: an input of a kind and a size. A cell runs all its *variants*
//! (structures, settings of the heuristics, algorithms, scalars) on that input: once to count, and then
//! several times in turn for the time. Each variant gives a row. All rows make a CSV file, a report in
//! Markdown, and plots.
//!
//! [`main_with`] runs the same program with structures of your own beside the others.

mod command;
mod contestant;
mod experiments;
pub mod fronts;
mod measure;
mod plan;
mod report;

use std::error::Error;
use std::ffi::OsString;
use std::process::ExitCode;

use clap::Parser;
pub use contestant::{Contestant, standard};

/// Runs the program, with these structures beside the standard ones: in every count, table and plot of the
/// experiments that compare structures.
///
/// ```no_run
/// use sweep_cdt::front::{Front, FrontNode, FrontSearch};
/// use sweep_cdt_experiments::{Contestant, fronts::Structure, main_with};
///
/// /// Starts at the right end.
/// #[derive(Clone)]
/// struct RightEnd;
///
/// impl FrontSearch for RightEnd {
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

/// The same with arguments of your own, the name of the program first.
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
    command::run(command::Command::parse_from(arguments), &contestants)
}

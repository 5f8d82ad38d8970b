//! Experiments with search structures for the advancing front of the sweep-line algorithm of Domiter and
//! Žalik (2008), and with its heuristics, phases and scalars.
//!
//! ```sh
//! cargo run --release -p sweep-cdt-experiments -- fronts --quick
//! ```
//!
//! An experiment is a list of *cells*: an input of a kind, a size and a seed. A cell runs all its *variants*
//! (structures, settings of the heuristics, algorithms, scalars) on that input: once to count, and then
//! several times in turn for the time. Each variant gives a row of counts and a row for each turn. All rows make two
//! CSV files, a report in Markdown, and plots. `crates/experiments/reproduce` runs all of it and makes the paper.
//!
//! [`main_with`] runs the same program with structures of your own beside the others. Without the feature
//! `program`, which is on by default, the crate has the structures alone.

mod contestant;
pub mod fronts;

#[cfg(feature = "program")]
mod command;
#[cfg(feature = "program")]
mod experiments;
#[cfg(feature = "program")]
mod measure;
#[cfg(feature = "program")]
mod plan;
#[cfg(feature = "program")]
mod program;
#[cfg(feature = "program")]
mod report;
#[cfg(feature = "program")]
mod study;

pub use contestant::{Contestant, standard};
#[cfg(feature = "program")]
pub use program::{main_with, run};

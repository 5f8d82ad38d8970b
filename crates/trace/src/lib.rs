//! Traces of runs of [`sweep_cdt`]: the steps of a run as a [`Trace`], written, read back, checked and replayed.
//!
//! As text a trace has a header, `sweep-cdt trace 3` with the version, and then a line for each step
//! ([`sweep_cdt::trace`]). The header of a part of a trace says at which step it begins: `from step 120`. As JSON Lines it
//! has an object for each step ([`write_trace`]).

mod bad_trace;
mod json;
mod replay;
mod text;
mod trace;

pub use bad_trace::{BadTrace, VERSION};
pub use json::{read_trace, write_trace};
pub use trace::Trace;

/// The example of the README, as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

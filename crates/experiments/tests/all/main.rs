//! The structures and the experiments.

mod growth;
mod program;
mod structures;

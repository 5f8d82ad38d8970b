//! The structures and the experiments.

mod growth;
mod paper;
mod program;
mod structures;

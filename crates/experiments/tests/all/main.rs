//! The structures and the experiments.

mod program;
mod structures;

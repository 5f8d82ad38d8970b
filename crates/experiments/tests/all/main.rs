//! The structures and the experiments.

mod paper;
mod program;
mod structures;

//! The structures, the data and the experiments.

mod data;
mod program;
mod structures;

//! The structures, the data and the experiments.

mod alone;
mod data;
mod program;
mod steps;

//! The experiments: which cells, which variants, and what is shown of their rows.

mod experiment;
mod paper;
mod settings;
mod structures;

pub(crate) use experiment::{Experiment, cells};

/// All experiments.
pub(crate) const ALL: &[Experiment] = &[
    structures::FRONTS,
    settings::HEURISTICS,
    paper::TABLE_1,
    paper::TABLE_2,
    settings::SCALARS,
    structures::SCALING,
    structures::ADVERSARIES,
];

//! The experiments: which cells, which variants, and what is shown of their rows.

mod adversaries;
mod experiment;
mod fronts;
mod heuristics;
mod scalars;
mod scaling;
mod table1;
mod table2;

pub(crate) use experiment::{Experiment, cells};

/// All experiments.
pub(crate) const ALL: &[Experiment] = &[
    fronts::FRONTS,
    heuristics::HEURISTICS,
    table1::TABLE_1,
    table2::TABLE_2,
    scalars::SCALARS,
    scaling::SCALING,
    adversaries::ADVERSARIES,
];

//! The experiments: which cells, which variants, and what is shown of their rows.

mod paper;
mod settings;
mod structures;

use std::ops::RangeInclusive;

use sweep_cdt_generate::Kind;

use crate::contestant::Contestant;
use crate::measure::{Cell, Row, Source, Variant};
use crate::report::{Shape, View};

pub(crate) use paper::{TABLE_1, TABLE_2};
pub(crate) use settings::{HEURISTICS, SCALARS};
pub(crate) use structures::{ADVERSARIES, FRONTS, HOLD_OUT, SCALING};

/// An experiment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Experiment {
    pub(crate) name: &'static str,
    /// The question, as a sentence.
    pub(crate) about: &'static str,
    /// The experiment's cells: all, or a few small ones that take less than a minute.
    pub(crate) cells: fn(quick: bool) -> Vec<Cell>,
    pub(crate) variants: fn(&[Contestant]) -> Vec<Variant>,
    pub(crate) views: &'static [View],
    /// Further text of the report, from all rows.
    pub(crate) remarks: fn(&[Row]) -> String,
}

/// The time, compared with that of the first variant.
const TIME: View = View {
    name: "time",
    title: "Time of the whole triangulation, as a ratio to the first row",
    about: "Medians of the turns, then the mean over the seeds; intervals hold 95 of a hundred draws.",
    measure: Row::ns_per_point,
    shape: Shape::Ratios,
};

/// A cell for each of these kinds with each of these sizes and seeds.
pub(crate) fn cells(kinds: &[&str], sizes: &[usize], seeds: RangeInclusive<u64>) -> Vec<Cell> {
    let cell = |name: &str, size, seed| Cell {
        source: Source::Kind(Kind::named(name).expect("the experiments name kinds that exist")),
        size,
        seed,
    };
    let mut cells = Vec::new();
    for &size in sizes {
        for kind in kinds {
            cells.extend(seeds.clone().map(|seed| cell(kind, size, seed)));
        }
    }
    cells
}

/// The structure that the crate uses unless told otherwise.
fn default_structure(contestants: &[Contestant]) -> &Contestant {
    contestants.first().expect("the standard ones come first")
}

/// Nothing to say beside the views.
fn no_remarks(_: &[Row]) -> String {
    String::new()
}

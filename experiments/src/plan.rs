//! A plan: an experiment with its cells, variants, seed and repetitions. It says what a folder of results
//! holds, so that an interrupted run goes on with what is missing, and never mixes two plans.

use std::fmt::Write;

use crate::experiments::Experiment;
use crate::measure::{Cell, Variant};
use crate::report::commit;

#[derive(Debug)]
pub(crate) struct Plan {
    pub(crate) experiment: Experiment,
    pub(crate) cells: Vec<Cell>,
    pub(crate) variants: Vec<Variant>,
    pub(crate) seed: u64,
    pub(crate) repetitions: usize,
    pub(crate) commit: String,
}

impl Plan {
    /// The plan of an experiment with these cells and variants, at the present commit.
    pub(crate) fn new(
        experiment: Experiment,
        cells: Vec<Cell>,
        variants: Vec<Variant>,
        seed: u64,
        repetitions: usize,
    ) -> Plan {
        Plan {
            experiment,
            cells,
            variants,
            seed,
            repetitions,
            commit: commit(),
        }
    }

    /// A line for a cell.
    pub(crate) fn line(cell: &Cell) -> String {
        if cell.size == 0 {
            cell.data()
        } else {
            format!("{} {}", cell.data(), cell.size)
        }
    }

    /// The whole plan as text.
    pub(crate) fn text(&self) -> String {
        self.text_at(&self.commit)
    }

    /// The same as it would be at another commit.
    pub(crate) fn text_at(&self, commit: &str) -> String {
        let mut text = format!(
            "experiment {}\ncommit {}\nseed {}\nrepetitions {}\n",
            self.experiment.name, commit, self.seed, self.repetitions
        );
        for variant in &self.variants {
            let _ = writeln!(text, "variant {}", variant.name);
        }
        for cell in &self.cells {
            let _ = writeln!(text, "cell {}", Plan::line(cell));
        }
        text
    }
}

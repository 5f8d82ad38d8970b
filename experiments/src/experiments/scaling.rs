//! How the work and the time grow with the number of points.

use super::experiment::{Experiment, cells, no_remarks};
use super::fronts::work;
use crate::contestant::{Contestant, standard};
use crate::measure::Variant;
use crate::report::{Shape, View};

pub(super) const SCALING: Experiment = Experiment {
    name: "scaling",
    about: "How do work and time grow with the number of points?",
    cells: |quick| {
        let sizes: &[usize] = if quick {
            &[1000, 3000, 10_000]
        } else {
            &[1000, 10_000, 100_000, 1_000_000, 10_000_000]
        };
        cells(&["uniform", "clusters", "parcels", "contours"], sizes)
    },
    variants: |contestants| {
        let others = standard();
        let is_own =
            |contestant: &&Contestant| others.iter().all(|other| other.name() != contestant.name());
        let chosen =
            |contestant: &&Contestant| SHOWN.contains(&contestant.name()) || is_own(contestant);
        contestants
            .iter()
            .filter(chosen)
            .map(Variant::structure)
            .collect()
    },
    views: &[
        View {
            name: "walk",
            title: "Steps along the front, a search",
            about: "From the node that the structure names to the segment under the new point.",
            measure: |row| Some(row.front_steps as f64 / row.searches.max(1) as f64),
            shape: Shape::Growth,
        },
        View {
            name: "work",
            title: "Work of structure and sweep, a search",
            about: "Comparisons or visits in the structure, whichever are more, and steps along the front.",
            measure: work,
            shape: Shape::Growth,
        },
        View {
            name: "time",
            title: "Time of the whole triangulation, nanoseconds a point",
            about: "Medians.",
            measure: |row| Some(row.ns_per_point()),
            shape: Shape::Growth,
        },
    ],
    remarks: no_remarks,
};

/// A few of each sort, so that their lines can be told apart.
const SHOWN: &[&str] = &[
    "hash table (default)",
    "uniform table, 2 sqrt(n)",
    "bit set over ranks",
    "skip list",
    "splay tree, 10 % sample",
    "sorted array",
    "walk from the last node",
];

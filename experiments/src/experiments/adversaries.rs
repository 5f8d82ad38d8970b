//! For each structure the data that defeats it: the work of a search as it grows with the number of points.

use super::experiment::{Experiment, TIME, cells, no_remarks};
use super::fronts::work;
use crate::measure::Variant;
use crate::report::{Shape, View};

pub(super) const ADVERSARIES: Experiment = Experiment {
    name: "adversaries",
    about: "Which data defeats which structure?",
    cells: |quick| {
        let sizes: &[usize] = if quick {
            &[1000, 4000]
        } else {
            &[1000, 4000, 16_000, 64_000]
        };
        cells(KINDS, sizes)
    },
    variants: |contestants| contestants.iter().map(Variant::structure).collect(),
    views: &[
        View {
            name: "walk-growth",
            title: "Growth of the steps along the front: 0 is constant, 1 is linear in the points",
            about: "The exponent fitted to steps a search against points, by least squares of logarithms.",
            measure: |row| Some(row.front_steps as f64 / row.searches.max(1) as f64),
            shape: Shape::Exponents,
        },
        View {
            name: "work-growth",
            title: "Growth of the work of structure and sweep: 0 is constant, 1 is linear in the points",
            about: "The same for comparisons or visits in the structure and steps along the front, a search.",
            measure: work,
            shape: Shape::Exponents,
        },
        View {
            name: "moved-growth",
            title: "Growth of the entries moved: 0 is constant, 1 is linear in the points",
            about: "The same for entries moved and links changed, a search.",
            measure: |row| Some(row.rearranged? as f64 / row.searches.max(1) as f64),
            shape: Shape::Exponents,
        },
        View {
            name: "work",
            title: "Work of structure and sweep, a search",
            about: "Comparisons or visits in the structure, whichever are more, and steps along the front.",
            measure: work,
            shape: Shape::Map,
        },
        TIME,
    ],
    remarks: no_remarks,
};

const KINDS: &[&str] = &[
    "uniform",
    "power-law",
    "parabola-up",
    "alternating",
    "above-a-row",
    "outliers",
    "leftwards",
];

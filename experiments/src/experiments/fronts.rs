//! Every structure on every kind of data.

use super::experiment::{Experiment, TIME, cells, no_remarks};
use crate::measure::{Row, Variant};
use crate::report::{Shape, View};

pub(super) const FRONTS: Experiment = Experiment {
    name: "fronts",
    about: "Which search structure for which data, by how much, and why?",
    cells: |quick| {
        let sizes: &[usize] = if quick {
            &[1000, 10_000]
        } else {
            &[10_000, 100_000, 1_000_000]
        };
        cells(KINDS, sizes)
    },
    variants: |contestants| contestants.iter().map(Variant::structure).collect(),
    views: &[
        View {
            name: "walk",
            title: "Steps along the front, a search",
            about: "From the node that the structure names to the segment under the new point, by exact comparisons.",
            measure: |row| Some(row.front_steps as f64 / row.searches.max(1) as f64),
            shape: Shape::Map,
        },
        View {
            name: "work",
            title: "Comparisons or nodes visited in the structure, and steps along the front, a search",
            about: "The structure's own comparisons or visits, whichever are more, over searches and updates, and the steps of the table above; divided by the searches. Empty where a structure does not count.",
            measure: work,
            shape: Shape::Map,
        },
        View {
            name: "moved",
            title: "Entries moved or links changed, a search",
            about: "What updates and rotations rearrange, divided by the searches.",
            measure: |row| Some(row.rearranged? as f64 / row.searches.max(1) as f64),
            shape: Shape::Map,
        },
        View {
            name: "bytes",
            title: "Bytes held by the structure, a point",
            about: "Entries and tables at their greatest, without what the allocator adds.",
            measure: |row| Some(row.bytes? as f64 / row.points.max(1) as f64),
            shape: Shape::Map,
        },
        TIME,
        View {
            name: "least",
            title: "Least time of the whole triangulation, nanoseconds a point",
            about: "Of all turns, as it is disturbed least. Ratios as before.",
            measure: |row| Some(1e6 * row.times_ms()[1] / row.points.max(1) as f64),
            shape: Shape::Ratios,
        },
    ],
    remarks: no_remarks,
};

const KINDS: &[&str] = &[
    "uniform",
    "clusters",
    "power-law",
    "lattice",
    "rows",
    "columns",
    "circle",
    "parabola-up",
    "parabola-right",
    "comb",
    "fans",
    "asterisk",
    "segments",
    "outlines",
    "parcels",
    "contours",
    "above-a-row",
    "outliers",
];

/// The work of the structure and the sweep together, a search.
pub(super) fn work(row: &Row) -> Option<f64> {
    let inside = row.comparisons?.max(row.visited?);
    Some((inside + row.front_steps) as f64 / row.searches.max(1) as f64)
}

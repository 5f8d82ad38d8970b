//! The experiments that compare search structures: on every kind of data, as the number of points grows, and
//! on the data that defeats them.

use sweep_cdt::{Algorithm, Heuristics};

use super::{Experiment, TIME, cells, no_remarks};
use crate::contestant::{Contestant, standard};
use crate::measure::{Row, Variant};
use crate::report::{Shape, View};

/// Every structure on every kind of data.
pub(crate) const FRONTS: Experiment = Experiment {
    name: "fronts",
    about: "Which search structure for which data, by how much, and why?",
    cells: |quick| {
        if quick {
            return cells(FRONTS_KINDS, &[1000, 10_000], 1..=2);
        }
        let mut all = cells(FRONTS_KINDS, &[10_000, 100_000], 1..=10);
        all.extend(cells(FRONTS_KINDS, &[1_000_000], 1..=3));
        all
    },
    variants: |contestants| contestants.iter().map(Variant::structure).collect(),
    views: FRONTS_VIEWS,
    remarks: no_remarks,
};

/// Every structure on data that the default was not tuned on, and that is named before it runs.
pub(crate) const HOLD_OUT: Experiment = Experiment {
    name: "holdout",
    about: "Does the default stay ahead on real data that it was not tuned on?",
    cells: |_| Vec::new(),
    ..FRONTS
};

const FRONTS_VIEWS: &[View] = &[
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
];

const FRONTS_KINDS: &[&str] = &[
    "uniform", "clusters", "lattice", "rows", "columns", "asterisk", "segments", "outlines",
    "parcels", "contours",
];

/// How the work and the time grow with the number of points.
pub(crate) const SCALING: Experiment = Experiment {
    name: "scaling",
    about: "How do work and time grow with the number of points?",
    cells: |quick| {
        let sizes: &[usize] = if quick {
            &[1000, 3000, 10_000]
        } else {
            &[1000, 10_000, 100_000, 1_000_000]
        };
        cells(
            &["uniform", "clusters", "parcels", "contours"],
            sizes,
            1..=1,
        )
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
            measure: Row::ns_per_point,
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

/// For each structure the data that defeats it: the work of a search as it grows with the number of points.
pub(crate) const ADVERSARIES: Experiment = Experiment {
    name: "adversaries",
    about: "Which data defeats which structure?",
    cells: |quick| {
        let sizes: &[usize] = if quick {
            &[1000, 4000]
        } else {
            &[1000, 4000, 16_000, 64_000]
        };
        cells(ADVERSARIES_KINDS, sizes, 1..=1)
    },
    // The sweep to its end: it would be abandoned where walks are long.
    variants: |contestants| {
        let to_the_end = |contestant: &Contestant| {
            let (algorithm, heuristics) = (Algorithm::Sweep, Heuristics::default());
            Variant::sweep(contestant.name(), contestant, algorithm, heuristics)
        };
        contestants.iter().map(to_the_end).collect()
    },
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

const ADVERSARIES_KINDS: &[&str] = &[
    "uniform",
    "power-law",
    "parabola-up",
    "alternating",
    "above-a-row",
    "outliers",
    "towers",
    "leftwards",
];

/// The work of the structure and the sweep together, a search.
fn work(row: &Row) -> Option<f64> {
    let inside = row.comparisons?.max(row.visited?);
    Some((inside + row.front_steps) as f64 / row.searches.max(1) as f64)
}

//! The experiments with the default structure: other heuristics, and other scalars.

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::{Algorithm, Corners, Heuristics};

use super::{Experiment, TIME, cells, default_structure, no_remarks};
use crate::measure::Variant;
use crate::report::{Shape, View};

/// The two heuristics of the point event (section 3.4.1, figures 9 and 10), alone and together.
pub(crate) const HEURISTICS: Experiment = Experiment {
    name: "heuristics",
    about: "What do the heuristics of the point event buy: narrow corners, up to which angle, and basins?",
    cells: |quick| {
        if quick {
            cells(KINDS, &[10_000], 1..=1)
        } else {
            cells(KINDS, &[100_000], 1..=5)
        }
    },
    variants: |contestants| {
        let structure = default_structure(contestants);
        let setting = |(name, heuristics): (String, Heuristics)| {
            // Without any heuristic the sweep flips more than its budget allows: it goes on all the same.
            Variant::sweep(&name, structure, Algorithm::Sweep, heuristics)
        };
        settings().into_iter().map(setting).collect()
    },
    views: &[
        View {
            name: "flips",
            title: "Flips, a point",
            about: "Sides swapped by the legalization.",
            measure: |row| Some(row.flips as f64 / row.points.max(1) as f64),
            shape: Shape::Map,
        },
        View {
            name: "angles",
            title: "Flips, a point, by the greatest angle of an obtuse corner that is closed",
            about: "Of the greatest number of points.",
            measure: |row| Some(row.flips as f64 / row.points.max(1) as f64),
            shape: Shape::Angles,
        },
        View {
            name: "in-circle",
            title: "In-circle tests, a point",
            about: "By the filter and exactly, without those that involve an artificial vertex.",
            measure: |row| Some(row.in_circle_tests as f64 / row.points.max(1) as f64),
            shape: Shape::Map,
        },
        View {
            name: "front",
            title: "Mean length of the front, in square roots of the number of points",
            about: "Over all searches.",
            measure: |row| Some(row.front_mean / (row.points.max(1) as f64).sqrt()),
            shape: Shape::Map,
        },
        View {
            name: "survived",
            title: "Share of the triangles made that are in the result",
            about: "Without those that flips made: neither flipped nor removed since.",
            measure: |row| {
                let (made, survived) = (row.made_by_steps, row.survived_of_steps);
                Some(survived as f64 / made.max(1) as f64)
            },
            shape: Shape::Map,
        },
        View {
            name: "added",
            title: "Triangles that the heuristics add, a point",
            about: "Those of narrow corners and of basins.",
            measure: |row| {
                let added = row.narrow_corners + row.basin_triangles;
                Some(added as f64 / row.points.max(1) as f64)
            },
            shape: Shape::Map,
        },
        TIME,
    ],
    remarks: no_remarks,
};

const KINDS: &[&str] = &[
    "uniform", "clusters", "lattice", "rows", "segments", "parcels", "contours",
];

/// The angles of obtuse corners in steps: the square of the cosine in sixteenths, and degrees.
const ANGLES: [(u8, &str); 8] = [
    (1, "104"),
    (2, "111"),
    (3, "116"),
    (4, "120"),
    (5, "124"),
    (6, "128"),
    (7, "131"),
    (8, "135"),
];

fn settings() -> Vec<(String, Heuristics)> {
    let with_basins = |mut heuristics: Heuristics| {
        heuristics.basins = true;
        heuristics
    };
    let corners = |corners| {
        let mut heuristics = Heuristics::OFF;
        heuristics.corners = corners;
        heuristics
    };
    let named = [
        ("wide corners (default)", Heuristics::FAST),
        ("wide corners, basins", with_basins(Heuristics::FAST)),
        ("pi/2, basins (paper)", Heuristics::PAPER),
        ("pi/2 alone", corners(Corners::RightAngle)),
        ("basins alone", with_basins(Heuristics::OFF)),
        ("none", Heuristics::OFF),
    ];
    let named = named.map(|(name, heuristics)| (name.to_owned(), heuristics));
    // Between pi/2 and 3pi/4, without basins.
    type Setting = (&'static str, fn(u8) -> Corners);
    let kinds: [Setting; 2] = [
        ("one corner", Corners::OneUpTo),
        ("all corners", Corners::AllUpTo),
    ];
    let stepped = kinds.iter().flat_map(|&(which, setting)| {
        ANGLES.iter().map(move |&(sixteenths, degrees)| {
            let name = format!("{which} up to {degrees}°");
            (name, corners(setting(sixteenths)))
        })
    });
    named.into_iter().chain(stepped).collect()
}

/// One set of points in several scalars: integers that all of them hold.
pub(crate) const SCALARS: Experiment = Experiment {
    name: "scalars",
    about: "What does exact arithmetic in other scalars cost on the same integers?",
    cells: |quick| {
        let sizes: &[usize] = if quick { &[3000] } else { &[10_000, 100_000] };
        cells(&["integers", "lattice", "asterisk"], sizes, 1..=1)
    },
    variants: |_| {
        vec![
            Variant::scalar::<f64>("f64"),
            Variant::scalar::<f32>("f32"),
            Variant::scalar::<i64>("i64"),
            Variant::scalar::<BigInt>("BigInt"),
            Variant::scalar::<BigRational>("BigRational"),
        ]
    },
    views: &[
        View {
            name: "exact",
            title: "Tests that the filter leaves open, a point",
            about: "Orientation and in-circle tests.",
            measure: |row| {
                let exact = row.orientation_exact + row.in_circle_exact;
                Some(exact as f64 / row.points.max(1) as f64)
            },
            shape: Shape::Map,
        },
        TIME,
    ],
    remarks: no_remarks,
};

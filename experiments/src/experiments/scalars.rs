//! The same points in several scalars: integers that all of them hold.

use num_bigint::BigInt;
use num_rational::BigRational;

use super::experiment::{Experiment, TIME, cells, no_remarks};
use crate::measure::Variant;
use crate::report::{Shape, View};

pub(super) const SCALARS: Experiment = Experiment {
    name: "scalars",
    about: "What does exact arithmetic in other scalars cost on the same integers?",
    cells: |quick| {
        let sizes: &[usize] = if quick { &[3000] } else { &[10_000, 100_000] };
        cells(&["integers", "lattice", "asterisk"], sizes)
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

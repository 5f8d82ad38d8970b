//! Points in rows: on lines, circles, parabolas and lattices.

use std::f64::consts::TAU;

use super::family::{Family, points};
use crate::Random;

pub(super) const FAMILIES: &[Family] = &[
    Family {
        name: "uniform",
        member: |n| crate::Input {
            points: Random::new(1).points(n),
            edges: Vec::new(),
        },
    },
    Family {
        name: "line",
        member: |n| points(n, |i, _| [i, 2.0 * i]),
    },
    Family {
        name: "column",
        member: |n| points(n, |i, _| [3.0, i]),
    },
    Family {
        name: "row",
        member: |n| points(n, |i, _| [i, 3.0]),
    },
    Family {
        name: "column and one point",
        member: |n| points(n, |i, n| if i < 1.0 { [-n, n / 3.0] } else { [3.0, i] }),
    },
    Family {
        name: "row and one point",
        member: |n| points(n, |i, n| if i < 1.0 { [n / 3.0, -n] } else { [i, 3.0] }),
    },
    Family {
        name: "lattice",
        member: |n| {
            let side = (n as f64).sqrt().round();
            points(n, |i, _| [i % side, (i / side).floor()])
        },
    },
    Family {
        name: "circle",
        member: |n| points(n, |i, n| [(TAU * i / n).cos(), (TAU * i / n).sin()]),
    },
    Family {
        name: "parabola, open above",
        member: |n| points(n, |i, n| [i - n / 2.0, (i - n / 2.0).powi(2)]),
    },
    Family {
        name: "parabola, open below",
        member: |n| points(n, |i, n| [i - n / 2.0, -(i - n / 2.0).powi(2)]),
    },
    Family {
        name: "parabola, open right",
        member: |n| points(n, |i, n| [(i - n / 2.0).powi(2), i - n / 2.0]),
    },
    Family {
        name: "parabola, open left",
        member: |n| points(n, |i, n| [-(i - n / 2.0).powi(2), i - n / 2.0]),
    },
    Family {
        name: "half a parabola from its flat end",
        member: |n| points(n, |i, n| [i, i * i / n]),
    },
    Family {
        name: "half a parabola, open below",
        member: |n| points(n, |i, n| [-i, -i * i / n]),
    },
    Family {
        name: "branch above scattered points",
        member: |n| {
            let scattered = Random::new(2).points(n);
            points(n, |i, n| {
                if i % 2.0 < 1.0 {
                    [i, i * i / n]
                } else {
                    let [x, y] = scattered[i as usize];
                    [n * x, -n * y]
                }
            })
        },
    },
    Family {
        name: "two slanted chains",
        member: |n| points(n, |i, n| [i, i + n / 50.0 * (i % 2.0 - 0.5)]),
    },
];

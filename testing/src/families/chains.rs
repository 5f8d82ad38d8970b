//! Teeth, combs and spirals: chains whose corners turn to both sides, alone and with edges.

use std::f64::consts::TAU;

use super::family::{Family, path, points};
use crate::Input;

pub(super) const FAMILIES: &[Family] = &[
    Family {
        name: "toothed parabola, flat",
        member: |n| toothed(n, 1.0 / n as f64),
    },
    Family {
        name: "toothed parabola, steep",
        member: |n| toothed(n, 1.0),
    },
    Family {
        name: "toothed parabola with its edges",
        member: |n| path(toothed(n, 1.0 / n as f64)),
    },
    Family {
        name: "edge above a toothed parabola",
        member: |n| {
            let mut input = toothed(n, 1.0 / n as f64);
            input.edges.push([0, input.points.len() - 1]);
            input
        },
    },
    Family {
        name: "edge between two toothed parabolas",
        member: |n| {
            let mut input = toothed(n / 2, 1.0 / n as f64);
            let [left, right] = [0, input.points.len() - 1];
            let top = input.points[left][1];
            // The mirror image above the edge; the ends are in both.
            let mirrored: Vec<_> = (input.points[1..right].iter())
                .map(|&[x, y]| [x, 2.0 * top - y])
                .collect();
            input.points.extend(mirrored);
            input.edges.push([left, right]);
            input
        },
    },
    Family {
        name: "edge through teeth",
        member: |n| {
            let mut input = points(n, tooth);
            input.edges.push([0, n - 1]);
            input
        },
    },
    Family {
        name: "edge above teeth",
        member: |n| {
            let mut input = points(n, |i, n| {
                let is_end = i < 1.0 || i > n - 1.5;
                [i, if is_end { 9.0 } else { i % 2.0 }]
            });
            input.edges.push([0, n - 1]);
            input
        },
    },
    Family {
        name: "comb",
        member: comb,
    },
    Family {
        name: "comb with its edges",
        member: |n| path(comb(n)),
    },
    Family {
        name: "spiral",
        member: spiral,
    },
    Family {
        name: "spiral with its edges",
        member: |n| path(spiral(n)),
    },
];

/// A parabola, and between any two of its vertices one above the curve.
fn toothed(n: usize, c: f64) -> Input {
    points(n | 1, |i, n| {
        let x = i - (n - 1.0) / 2.0;
        [x, c * x * x + 0.35 * (i % 2.0)]
    })
}

/// Teeth on both sides of the line from the first to the last point. They stay on the front, as their
/// angles are wide, until the last point comes, above nearly all of them.
fn tooth(i: f64, n: f64) -> [f64; 2] {
    let is_end = i < 1.0 || i > n - 1.5;
    let height = if is_end { 0.0 } else { 0.6 * (i % 2.0 - 0.5) };
    [i, 2.0 * i / n + height]
}

/// Long narrow teeth that hang down.
fn comb(n: usize) -> Input {
    points(n, |i, n| {
        let place = i % 4.0;
        [i, if place < 2.0 { n } else { i / n }]
    })
}

/// An Archimedean spiral with `n` points, eight to a turn at its start and more outside.
fn spiral(n: usize) -> Input {
    let turns = (n as f64).sqrt() / 4.0;
    points(n, |i, n| {
        let t = ((i + 1.0) / n).sqrt();
        let angle = TAU * turns * t;
        [t * angle.cos(), t * angle.sin()]
    })
}

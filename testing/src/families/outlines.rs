//! Outlines with nothing inside, and squares inside each other.

use std::f64::consts::TAU;

use super::family::{Family, points, ring};
use crate::Input;

pub(super) const FAMILIES: &[Family] = &[
    Family {
        name: "square",
        member: |n| outline(n, SQUARE),
    },
    Family {
        name: "square with its edges",
        member: |n| ring(outline(n, SQUARE)),
    },
    Family {
        name: "rectangle",
        member: |n| outline(n, &[[0.0, 0.0], [5.0, 0.0], [5.0, 1.0], [0.0, 1.0]]),
    },
    Family {
        name: "triangle",
        member: |n| outline(n, &[[0.0, 0.0], [4.0, 0.5], [1.0, 3.0]]),
    },
    Family {
        name: "hexagon",
        member: |n| {
            let corners = [0, 1, 2, 3, 4, 5].map(|i| {
                let angle = TAU * f64::from(i) / 6.0;
                [angle.cos(), angle.sin()]
            });
            outline(n, &corners)
        },
    },
    Family {
        name: "plus",
        member: |n| outline(n, PLUS),
    },
    Family {
        name: "plus with its edges",
        member: |n| ring(outline(n, PLUS)),
    },
    Family {
        name: "T",
        member: |n| outline(n, T),
    },
    Family {
        name: "T with its edges",
        member: |n| ring(outline(n, T)),
    },
    Family {
        name: "L",
        member: |n| {
            let l = [
                [0.0, 0.0],
                [3.0, 0.0],
                [3.0, 1.0],
                [1.0, 1.0],
                [1.0, 3.0],
                [0.0, 3.0],
            ];
            outline(n, &l)
        },
    },
    Family {
        name: "flat ellipse",
        member: |n| points(n, |i, n| [(TAU * i / n).cos(), 0.05 * (TAU * i / n).sin()]),
    },
    Family {
        name: "nested squares",
        member: nested,
    },
    Family {
        name: "nested squares with their edges",
        member: |n| {
            let mut input = nested(n);
            input.edges = (0..input.points.len())
                .map(|i| [i, if i % 4 == 3 { i - 3 } else { i + 1 }])
                .collect();
            input
        },
    },
];

const SQUARE: &[[f64; 2]] = &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

const PLUS: &[[f64; 2]] = &[
    [1.0, 0.0],
    [2.0, 0.0],
    [2.0, 1.0],
    [3.0, 1.0],
    [3.0, 2.0],
    [2.0, 2.0],
    [2.0, 3.0],
    [1.0, 3.0],
    [1.0, 2.0],
    [0.0, 2.0],
    [0.0, 1.0],
    [1.0, 1.0],
];

const T: &[[f64; 2]] = &[
    [1.0, 0.0],
    [2.0, 0.0],
    [2.0, 2.0],
    [3.0, 2.0],
    [3.0, 3.0],
    [0.0, 3.0],
    [0.0, 2.0],
    [1.0, 2.0],
];

/// About `n` points, equally many on each side of a polygon.
fn outline(n: usize, corners: &[[f64; 2]]) -> Input {
    let steps = (n / corners.len()).max(1);
    let side = |k: usize| {
        let (a, b) = (corners[k], corners[(k + 1) % corners.len()]);
        (0..steps).map(move |i| {
            let t = i as f64 / steps as f64;
            [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]
        })
    };
    Input {
        points: (0..corners.len()).flat_map(side).collect(),
        edges: Vec::new(),
    }
}

/// Squares inside each other, four points each.
fn nested(n: usize) -> Input {
    points(n / 4 * 4, |i, _| {
        let size = (i / 4.0).floor() + 1.0;
        match i % 4.0 {
            0.0 => [-size, -size],
            1.0 => [size, -size],
            2.0 => [size, size],
            _ => [-size, size],
        }
    })
}

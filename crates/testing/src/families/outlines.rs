//! Chains and outlines: teeth, combs and spirals, whose corners turn to both sides; outlines with nothing inside,
//! and squares inside each other. Alone and with edges.

use std::f64::consts::TAU;

use super::points::{Family, path, points, ring};
use crate::Input;

/// Teeth, combs and spirals.
pub(super) const CHAINS: &[Family] = &[
    Family::new("toothed parabola, flat", |n| toothed(n, 1.0 / n as f64)),
    Family::new("toothed parabola, steep", |n| toothed(n, 1.0)),
    Family::new("toothed parabola with its edges", |n| {
        path(toothed(n, 1.0 / n as f64))
    }),
    Family::new("edge above a toothed parabola", |n| {
        let mut input = toothed(n, 1.0 / n as f64);
        input.edges.push([0, input.points.len() - 1]);
        input
    }),
    Family::new("edge between two toothed parabolas", |n| {
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
    }),
    Family::new("edge through teeth", |n| {
        let mut input = points(n, tooth);
        input.edges.push([0, n - 1]);
        input
    }),
    Family::new("edge above teeth", |n| {
        let mut input = points(n, |i, n| {
            let is_end = i < 1.0 || i > n - 1.5;
            [i, if is_end { 9.0 } else { i % 2.0 }]
        });
        input.edges.push([0, n - 1]);
        input
    }),
    Family::new("comb", comb),
    Family::new("comb with its edges", |n| path(comb(n))),
    Family::new("spiral", spiral),
    Family::new("spiral with its edges", |n| path(spiral(n))),
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

/// Outlines, and squares inside each other.
pub(super) const OUTLINES: &[Family] = &[
    Family::new("square", |n| outline(n, SQUARE)),
    Family::new("square with its edges", |n| ring(outline(n, SQUARE))),
    Family::new("rectangle", |n| {
        outline(n, &[[0.0, 0.0], [5.0, 0.0], [5.0, 1.0], [0.0, 1.0]])
    }),
    Family::new("triangle", |n| {
        outline(n, &[[0.0, 0.0], [4.0, 0.5], [1.0, 3.0]])
    }),
    Family::new("hexagon", |n| {
        let corners = [0, 1, 2, 3, 4, 5].map(|i| {
            let angle = TAU * f64::from(i) / 6.0;
            [angle.cos(), angle.sin()]
        });
        outline(n, &corners)
    }),
    Family::new("plus", |n| outline(n, PLUS)),
    Family::new("plus with its edges", |n| ring(outline(n, PLUS))),
    Family::new("T", |n| outline(n, T)),
    Family::new("T with its edges", |n| ring(outline(n, T))),
    Family::new("L", |n| {
        let l = [
            [0.0, 0.0],
            [3.0, 0.0],
            [3.0, 1.0],
            [1.0, 1.0],
            [1.0, 3.0],
            [0.0, 3.0],
        ];
        outline(n, &l)
    }),
    Family::new("flat ellipse", |n| {
        points(n, |i, n| [(TAU * i / n).cos(), 0.05 * (TAU * i / n).sin()])
    }),
    Family::new("nested squares", nested),
    Family::new("nested squares with their edges", |n| {
        let mut input = nested(n);
        input.edges = (0..input.points.len())
            .map(|i| [i, if i % 4 == 3 { i - 3 } else { i + 1 }])
            .collect();
        input
    }),
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

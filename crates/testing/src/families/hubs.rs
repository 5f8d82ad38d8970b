//! Vertices with many edges: stars, edges through one vertex or through many, equal and overlapping edges.

use std::f64::consts::PI;

use super::points::{Family, points};
use crate::Input;

pub(super) const HUBS: &[Family] = &[
    Family::new("star at one upper end", |n| star(n, |n| [n / 2.0, n])),
    Family::new("star at one lower end", |n| star(n, |n| [n / 2.0, -n])),
    Family::new("asterisk", |n| asterisk(n, &[[0.0, 0.0]])),
    Family::new("two linked asterisks", |n| {
        let mut input = asterisk(n, &[[0.0, 0.0], [8.0, 1.0]]);
        // The centres come last.
        let last = input.points.len() - 1;
        input.edges.push([last - 1, last]);
        input
    }),
    Family::new("asterisk in integer directions", |n| {
        let side = (n as f64).sqrt().ceil();
        let mut input = points(n / 2, |i, _| {
            // Directions of the upper half plane; several edges lie on one line.
            [i % side - (side / 2.0).floor(), (i / side).floor() + 1.0]
        });
        let mirrored: Vec<_> = input.points.iter().map(|&[x, y]| [-x, -y]).collect();
        let m = mirrored.len();
        input.points.extend(mirrored);
        input.points.push([0.0, 0.0]);
        input.edges = (0..m).map(|i| [i, i + m]).collect();
        input
    }),
    Family::new("edges through many vertices", |n| {
        // A lattice with one edge along each row and each column.
        let side = (n as f64).sqrt().floor();
        let mut input = points((side * side) as usize, |i, _| {
            [i % side, (i / side).floor()]
        });
        let side = side as usize;
        input.edges = (0..side)
            .map(|row| [row * side, row * side + side - 1])
            .collect();
        input
            .edges
            .extend((0..side).map(|column| [column, (side - 1) * side + column]));
        input
    }),
    Family::new("one edge many times", |n| {
        let mut input = points(n, |i, _| [i, 0.0]);
        input.edges = vec![[0, n - 1]; n];
        input
    }),
];

/// Points in a band, all joined to one centre.
fn star(n: usize, centre: fn(f64) -> [f64; 2]) -> Input {
    let mut input = points(n, |i, n| {
        if i < 1.0 {
            centre(n)
        } else {
            [i, i * 7.0 % 11.0]
        }
    });
    input.edges = (1..n).map(|i| [i, 0]).collect();
    input
}

/// Edges through each of these centres, which come last.
fn asterisk(n: usize, centres: &[[f64; 2]]) -> Input {
    let m = n / centres.len() / 2;
    let mut input = Input {
        points: Vec::new(),
        edges: Vec::new(),
    };
    for &[x, y] in centres {
        let first = input.points.len();
        // Opposite points are exact mirror images only around zero; a power of two keeps the others so.
        let direction = |i: usize| {
            let t = PI * (i as f64 + 0.5) / m as f64;
            [t.cos(), t.sin()].map(|c| (c * 1e9).round() / (1_u64 << 30) as f64)
        };
        for i in 0..m {
            let [dx, dy] = direction(i);
            input.points.push([x + dx, y + dy]);
            input.points.push([x - dx, y - dy]);
            input.edges.push([first + 2 * i, first + 2 * i + 1]);
        }
    }
    input.points.extend(centres);
    input
}

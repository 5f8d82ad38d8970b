//! Edges for the search of crossings: each family as it is, where edges meet in their ends alone, and once more with an
//! edge across each of its edges.

use std::f64::consts::TAU;

use super::points::{Family, points, ring};
use super::slanted::{HATCHES, RINGS, STARS, ZIGZAGS, hatch, noise, several};
use crate::Input;

/// A family of edges, with or without pairs that cross.
#[derive(Clone, Copy, Debug)]
pub struct Crossed {
    family: Family,
    /// Whether each edge is crossed.
    pub is_crossed: bool,
}

/// All families of [`slanted`](super::slanted) but those of one edge, and others whose edges have boxes that lie in each
/// other's way: all as they are, and with an edge across each edge.
pub fn crossed() -> impl Iterator<Item = Crossed> {
    let all = [HATCHES, ZIGZAGS, RINGS, STARS, BOXES]
        .into_iter()
        .flatten();
    let all = all.filter(|family| (family.member)(1000).edges.len() > 100);
    all.flat_map(|&family| [false, true].map(|is_crossed| Crossed { family, is_crossed }))
}

impl Crossed {
    /// The name.
    pub fn name(&self) -> String {
        let with = if self.is_crossed { ", crossed" } else { "" };
        format!("{}{with}", self.family.name)
    }

    /// The family's member of about so many edges.
    pub fn of_edges(&self, count: usize) -> Input {
        const TRIED: usize = 4096;
        let edges = self.member(TRIED).edges.len();
        self.member(count * TRIED / edges)
    }

    fn member(&self, n: usize) -> Input {
        let mut input = (self.family.member)(n);
        if self.is_crossed {
            for edge in 0..input.edges.len() {
                let [[ax, ay], [bx, by]] = input.edges[edge].map(|v| input.points[v]);
                // Across the edge, somewhere within it, and short beside it.
                let part = 0.2 + 0.6 * noise(edge as f64);
                let [x, y] = [ax + part * (bx - ax), ay + part * (by - ay)];
                let length = ((bx - ax).powi(2) + (by - ay).powi(2)).sqrt();
                let reach = 0.01 / length.max(0.01);
                let [dx, dy] = [(ay - by) * reach, (bx - ax) * reach];
                let first = input.points.len();
                input.points.extend([[x - dx, y - dy], [x + dx, y + dy]]);
                input.edges.push([first, first + 1]);
            }
        }
        input
    }
}

/// About each of these centres, which are whole numbers, this many edges that pass it, and lead to mirrored ends.
fn through(centres: impl Iterator<Item = [f64; 2]>, edges: usize) -> Input {
    let mut input = Input {
        points: Vec::new(),
        edges: Vec::new(),
    };
    for [x, y] in centres {
        for i in 0..edges {
            let (sin, cos) = (TAU / 2.0 * i as f64 / edges as f64).sin_cos();
            // Sums and differences with a centre are exact.
            const POWER: f64 = (1_u64 << 30) as f64;
            let [dx, dy] = [cos, sin].map(|part| (part * POWER).round() / POWER);
            input
                .edges
                .push([input.points.len(), input.points.len() + 1]);
            input.points.extend([[x - dx, y - dy], [x + dx, y + dy]]);
        }
        input.points.push([x, y]);
    }
    input
}

/// Edges whose boxes lie in each other's way.
const BOXES: &[Family] = &[
    Family::new("upright, far longer than all are wide", |n| {
        hatch(n, |i, _| [[i, 0.0], [i, 1e7 + i % 7.0]])
    }),
    Family::new("level, far longer than all are high", |n| {
        hatch(n, |i, _| [[0.0, i], [1e7 + i % 7.0, i]])
    }),
    Family::new("squares in each other", |n| {
        several(n / 4, |i, _| {
            ring(points(4, |j, _| {
                let size = i + 1.0;
                [[-size, -size], [size, -size], [size, size], [-size, size]][j as usize]
            }))
        })
    }),
    Family::new("crosses in each other", |n| {
        hatch(n, |i, _| {
            let size = (i / 4.0).floor() + 2.0;
            match i % 4.0 {
                0.0 => [[1.0, size], [size - 1.0, size]],
                1.0 => [[-1.0, -size], [1.0 - size, -size]],
                2.0 => [[size, -1.0], [size, 1.0 - size]],
                _ => [[-size, 1.0], [-size, size - 1.0]],
            }
        })
    }),
    Family::new("long level edges, and short ones between them", |n| {
        hatch(n, |i, m| {
            if i % 2.0 < 1.0 {
                [[0.0, i], [m, i]]
            } else {
                let x = noise(i) * m;
                [[x, i - 0.25], [x + 1.0, i + 0.25]]
            }
        })
    }),
    Family::new("long upright edges, and short ones between them", |n| {
        hatch(n, |i, m| {
            if i % 2.0 < 1.0 {
                [[i, 0.0], [i, m]]
            } else {
                let y = noise(i) * m;
                [[i - 0.25, y], [i + 0.25, y + 1.0]]
            }
        })
    }),
    Family::new("long slanted edges, and short ones between them", |n| {
        hatch(n, |i, m| {
            if i % 2.0 < 1.0 {
                [[i, 0.0], [i + m, m]]
            } else {
                let y = noise(i) * m;
                [[i + y - 0.25, y], [i + y + 0.25, y + 0.25]]
            }
        })
    }),
    Family::new("bundles of sixteen that cross", |n| {
        hatch(n, |i, m| {
            let (bundle, in_bundle) = ((i / 16.0).floor(), i % 16.0 / 32.0);
            [
                [bundle + in_bundle, 0.0],
                [
                    bundle + m / 16.0 + 0.5 - in_bundle + 0.01 * noise(i),
                    m / 16.0,
                ],
            ]
        })
    }),
    Family::new("rays", |n| {
        hatch(n, |i, m| {
            let (sin, cos) = (TAU * i / m).sin_cos();
            [[cos, sin], [cos * m, sin * m]]
        })
    }),
    Family::new("asterisk through a vertex", |n| {
        through([[0.0; 2]].into_iter(), n)
    }),
    Family::new("asterisks of sixty-four through vertices", |n| {
        through((0..n / 64).map(|i| [3.0 * i as f64, 0.0]), 64)
    }),
    Family::new("level edges through the vertices of four rails", |n| {
        let mut input = hatch(2 * n, |i, _| [[-1.0, i], [4.0, i]]);
        for rail in 0..4 {
            let [x, m] = [f64::from(rail), n as f64];
            input
                .edges
                .push([input.points.len(), input.points.len() + 1]);
            input.points.extend([[x, -1.0], [x, m]]);
            input.points.extend((0..n).map(|i| [x, i as f64]));
        }
        input
    }),
    Family::new("staircase of long steps", |n| {
        hatch(n, |i, m| {
            [
                [i, i],
                if i % 2.0 < 1.0 {
                    [i + m, i]
                } else {
                    [i, i - m]
                },
            ]
        })
    }),
];

//! The type of a family, the shapes that several families share, and the families of points without edges: in rows
//! and in crowds.

use std::f64::consts::TAU;

use sweep_cdt_generate::Random;

use crate::Input;

/// A family of inputs.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// The name.
    pub name: &'static str,
    /// The family's member of about `n` points; `n` is at least 100.
    pub member: fn(n: usize) -> Input,
}

impl Family {
    pub(super) const fn new(name: &'static str, member: fn(usize) -> Input) -> Family {
        Family { name, member }
    }
}

/// Points without edges: number `i` of `n`.
pub(super) fn points(n: usize, point: impl Fn(f64, f64) -> [f64; 2]) -> Input {
    Input {
        points: (0..n).map(|i| point(i as f64, n as f64)).collect(),
        edges: Vec::new(),
    }
}

/// The input's points with each joined to the next.
pub(super) fn path(mut input: Input) -> Input {
    input.edges = (1..input.points.len()).map(|i| [i - 1, i]).collect();
    input
}

/// The input's points with each joined to the next, and the last to the first.
pub(super) fn ring(input: Input) -> Input {
    let last = input.points.len() - 1;
    let mut input = path(input);
    input.edges.push([last, 0]);
    input
}

/// On lines, circles, parabolas and lattices.
pub(super) const ROWS: &[Family] = &[
    Family::new("uniform", |n| Input {
        points: Random::new(1).points(n),
        edges: Vec::new(),
    }),
    Family::new("line", |n| points(n, |i, _| [i, 2.0 * i])),
    Family::new("column", |n| points(n, |i, _| [3.0, i])),
    Family::new("row", |n| points(n, |i, _| [i, 3.0])),
    Family::new("column and one point", |n| {
        points(n, |i, n| if i < 1.0 { [-n, n / 3.0] } else { [3.0, i] })
    }),
    Family::new("row and one point", |n| {
        points(n, |i, n| if i < 1.0 { [n / 3.0, -n] } else { [i, 3.0] })
    }),
    Family::new("lattice", |n| {
        let side = (n as f64).sqrt().round();
        points(n, |i, _| [i % side, (i / side).floor()])
    }),
    Family::new("circle", |n| {
        points(n, |i, n| [(TAU * i / n).cos(), (TAU * i / n).sin()])
    }),
    Family::new("parabola, open above", |n| {
        points(n, |i, n| [i - n / 2.0, (i - n / 2.0).powi(2)])
    }),
    Family::new("parabola, open below", |n| {
        points(n, |i, n| [i - n / 2.0, -(i - n / 2.0).powi(2)])
    }),
    Family::new("parabola, open right", |n| {
        points(n, |i, n| [(i - n / 2.0).powi(2), i - n / 2.0])
    }),
    Family::new("parabola, open left", |n| {
        points(n, |i, n| [-(i - n / 2.0).powi(2), i - n / 2.0])
    }),
    Family::new("half a parabola from its flat end", |n| {
        points(n, |i, n| [i, i * i / n])
    }),
    Family::new("half a parabola, open below", |n| {
        points(n, |i, n| [-i, -i * i / n])
    }),
    Family::new("branch above scattered points", |n| {
        let scattered = Random::new(2).points(n);
        points(n, |i, n| {
            if i % 2.0 < 1.0 {
                [i, i * i / n]
            } else {
                let [x, y] = scattered[i as usize];
                [n * x, -n * y]
            }
        })
    }),
    Family::new("two slanted chains", |n| {
        points(n, |i, n| [i, i + n / 50.0 * (i % 2.0 - 0.5)])
    }),
];

/// A point far away from all others, dense clusters, and clusters that a sample misses.
pub(super) const CROWDS: &[Family] = &[
    Family::new("one point at the largest double", |n| sentinel(n, 1.0)),
    Family::new("the same, the others within 1e-20", |n| sentinel(n, 1e-20)),
    Family::new("a fifth in a millionth of the width", |n| {
        let mut random = Random::new(3);
        let scattered = random.points(n);
        points(n, |i, _| {
            let [x, y] = scattered[i as usize];
            if i % 5.0 < 1.0 {
                [0.37 + 1e-6 * x, y]
            } else {
                [x, y]
            }
        })
    }),
    Family::new("a cluster that the sample misses", |n| {
        // Every 1/4096 of the ranks lies anywhere, all others within a millionth of the width.
        let scattered = Random::new(4).points(n);
        let stride = n.div_ceil(4096).max(1);
        points(n, |i, n| {
            let [x, _] = scattered[i as usize];
            let is_sampled = (i as usize).is_multiple_of(stride);
            [if is_sampled { x } else { 0.37 + 1e-6 * x }, i / n]
        })
    }),
    Family::new("clusters in clusters", |n| {
        let mut random = Random::new(5);
        Input {
            points: (0..n)
                .map(|_| [0, 1].map(|_| random.unit().powi(12)))
                .collect(),
            edges: Vec::new(),
        }
    }),
];

/// Points within `size`, and one at the largest double.
fn sentinel(n: usize, size: f64) -> Input {
    let mut input = Input {
        points: Random::new(2).points(n),
        edges: Vec::new(),
    };
    for p in &mut input.points {
        *p = p.map(|c| c * size);
    }
    input.points[0] = [f64::MAX, f64::MAX];
    input
}

//! Points that crowd: a point far away from all others, dense clusters, and clusters that a sample misses.

use super::family::{Family, points};
use crate::{Input, Random};

pub(super) const FAMILIES: &[Family] = &[
    Family {
        name: "one point at the largest double",
        member: |n| sentinel(n, 1.0),
    },
    Family {
        name: "the same, the others within 1e-20",
        member: |n| sentinel(n, 1e-20),
    },
    Family {
        name: "a fifth in a millionth of the width",
        member: |n| {
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
        },
    },
    Family {
        name: "a cluster that the sample misses",
        member: |n| {
            // Every 1/4096 of the ranks lies anywhere, all others within a millionth of the width.
            let scattered = Random::new(4).points(n);
            let stride = n.div_ceil(4096).max(1);
            points(n, |i, n| {
                let [x, _] = scattered[i as usize];
                let is_sampled = (i as usize).is_multiple_of(stride);
                [if is_sampled { x } else { 0.37 + 1e-6 * x }, i / n]
            })
        },
    },
    Family {
        name: "clusters in clusters",
        member: |n| {
            let mut random = Random::new(5);
            Input {
                points: (0..n)
                    .map(|_| [0, 1].map(|_| random.unit().powi(12)))
                    .collect(),
                edges: Vec::new(),
            }
        },
    },
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

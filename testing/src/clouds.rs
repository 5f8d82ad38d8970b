//! Points without edges, for benchmarks.

use std::f64::consts::TAU;

use crate::{Input, Random};

/// Uniform points in the unit square.
pub fn uniform(n: usize) -> Input {
    points(Random::new(1).points(n))
}

/// Normal distributions around 100 uniform centres.
pub fn clusters(n: usize) -> Input {
    let mut random = Random::new(2);
    let centres = random.points(100);
    let near = |_| {
        let [x, y] = centres[random.below(centres.len())];
        // Box and Muller's transformation; one minus the unit is not 0.
        let radius = 0.003 * (-2.0 * (1.0 - random.unit()).ln()).sqrt();
        let (sin, cos) = (TAU * random.unit()).sin_cos();
        [x + radius * cos, y + radius * sin]
    };
    points((0..n).map(near).collect())
}

/// One cluster, whose density falls with a power of the distance from its centre.
pub fn power_law(n: usize) -> Input {
    let mut random = Random::new(3);
    let near = |_| {
        let radius = random.unit().powi(6);
        let (sin, cos) = (TAU * random.unit()).sin_cos();
        [radius * cos, radius * sin]
    };
    points((0..n).map(near).collect())
}

/// A square lattice, row by row.
pub fn lattice(n: usize) -> Input {
    points(rows(n))
}

/// A square lattice in random order.
pub fn shuffled_lattice(n: usize) -> Input {
    let mut lattice = rows(n);
    Random::new(4).shuffle(&mut lattice);
    points(lattice)
}

fn rows(n: usize) -> Vec<[f64; 2]> {
    let width = n.isqrt();
    (0..width * width)
        .map(|i| [(i % width) as f64, (i / width) as f64])
        .collect()
}

/// Points on the unit circle, as far as doubles can be, in random order.
pub fn circle(n: usize) -> Input {
    let point = |i| {
        let (sin, cos) = (TAU * i as f64 / n as f64).sin_cos();
        [cos, sin]
    };
    let mut list: Vec<_> = (0..n).map(point).collect();
    Random::new(5).shuffle(&mut list);
    points(list)
}

fn points(points: Vec<[f64; 2]>) -> Input {
    let edges = Vec::new();
    Input { points, edges }
}

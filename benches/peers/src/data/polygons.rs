//! Many polygons of one size.

use std::f64::consts::TAU;

use sweep_cdt_testing::{Input, Random};

/// The points of all polygons of a data set together.
const POINTS: usize = 200_000;

/// Coordinates are integers up to this.
const RADIUS: f64 = (1 << 26) as f64;

/// Polygons of `n` points, star-shaped, with a boundary that is rough on every scale.
pub(super) fn polygons(n: usize) -> Vec<Input> {
    let mut random = Random::new(7);
    (0..POINTS / n).map(|_| polygon(n, &mut random)).collect()
}

fn polygon(n: usize, random: &mut Random) -> Input {
    let radii = radii(n, random);
    let point = |(i, radius): (usize, &f64)| {
        let (sin, cos) = (TAU * (i as f64 + 0.8 * random.unit()) / n as f64).sin_cos();
        [radius * cos, radius * sin].map(|c| (RADIUS * c).round())
    };
    Input {
        points: radii.iter().enumerate().map(point).collect(),
        edges: (0..n).map(|i| [i, (i + 1) % n]).collect(),
    }
}

/// Distances from the centre, from 0.25 to 1: between two of them, the middle one is moved at random by up to
/// a quarter of their distance along the boundary, and so on.
fn radii(n: usize, random: &mut Random) -> Vec<f64> {
    let levels = n.next_power_of_two();
    let mut radii = vec![0.6; levels + 1];
    let mut step = levels;
    while step > 1 {
        let reach = 0.5 * step as f64 / levels as f64;
        for middle in (step / 2..levels).step_by(step) {
            let mean = (radii[middle - step / 2] + radii[middle + step / 2]) / 2.0;
            let moved = mean + reach * (2.0 * random.unit() - 1.0);
            radii[middle] = moved.clamp(0.25, 1.0);
        }
        step /= 2;
    }
    radii.truncate(n);
    radii
}

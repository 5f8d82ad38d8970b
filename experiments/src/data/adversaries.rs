//! Inputs made against one structure or another: long fronts, searched at places that it does not expect.

use sweep_cdt_testing::{Input, Random};

use super::points::{numbers, only};

/// A row of half the points, a unit apart: it stays on the front until something comes above it.
fn row(n: usize) -> Vec<[f64; 2]> {
    numbers(n / 2).map(|x| [x, 0.0]).collect()
}

/// Against a walk from the last node.
pub(super) fn alternating(n: usize, random: &mut Random) -> Input {
    let mut points = row(n);
    let width = points.len() as f64;
    for i in 0..n / 2 {
        let from_end = width / 4.0 * random.unit();
        let x = if i % 2 == 0 {
            from_end
        } else {
            width - from_end
        };
        points.push([x, 1.0 + i as f64]);
    }
    only(points)
}

/// Against a table whose intervals hold many nodes of the front.
pub(super) fn above_a_row(n: usize, random: &mut Random) -> Input {
    let mut points = row(n);
    let width = points.len() as f64;
    let above = numbers(n / 2).map(|i| [width * random.unit(), 1.0 + i]);
    points.extend(above);
    only(points)
}

/// Against equal intervals of x.
pub(super) fn outliers(n: usize, random: &mut Random) -> Input {
    let mut input = above_a_row(n, random);
    let far = 1e6 * n as f64;
    input.points.extend([[-far, 0.5], [far, 0.5]]);
    input
}

/// Against a sorted array: each update moves all entries.
pub(super) fn leftwards(n: usize, _: &mut Random) -> Input {
    let count = n as f64;
    only(numbers(n).map(|i| [-i, i * i / count]).collect())
}

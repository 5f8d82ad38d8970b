//! Points without edges: all over a square, on curves, and made against a search structure.
//!
//! The points of the square lie evenly, in clusters, on a lattice, or in rows and columns. What is made against a
//! structure has a long front, searched at places that it does not expect.

use super::random::Random;
use sweep_cdt::Pslg;

pub(super) fn uniform(n: usize, random: &mut Random) -> Pslg<f64> {
    only(random.points(n))
}

pub(super) fn integers(n: usize, random: &mut Random) -> Pslg<f64> {
    let mut coordinate = || random.below(1_000_000) as f64;
    only((0..n).map(|_| [coordinate(), coordinate()]).collect())
}

/// How many clusters, and how many of them are each half as wide as the one before.
const CLUSTERS: usize = 20;
const WIDTHS: usize = 10;

pub(super) fn clusters(n: usize, random: &mut Random) -> Pslg<f64> {
    let centres = random.points(CLUSTERS);
    let widths: Vec<f64> = (0..CLUSTERS)
        .map(|i| 0.2 / f64::from(1 << (i % WIDTHS)))
        .collect();
    let mut point = |i: usize| {
        // The mean of four numbers is denser in the middle.
        let mut offset = || (0..4).map(|_| random.unit()).sum::<f64>() / 4.0 - 0.5;
        let cluster = i % CLUSTERS;
        centres[cluster].map(|x| x + widths[cluster] * offset())
    };
    only((0..n).map(&mut point).collect())
}

pub(super) fn power_law(n: usize, random: &mut Random) -> Pslg<f64> {
    let mut coordinate = || {
        let u = random.integer(1 << 52) / (1_u64 << 52) as f64;
        let square = u * u;
        square * square * square * u
    };
    only((0..n).map(|_| [coordinate(), coordinate()]).collect())
}

pub(super) fn lattice(n: usize, _: &mut Random) -> Pslg<f64> {
    let side = n.isqrt();
    let row = |y| numbers(side).map(move |x| [x, y]);
    only(numbers(side).flat_map(row).collect())
}

pub(super) fn shuffled_lattice(n: usize, random: &mut Random) -> Pslg<f64> {
    let mut input = lattice(n, random);
    random.shuffle(&mut input.points);
    input
}

/// How many rows and columns.
const LINES: usize = 16;

pub(super) fn rows(n: usize, random: &mut Random) -> Pslg<f64> {
    let spread = 1.0 / LINES as f64;
    let mut point = |i: usize| [random.unit(), (i % LINES) as f64 * spread];
    only((0..n).map(&mut point).collect())
}

pub(super) fn columns(n: usize, random: &mut Random) -> Pslg<f64> {
    let mut input = rows(n, random);
    for point in &mut input.points {
        point.reverse();
    }
    input
}

/// The direction of a quarter turn's part `t`, from 0 to 1, in quadrant 0 to 3: a rational point of the unit
/// circle, rounded.
pub(super) fn direction(quadrant: usize, t: f64) -> [f64; 2] {
    let square = t * t;
    let [x, y] = [(1.0 - square) / (1.0 + square), 2.0 * t / (1.0 + square)];
    [[x, y], [-y, x], [-x, -y], [y, -x]][quadrant % 4]
}

pub(super) fn circle(n: usize, random: &mut Random) -> Pslg<f64> {
    let mut point = |i: usize| direction(i, random.unit());
    only((0..n).map(&mut point).collect())
}

pub(super) fn parabola_up(n: usize, _: &mut Random) -> Pslg<f64> {
    let middle = n as f64 / 2.0;
    let point = |i: f64| [i - middle, (i - middle) * (i - middle)];
    only(numbers(n).map(point).collect())
}

pub(super) fn parabola_right(n: usize, random: &mut Random) -> Pslg<f64> {
    let mut input = parabola_up(n, random);
    for point in &mut input.points {
        point.reverse();
    }
    input
}

/// A row of half the points, a unit apart: it stays on the front until something comes above it.
fn row(n: usize) -> Vec<[f64; 2]> {
    numbers((n / 2).max(1)).map(|x| [x, 0.0]).collect()
}

/// Against a walk from the last node.
pub(super) fn alternating(n: usize, random: &mut Random) -> Pslg<f64> {
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
pub(super) fn above_a_row(n: usize, random: &mut Random) -> Pslg<f64> {
    let mut points = row(n);
    let width = points.len() as f64;
    let above = numbers(n / 2).map(|i| [width * random.unit(), 1.0 + i]);
    points.extend(above);
    only(points)
}

/// Against a table of intervals: each tower has a short front, so its intervals are empty, and the node that joined last
/// is beyond the row.
pub(super) fn towers(n: usize, random: &mut Random) -> Pslg<f64> {
    let mut points = row(n);
    let width = points.len() as f64;
    for i in 0..n / 2 {
        let from_row = 1.0 + width * random.unit();
        let x = if i % 2 == 0 {
            -from_row
        } else {
            width + from_row
        };
        points.push([x, n as f64 * (1.0 + i as f64)]);
    }
    only(points)
}

/// Against equal intervals of x.
pub(super) fn outliers(n: usize, random: &mut Random) -> Pslg<f64> {
    let mut input = above_a_row(n, random);
    let far = 1e6 * n as f64;
    input.points.extend([[-far, 0.5], [far, 0.5]]);
    input
}

/// Against a sorted array: each update moves all entries.
pub(super) fn leftwards(n: usize, _: &mut Random) -> Pslg<f64> {
    let count = n as f64;
    only(numbers(n).map(|i| [-i, i * i / count]).collect())
}

/// Points without edges.
fn only(points: Vec<[f64; 2]>) -> Pslg<f64> {
    Pslg {
        points,
        ..Pslg::default()
    }
}

/// Numbers 0 to n - 1 as doubles.
pub(super) fn numbers(n: usize) -> impl Iterator<Item = f64> {
    (0..n).map(|i| i as f64)
}

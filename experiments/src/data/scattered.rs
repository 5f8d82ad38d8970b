//! Points all over a square: evenly, in clusters, on a lattice, in rows and columns.

use sweep_cdt_testing::{Input, Random};

use super::points::{numbers, only};

pub(super) fn uniform(n: usize, random: &mut Random) -> Input {
    only(random.points(n))
}

pub(super) fn integers(n: usize, random: &mut Random) -> Input {
    let mut coordinate = || random.below(1_000_000) as f64;
    only((0..n).map(|_| [coordinate(), coordinate()]).collect())
}

/// How many clusters, and how many of them are each half as wide as the one before.
const CLUSTERS: usize = 20;
const WIDTHS: usize = 10;

pub(super) fn clusters(n: usize, random: &mut Random) -> Input {
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

pub(super) fn power_law(n: usize, random: &mut Random) -> Input {
    let mut coordinate = || {
        let u = random.integer(1 << 52) / (1_u64 << 52) as f64;
        let square = u * u;
        square * square * square * u
    };
    only((0..n).map(|_| [coordinate(), coordinate()]).collect())
}

pub(super) fn lattice(n: usize, _: &mut Random) -> Input {
    let side = n.isqrt();
    let row = |y| numbers(side).map(move |x| [x, y]);
    only(numbers(side).flat_map(row).collect())
}

pub(super) fn shuffled_lattice(n: usize, random: &mut Random) -> Input {
    let mut input = lattice(n, random);
    random.shuffle(&mut input.points);
    input
}

/// How many rows and columns.
const LINES: usize = 16;

pub(super) fn rows(n: usize, random: &mut Random) -> Input {
    let spread = 1.0 / LINES as f64;
    let mut point = |i: usize| [random.unit(), (i % LINES) as f64 * spread];
    only((0..n).map(&mut point).collect())
}

pub(super) fn columns(n: usize, random: &mut Random) -> Input {
    let mut input = rows(n, random);
    for point in &mut input.points {
        point.reverse();
    }
    input
}

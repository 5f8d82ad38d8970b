//! Random inputs from a seed: random bytes for the generators of degenerate inputs, and larger ones.

use sweep_cdt_testing::Input;
use sweep_cdt_testing::generators::{drop_crossings, input};

use sweep_cdt_testing::Random;

/// A small degenerate input, of up to about a dozen points.
pub(crate) fn small(random: &mut Random) -> Input {
    let mut bytes = random.bytes(5);
    // The third byte is the number of points.
    bytes[2] %= 13;
    let more = 4 + random.below(40);
    bytes.extend(random.bytes(more));
    input(&bytes)
}

/// Uniform points, a lattice, few columns or few rows, with a few long edges and many short ones that
/// do not cross: hundreds of both, pseudo-polygons full of edges that end in them.
pub(crate) fn medium(random: &mut Random) -> Input {
    let (width, height) = random.pick(&[(1 << 20, 1 << 20), (9, 9), (40, 15), (3, 200), (200, 3)]);
    let n = 100 + random.below(300);
    let mut input = Input::default();
    for _ in 0..n {
        input
            .points
            .push([random.integer(width), random.integer(height)]);
    }
    for _ in 0..random.below(8) {
        input.edges.push([random.below(n), random.below(n)]);
    }
    let tries = random.pick(&[1, 5, 50]);
    for _ in 0..random.below(n) {
        let a = random.below(n);
        let distance = |b: usize| {
            let [x, y] = [0, 1].map(|i| input.points[a][i] - input.points[b][i]);
            x.hypot(y)
        };
        let others: Vec<usize> = (0..tries)
            .map(|_| random.below(n))
            .filter(|&b| b != a)
            .collect();
        let nearest = others
            .into_iter()
            .min_by(|&b, &c| distance(b).total_cmp(&distance(c)));
        input.edges.extend(nearest.map(|b| [a, b]));
    }
    drop_crossings(&input.points, &mut input.edges);
    input
}

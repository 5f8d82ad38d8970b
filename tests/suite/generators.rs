//! Seeded random inputs: bytes by chance for the generators of degenerate ones, and larger ones.

use sweep_cdt_properties::Input;
use sweep_cdt_properties::generators::{drop_crossings, input};

/// Steele, Lea and Flood's `SplitMix64`: small, and the same on every platform.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Random {
        Random(seed)
    }

    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number from 0 to `below` - 1.
    pub(crate) fn below(&mut self, below: usize) -> usize {
        usize::try_from(self.next() % below as u64).expect("fits as `below` does")
    }

    /// An integer from `-limit` to `limit`, as a double.
    pub(crate) fn integer(&mut self, limit: u32) -> f64 {
        let offset = self.next() % (2 * u64::from(limit) + 1);
        f64::from(u32::try_from(offset).expect("as small as `limit`")) - f64::from(limit)
    }

    pub(crate) fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    pub(crate) fn pick<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len())]
    }

    pub(crate) fn shuffle<T>(&mut self, list: &mut [T]) {
        for i in (1..list.len()).rev() {
            list.swap(i, self.below(i + 1));
        }
    }

    pub(crate) fn bytes(&mut self, n: usize) -> Vec<u8> {
        (0..n).map(|_| self.next().to_le_bytes()[0]).collect()
    }
}

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

//! Seeded random inputs of every degenerate kind, small ones and, in `medium`, larger ones.
//!
//! A small input is points of one kind, then edges, then disguises: points and edges shuffled, edge ends
//! swapped, the whole mirrored, turned by 90 degrees or scaled by a power of two. Mostly the crossing edges are
//! dropped, one of each pair; sometimes they stay.

mod medium;
mod points;

use crate::input::Input;
use crate::oracle::{Graph, Integers, integers};

pub(crate) use medium::medium;
pub(crate) use points::{Kind, points};

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

    /// Some kind of input.
    pub(crate) fn kind(&mut self) -> Kind {
        self.pick(Kind::ALL)
    }
}

/// A small input of this kind.
pub(crate) fn generate(kind: Kind, random: &mut Random) -> Input {
    let mut input = Input {
        points: points(kind, random),
        edges: Vec::new(),
    };
    input.edges = edges(input.points.len(), random);
    if !random.one_in(4) {
        drop_crossings(&mut input);
    }
    disguise(&mut input, random);
    input
}

/// Random edges between `n` points, in one of a few patterns.
fn edges(n: usize, random: &mut Random) -> Vec<[usize; 2]> {
    if n == 0 {
        return Vec::new();
    }
    let count = random.below(2 * n);
    let hub = random.below(n);
    let pattern = random.below(5);
    let mut edges: Vec<[usize; 2]> = (0..count)
        .map(|i| match pattern {
            // A fan, a path in the order of making, a closed polygon, the rest at random.
            0 => [hub, random.below(n)],
            1 => [i % n, (i + 1).min(n - 1)],
            2 => [i % n, (i + 1) % n],
            _ => [random.below(n), random.below(n)],
        })
        .collect();
    if random.one_in(4) && !edges.is_empty() {
        let again = random.pick(&edges);
        edges.push(again);
    }
    edges
}

/// Drops one edge of each pair that crosses.
fn drop_crossings(input: &mut Input) {
    let crossings = match integers(&input.points) {
        Integers::Small(points) => Graph::new(&points, &input.edges).crossings(),
        Integers::Big(points) => Graph::new(&points, &input.edges).crossings(),
    };
    let mut keep = vec![true; input.edges.len()];
    for [e, f] in crossings {
        if keep[e] {
            keep[f] = false;
        }
    }
    let mut kept = keep.into_iter();
    input.edges.retain(|_| kept.next() == Some(true));
}

fn disguise(input: &mut Input, random: &mut Random) {
    let mut order: Vec<usize> = (0..input.points.len()).collect();
    random.shuffle(&mut order);
    *input = permuted(input, &order);
    random.shuffle(&mut input.edges);
    for edge in &mut input.edges {
        if random.one_in(2) {
            edge.reverse();
        }
    }
    let [mirrored, turned] = [random.one_in(2), random.one_in(2)];
    let scale = if random.one_in(4) {
        2f64.powi(random.pick(&[-40, -3, 17, 60]))
    } else {
        1.0
    };
    // What would under- or overflow stays as it is.
    let is_exact = |x: &f64| (x * scale / scale).total_cmp(x).is_eq();
    let scale = if input.points.iter().flatten().all(is_exact) {
        scale
    } else {
        1.0
    };
    for point in &mut input.points {
        *point = point.map(|x| x * scale);
        if mirrored {
            point[0] = -point[0];
        }
        if turned {
            *point = [-point[1], point[0]];
        }
    }
}

/// The same input with point `order[i]` as point `i`.
pub(crate) fn permuted(input: &Input, order: &[usize]) -> Input {
    let mut place = vec![0; order.len()];
    for (i, &v) in order.iter().enumerate() {
        place[v] = i;
    }
    Input {
        points: order.iter().map(|&v| input.points[v]).collect(),
        edges: input
            .edges
            .iter()
            .map(|edge| edge.map(|v| place[v]))
            .collect(),
    }
}

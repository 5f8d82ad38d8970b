//! Points with edges of simple kinds.

use sweep_cdt_testing::{Input, Random};

use super::points::numbers;

pub(super) fn comb(n: usize, _: &mut Random) -> Input {
    let height = n as f64;
    let point = |i: f64| [i, if i % 4.0 < 2.0 { height } else { i / height }];
    Input {
        points: numbers(n).map(point).collect(),
        edges: (1..n).map(|i| [i - 1, i]).collect(),
    }
}

/// How many edges a fan has.
const SPOKES: usize = 100;

pub(super) fn fans(n: usize, random: &mut Random) -> Input {
    let mut input = Input::default();
    for fan in numbers(n.div_ceil(SPOKES + 1)) {
        let hub = input.points.len();
        let left = fan * SPOKES as f64;
        let height = SPOKES as f64;
        input.points.push([left + height / 2.0, height]);
        for spoke in numbers(SPOKES) {
            input.edges.push([hub, input.points.len()]);
            input.points.push([left + spoke, random.unit()]);
        }
    }
    input
}

pub(super) fn asterisk(n: usize, random: &mut Random) -> Input {
    // Opposite ends are exact mirror images, so that every edge passes through the centre.
    let mut ends: Vec<[f64; 2]> = (0..n / 2)
        .map(|_| [random.integer(1 << 20), random.integer(1 << 20)])
        .collect();
    let half = ends.len();
    ends.extend_from_within(..);
    for end in &mut ends[half..] {
        *end = end.map(|x| -x);
    }
    ends.push([0.0, 0.0]);
    Input {
        points: ends,
        edges: (0..half).map(|i| [i, i + half]).collect(),
    }
}

pub(super) fn segments(n: usize, random: &mut Random) -> Input {
    // One within each cell of a lattice.
    let side = (n / 2).isqrt();
    let mut input = Input::default();
    for y in numbers(side) {
        for x in numbers(side) {
            let first = input.points.len();
            input.edges.push([first, first + 1]);
            for _ in 0..2 {
                input.points.push([x + random.unit(), y + random.unit()]);
            }
        }
    }
    input
}

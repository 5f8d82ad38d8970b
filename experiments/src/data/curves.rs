//! Points on curves.

use sweep_cdt_testing::{Input, Random};

use super::points::{numbers, only};

/// The direction of a quarter turn's part `t`, from 0 to 1, in quadrant 0 to 3: a rational point of the unit
/// circle, rounded.
pub(super) fn direction(quadrant: usize, t: f64) -> [f64; 2] {
    let square = t * t;
    let [x, y] = [(1.0 - square) / (1.0 + square), 2.0 * t / (1.0 + square)];
    [[x, y], [-y, x], [-x, -y], [y, -x]][quadrant % 4]
}

pub(super) fn circle(n: usize, random: &mut Random) -> Input {
    let mut point = |i: usize| direction(i, random.unit());
    only((0..n).map(&mut point).collect())
}

pub(super) fn parabola_up(n: usize, _: &mut Random) -> Input {
    let middle = n as f64 / 2.0;
    let point = |i: f64| [i - middle, (i - middle) * (i - middle)];
    only(numbers(n).map(point).collect())
}

pub(super) fn parabola_right(n: usize, random: &mut Random) -> Input {
    let mut input = parabola_up(n, random);
    for point in &mut input.points {
        point.reverse();
    }
    input
}

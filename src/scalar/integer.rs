//! `i32` and `i64`: exact for every value. `i32` goes as [`f64`](super::f64), which holds all its values. `i64` goes as
//! [`i128`](super::i128), in integers as wide as the differences require: machine integers of 64, 128 and 256 bits
//! where they hold the determinant ([`wide`]), else big integers. Other scalars use these integers too.
//! Cost: 5 to 15 ns for a test; a microsecond in big integers, only for in-circle tests with differences above 2^61.

use alloc::vec::Vec;
use core::cmp::Ordering;

use num_bigint::BigInt;

use super::forward::forward;
use super::{Scalar, Stage, all_doubles, determinants, wide};

impl Scalar for i64 {
    fn approx(&self) -> f64 {
        *self as f64
    }

    fn as_doubles(points: &[[Self; 2]]) -> Option<Vec<[f64; 2]>> {
        all_doubles(points, |x| {
            (x.unsigned_abs() <= 1 << 53).then(|| x.approx())
        })
    }

    fn difference(&self, other: &Self) -> Option<(f64, i64)> {
        i128::from(*self).difference(&i128::from(*other))
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.cmp(other)
    }

    forward!(predicates: i128, |&x: &i64| i128::from(x));

    forward!(sizes: i128, |&x: &i64| i128::from(x));
}

impl Scalar for i32 {
    const APPROX_IS_EXACT: bool = true;

    fn approx(&self) -> f64 {
        f64::from(*self)
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.cmp(other)
    }

    forward!(predicates: f64, |&x: &i32| f64::from(x));
}

/// The sign of the turn from `a` to `b`, two differences to the same point, and the stage that decided it.
pub(super) fn turn(a: [i128; 2], b: [i128; 2]) -> (Ordering, Stage) {
    match (a[0].checked_mul(b[1]), a[1].checked_mul(b[0])) {
        (Some(left), Some(right)) => (left.cmp(&right), Stage::Integers),
        _ => {
            let [a, b] = [a, b].map(|row| row.map(BigInt::from));
            (determinants::turn(&a, &b), Stage::BigIntegers)
        }
    }
}

/// The in-circle sign from the differences of three points to a fourth, and the stage that decided it.
#[expect(clippy::cast_possible_truncation, reason = "only what is below 2^61")]
pub(super) fn in_circle(rows: [[i128; 2]; 3]) -> (Ordering, Stage) {
    let span = rows
        .iter()
        .flatten()
        .fold(0, |span, x| span | x.unsigned_abs());
    // Dividing all differences by a power of two changes no sign.
    let zeros = span.trailing_zeros() & 127;
    let rows = rows.map(|row| row.map(|x| x >> zeros));
    if span >> zeros < 1 << 61 {
        let sign = wide::in_circle(rows.map(|row| row.map(|x| x as i64)));
        (sign, Stage::Integers)
    } else {
        let rows = rows.map(|row| row.map(BigInt::from));
        let sign = determinants::determinant(&rows).cmp(&BigInt::ZERO);
        (sign, Stage::BigIntegers)
    }
}

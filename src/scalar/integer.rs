//! `i32`, `i64` and `i128`: exact for every value. `i32` goes as [`f64`](super::f64), which holds all its values, the others
//! in integers as wide as the differences require: machine integers of 64, 128 and 256 bits where they hold the determinant
//! ([`wide`]), else big integers. Other scalars use these integers too.
//! Cost: some dozens of machine instructions; big integers only for differences of more than 128 bits and, in circle,
//! above 2^61.

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
        all_doubles(points, |&x| double(i128::from(x)))
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

impl Scalar for i128 {
    fn approx(&self) -> f64 {
        *self as f64
    }

    fn as_doubles(points: &[[Self; 2]]) -> Option<Vec<[f64; 2]>> {
        all_doubles(points, |&x| double(x))
    }

    fn difference(&self, other: &Self) -> Option<(f64, i64)> {
        let size = self.abs_diff(*other) as f64;
        Some((if self < other { -size } else { size }, 0))
    }

    forward!(signs);

    fn compare(&self, other: &Self) -> Ordering {
        self.cmp(other)
    }

    fn orient2d_by_stage(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
        if let Some([a, b]) = differences([a, b], c) {
            return turn(a, b);
        }
        let [a, b, c] = big([a, b, c]);
        BigInt::orient2d_by_stage(&a, &b, &c)
    }

    fn in_circle_by_stage(
        a: &[Self; 2],
        b: &[Self; 2],
        c: &[Self; 2],
        d: &[Self; 2],
    ) -> (Ordering, Stage) {
        if let Some(rows) = differences([a, b, c], d) {
            return in_circle(rows);
        }
        let [a, b, c, d] = big([a, b, c, d]);
        BigInt::in_circle_by_stage(&a, &b, &c, &d)
    }

    forward!(sizes: BigInt, |&x: &i128| BigInt::from(x));
}

/// The double that equals a number, if it has no more than 53 bits.
fn double(x: i128) -> Option<f64> {
    (x.unsigned_abs() <= 1 << 53).then_some(x as f64)
}

/// The differences of points to a last one, if they fit in 128 bits.
fn differences<const N: usize>(
    points: [&[i128; 2]; N],
    last: &[i128; 2],
) -> Option<[[i128; 2]; N]> {
    let mut rows = [[0; 2]; N];
    for (row, point) in rows.iter_mut().zip(points) {
        for i in 0..2 {
            row[i] = point[i].checked_sub(last[i])?;
        }
    }
    Some(rows)
}

fn big<const N: usize>(points: [&[i128; 2]; N]) -> [[BigInt; 2]; N] {
    points.map(|point| point.map(BigInt::from))
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

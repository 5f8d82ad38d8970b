//! `i128`: exact for every value, as [`i64`](super::integer) in machine integers where they hold the determinant, else
//! in big integers. Differences of coordinates may need 129 bits, and are big integers then.
//! Cost: as for `i64` where the differences fit; some microseconds where they do not.

use alloc::vec::Vec;
use core::cmp::Ordering;

use num_bigint::BigInt;

use super::forward::forward;
use super::{Scalar, Stage, all_doubles, integer};

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

impl Scalar for i128 {
    fn approx(&self) -> f64 {
        *self as f64
    }

    fn as_doubles(points: &[[Self; 2]]) -> Option<Vec<[f64; 2]>> {
        all_doubles(points, |x| {
            (x.unsigned_abs() <= 1 << 53).then(|| x.approx())
        })
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
            return integer::turn(a, b);
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
            return integer::in_circle(rows);
        }
        let [a, b, c, d] = big([a, b, c, d]);
        BigInt::in_circle_by_stage(&a, &b, &c, &d)
    }

    forward!(sizes: BigInt, |&x: &i128| BigInt::from(x));
}

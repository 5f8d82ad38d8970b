//! `rug::Integer` (feature `rug`): the integers of GMP, rounded to doubles like [`rug::Rational`](super::rug).

use alloc::vec::Vec;
use core::cmp::Ordering;

use num_bigint::BigInt;
use rug::Integer;

use super::determinants::{determinant, minus, turn};
use super::forward::forward;
use super::rug::big;
use super::{Scalar, Stage, all_doubles};

impl Scalar for Integer {
    fn approx(&self) -> f64 {
        self.to_f64()
    }

    fn as_doubles(points: &[[Self; 2]]) -> Option<Vec<[f64; 2]>> {
        all_doubles(points, |x| (x.significant_bits() <= 53).then(|| x.approx()))
    }

    fn difference(&self, other: &Self) -> Option<(f64, i64)> {
        let (x, power) = Integer::from(self - other).to_f64_exp();
        Some((x, i64::from(power)))
    }

    forward!(signs);

    fn compare(&self, other: &Self) -> Ordering {
        self.cmp(other)
    }

    fn orient2d_by_stage(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
        (turn(&minus(a, c), &minus(b, c)), Stage::Own)
    }

    fn in_circle_by_stage(
        a: &[Self; 2],
        b: &[Self; 2],
        c: &[Self; 2],
        d: &[Self; 2],
    ) -> (Ordering, Stage) {
        (
            determinant(&[a, b, c].map(|p| minus(p, d))).cmp0(),
            Stage::Own,
        )
    }

    forward!(sizes: BigInt, big);
}

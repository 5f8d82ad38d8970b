//! `rug::Integer` (feature `rug`): the integers of GMP, behind the floating-point [filter](super::filter).
//!
//! `to_f64` and `to_f64_exp` round towards zero: monotone, and off by less than one unit in the last place, which
//! is what [`approx`](Scalar::approx) and [`difference`](Scalar::difference) must be.

use std::cmp::Ordering;

use num_bigint::BigInt;
use rug::Integer;

use super::rug::{area, big, determinant};
use super::{Scalar, Stage, all_doubles, filtered_in_circle, filtered_orient2d};

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

    fn compare(&self, other: &Self) -> Ordering {
        self.cmp(other)
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
        filtered_orient2d([a, b, c])
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
        filtered_in_circle([a, b, c, d])
    }

    fn depth(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Option<f64> {
        let [a, b, c, d] = [a, b, c, d].map(|p| p.each_ref().map(big));
        BigInt::depth(&a, &b, &c, &d)
    }

    fn height(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Option<f64> {
        let [a, b, c] = [a, b, c].map(|p| p.each_ref().map(big));
        BigInt::height(&a, &b, &c)
    }

    fn orient2d_exact(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
        (area(a, b, c).cmp0(), Stage::Own)
    }

    fn in_circle_exact(
        a: &[Self; 2],
        b: &[Self; 2],
        c: &[Self; 2],
        d: &[Self; 2],
    ) -> (Ordering, Stage) {
        (determinant([a, b, c], d).cmp0(), Stage::Own)
    }
}

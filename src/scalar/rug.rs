//! `rug::Integer` and `rug::Rational` (feature `rug`): the numbers of GMP; rationals go as doubles where they are. `to_f64` rounds
//! towards zero: monotone, and off by less than one unit in the last place, as [`approx`](Scalar::approx) must be.

use alloc::vec::Vec;
use core::cmp::Ordering;

use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use rug::integer::Order;
use rug::{Integer, Rational};

use super::determinants::{self, Arithmetic};
use super::forward::forward;
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

    fn compare(&self, other: &Self) -> Ordering {
        self.cmp(other)
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
        determinants::orient2d([a, b, c])
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
        determinants::in_circle([a, b, c, d])
    }

    forward!(sizes: BigInt, big);
}

impl Scalar for Rational {
    fn approx(&self) -> f64 {
        self.to_f64()
    }

    fn as_doubles(points: &[[Self; 2]]) -> Option<Vec<[f64; 2]>> {
        all_doubles(points, |x| Some(x.approx()).filter(|double| x == double))
    }

    fn difference(&self, other: &Self) -> Option<(f64, i64)> {
        let (numerator, denominator) = Rational::from(self - other).into_numer_denom();
        // Enough bits for a quotient of 64 or 65.
        let bits = |x: &Integer| i64::from(x.significant_bits());
        let shift = 65 - bits(&numerator) + bits(&denominator);
        let size = u32::try_from(shift.unsigned_abs()).ok()?;
        let quotient = if shift < 0 {
            numerator / (denominator << size)
        } else {
            (numerator << size) / denominator
        };
        // The quotient and its double are both rounded towards zero.
        let (x, power) = quotient.to_f64_exp();
        Some((x, i64::from(power) - shift))
    }

    forward!(signs);

    fn compare(&self, other: &Self) -> Ordering {
        self.cmp(other)
    }

    fn orient2d_by_stage(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
        if let Some([a, b, c]) = doubles([a, b, c]) {
            return f64::orient2d_by_stage(&a, &b, &c);
        }
        (determinants::orient2d([a, b, c]), Stage::Own)
    }

    fn in_circle_by_stage(
        a: &[Self; 2],
        b: &[Self; 2],
        c: &[Self; 2],
        d: &[Self; 2],
    ) -> (Ordering, Stage) {
        if let Some([a, b, c, d]) = doubles([a, b, c, d]) {
            return f64::in_circle_by_stage(&a, &b, &c, &d);
        }
        (determinants::in_circle([a, b, c, d]), Stage::Own)
    }

    forward!(sizes: BigRational, pure);
}

/// The points in doubles, if these equal them.
fn doubles<const N: usize>(points: [&[Rational; 2]; N]) -> Option<[[f64; 2]; N]> {
    let doubles = points.map(|[x, y]| [x.approx(), y.approx()]);
    points
        .into_iter()
        .flatten()
        .zip(doubles.iter().flatten())
        .all(|(exact, double)| exact == double)
        .then_some(doubles)
}

fn pure(number: &Rational) -> BigRational {
    BigRational::new_raw(big(number.numer()), big(number.denom()))
}

fn big(integer: &Integer) -> BigInt {
    let sign = match integer.cmp0() {
        Ordering::Less => Sign::Minus,
        _ => Sign::Plus,
    };
    BigInt::from_bytes_le(sign, &integer.to_digits(Order::Lsf))
}

/// Implements [`Arithmetic`] in the memory of the left operand.
macro_rules! arithmetic {
    ($($number:ty),+) => { $(
        impl Arithmetic for $number {
            fn plus(self, other: Self) -> Self {
                self + other
            }

            fn minus(self, other: &Self) -> Self {
                self - other
            }

            fn times(self, other: &Self) -> Self {
                self * other
            }

            fn sign(&self) -> Ordering {
                self.cmp0()
            }
        }
    )+ };
}

arithmetic!(Integer, Rational);

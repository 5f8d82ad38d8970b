//! `rug::Rational` (feature `rug`): the rationals of GMP, behind the floating-point
//! [filter](super::filter); as doubles where the numbers are doubles.
//!
//! `to_f64` rounds towards zero: monotone, and off by less than one unit in the last place, which is
//! what [`approx`](Scalar::approx) must be.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use rug::integer::Order;
use rug::{Integer, Rational};

use super::{Scalar, Stage, all_doubles, filtered_in_circle, filtered_orient2d};

impl Scalar for Rational {
    fn approx(&self) -> f64 {
        self.to_f64()
    }

    fn as_doubles(points: &[[Self; 2]]) -> Option<Vec<[f64; 2]>> {
        all_doubles(points, |x| Some(x.approx()).filter(|double| x == double))
    }

    fn difference(&self, other: &Self) -> Option<(f64, i64)> {
        let (numerator, denominator) = Rational::from(self - other).into_numer_denom();
        // As many bits as make a quotient of 64 or 65.
        let bits = |x: &Integer| i64::from(x.significant_bits());
        let shift = 65 - bits(&numerator) + bits(&denominator);
        let size = u32::try_from(shift.unsigned_abs()).ok()?;
        let quotient = if shift < 0 {
            numerator / (denominator << size)
        } else {
            (numerator << size) / denominator
        };
        // Both the quotient and this are rounded towards zero.
        let (x, power) = quotient.to_f64_exp();
        Some((x, i64::from(power) - shift))
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
        let [a, b, c, d] = [a, b, c, d].map(|p| p.each_ref().map(pure));
        BigRational::depth(&a, &b, &c, &d)
    }

    fn height(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Option<f64> {
        let [a, b, c] = [a, b, c].map(|p| p.each_ref().map(pure));
        BigRational::height(&a, &b, &c)
    }

    fn orient2d_exact(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
        if let Some([a, b, c]) = doubles([a, b, c]) {
            return f64::orient2d_exact(&a, &b, &c);
        }
        (area(a, b, c).cmp0(), Stage::Own)
    }

    fn in_circle_exact(
        a: &[Self; 2],
        b: &[Self; 2],
        c: &[Self; 2],
        d: &[Self; 2],
    ) -> (Ordering, Stage) {
        if let Some([a, b, c, d]) = doubles([a, b, c, d]) {
            return f64::in_circle_exact(&a, &b, &c, &d);
        }
        (determinant([a, b, c], d).cmp0(), Stage::Own)
    }
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

/// The same number in pure Rust.
fn pure(number: &Rational) -> BigRational {
    BigRational::new_raw(big(number.numer()), big(number.denom()))
}

/// The same integer in pure Rust.
pub(super) fn big(integer: &Integer) -> BigInt {
    let sign = match integer.cmp0() {
        Ordering::Less => Sign::Minus,
        _ => Sign::Plus,
    };
    BigInt::from_bytes_le(sign, &integer.to_digits(Order::Lsf))
}

/// Numbers of GMP with the operators that determinants need.
pub(super) trait Gmp:
    Clone
    + Add<Output = Self>
    + Sub<Output = Self>
    + for<'a> Sub<&'a Self, Output = Self>
    + for<'a> Mul<&'a Self, Output = Self>
{
}

impl Gmp for Integer {}
impl Gmp for Rational {}

/// Twice the area of the triangle `a`, `b`, `c`.
pub(super) fn area<T: Gmp>(a: &[T; 2], b: &[T; 2], c: &[T; 2]) -> T {
    cross(&minus(a, c), &minus(b, c))
}

/// The in-circle determinant.
pub(super) fn determinant<T: Gmp>(points: [&[T; 2]; 3], d: &[T; 2]) -> T {
    let [a, b, c] = points.map(|p| minus(p, d));
    cross(&b, &c) * &lift(&a) + cross(&c, &a) * &lift(&b) + cross(&a, &b) * &lift(&c)
}

fn minus<T: Gmp>(a: &[T; 2], b: &[T; 2]) -> [T; 2] {
    [0, 1].map(|i| a[i].clone() - &b[i])
}

fn lift<T: Gmp>([x, y]: &[T; 2]) -> T {
    x.clone() * x + y.clone() * y
}

fn cross<T: Gmp>(p: &[T; 2], q: &[T; 2]) -> T {
    p[0].clone() * &q[1] - p[1].clone() * &q[0]
}

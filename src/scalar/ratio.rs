//! `Ratio<i64>`: fractions of machine integers, whose own arithmetic overflows and is not used.
//! Fractions are compared by products of 128 bits. They go as doubles where one common factor makes doubles of them,
//! else as [`BigRational`] (`super::rational`), which has integers of any size for the common denominator.
//! Why it is right: products of two numbers of 64 bits fit in 128. An approximation is the quotient of two integers to
//! at least 64 bits, rounded down, with the last bit set if anything is left. So it becomes the same double as the
//! exact quotient: the nearest one, monotone, and off by at most 2^-53 of it.
//! Cost: a division of 128 bits for an approximation; big integers where the filter decides nothing.

use alloc::vec::Vec;
use core::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};

use super::doubles::power;
use super::forward::forward;
use super::rational::{odd_part, odd_unit, whole};
use super::{Scalar, all_doubles};

/// Numerator and denominator, the latter made positive where `new_raw` left it negative.
fn parts(number: &Ratio<i64>) -> [i128; 2] {
    let (numerator, denominator) = (i128::from(*number.numer()), i128::from(*number.denom()));
    if denominator < 0 {
        [-numerator, -denominator]
    } else {
        [numerator, denominator]
    }
}

fn big(number: &Ratio<i64>) -> BigRational {
    let [numerator, denominator] = parts(number).map(BigInt::from);
    BigRational::new_raw(numerator, denominator)
}

impl Scalar for Ratio<i64> {
    /// Whether the denominator is not zero, as `new_raw` may make it.
    fn is_finite(&self) -> bool {
        *self.denom() != 0
    }

    fn approx(&self) -> f64 {
        let [numerator, denominator] = parts(self);
        let size = numerator.unsigned_abs();
        let shift = size.leading_zeros().saturating_sub(1);
        let (size, denominator) = (size << (shift & 127), denominator.unsigned_abs());
        let whole = size / denominator;
        let quotient = (whole | u128::from(whole * denominator != size)) as f64;
        let quotient = quotient * power(-i64::from(shift));
        if numerator < 0 { -quotient } else { quotient }
    }

    fn as_doubles(points: &[[Self; 2]]) -> Option<Vec<[f64; 2]>> {
        let small = |x: &Self| u128::try_from(*x.denom()).ok().and_then(odd_part);
        let unit = odd_unit(points.as_flattened().iter().map(small))?;
        all_doubles(points, |x| whole(i128::from(*x.numer()), small(x)?, unit))
    }

    fn difference(&self, other: &Self) -> Option<(f64, i64)> {
        big(self).difference(&big(other))
    }

    fn compare(&self, other: &Self) -> Ordering {
        let ([a, b], [c, d]) = (parts(self), parts(other));
        (a * d).cmp(&(c * b))
    }

    forward!(predicates: BigRational, big);

    forward!(sizes: BigRational, big);
}

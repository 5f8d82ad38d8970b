//! `BigRational`: as doubles where the numbers are doubles, else in integers over a common denominator.
//! Why it is right: a factor other than zero for all coordinates multiplies the determinants by its square or fourth
//! power, and changes no sign. A common multiple of the denominators, of either sign, makes integers of all, without
//! fractions and greatest common divisors. Decimals or thirds stay small, for machine integers ([`integer`]).
//! Cost: six or eight conversions to doubles; big integers where the filter decides nothing.

use alloc::vec::Vec;
use core::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{One, ToPrimitive, Zero};

use super::determinants::{determinant, minus, turn};
use super::forward::forward;
use super::unbounded::approx_quotient;
use super::{Scalar, Stage, all_doubles, integer};

impl Scalar for BigRational {
    /// Whether the denominator is not zero, as `new_raw` may make it.
    fn is_finite(&self) -> bool {
        !self.denom().is_zero()
    }

    fn approx(&self) -> f64 {
        double(self).unwrap_or_else(|| self.to_f64().expect("a finite number has a double near it"))
    }

    fn as_doubles(points: &[[Self; 2]]) -> Option<Vec<[f64; 2]>> {
        let small = |x: &Self| x.denom().to_u128().and_then(odd_part);
        let unit = odd_unit(points.as_flattened().iter().map(small))?;
        if unit == 1 {
            all_doubles(points, double)
        } else {
            all_doubles(points, |x| whole(x.numer().to_i128()?, small(x)?, unit))
        }
    }

    fn difference(&self, other: &Self) -> Option<(f64, i64)> {
        let ([a, b], [c, d]) = ([self.numer(), self.denom()], [other.numer(), other.denom()]);
        Some(if b == d {
            approx_quotient(&(a - c), b)
        } else {
            approx_quotient(&(a * d - c * b), &(b * d))
        })
    }

    forward!(signs);

    fn compare(&self, other: &Self) -> Ordering {
        self.cmp(other)
    }

    fn orient2d_by_stage(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
        let points = [a, b, c];
        if let Some([a, b, c]) = doubles(points) {
            return f64::orient2d_by_stage(&a, &b, &c);
        }
        let ([a, b, c], _) = integers(points);
        let rows = [minus(&a, &c), minus(&b, &c)];
        match small(&rows) {
            Some([a, b]) => integer::turn(a, b),
            None => (turn(&rows[0], &rows[1]), Stage::BigIntegers),
        }
    }

    fn in_circle_by_stage(
        a: &[Self; 2],
        b: &[Self; 2],
        c: &[Self; 2],
        d: &[Self; 2],
    ) -> (Ordering, Stage) {
        let points = [a, b, c, d];
        if let Some([a, b, c, d]) = doubles(points) {
            return f64::in_circle_by_stage(&a, &b, &c, &d);
        }
        let ([a, b, c, d], _) = integers(points);
        let rows = [a, b, c].map(|p| minus(&p, &d));
        match small(&rows) {
            Some(rows) => integer::in_circle(rows),
            None => (determinant(&rows).cmp(&BigInt::ZERO), Stage::BigIntegers),
        }
    }

    fn depth(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Option<f64> {
        let ([a, b, c, d], _) = integers([a, b, c, d]);
        BigInt::depth(&a, &b, &c, &d)
    }

    fn height(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Option<f64> {
        let ([a, b, c], _) = integers([a, b, c]);
        BigInt::height(&a, &b, &c)
    }
}

/// The double that equals the number, if there is one of moderate size.
fn double(number: &BigRational) -> Option<f64> {
    let (numer, denom) = (number.numer(), number.denom());
    let zeros = |x: &BigInt| x.trailing_zeros().unwrap_or(0);
    let is_double = denom.bits() == zeros(denom) + 1
        && numer.bits() <= zeros(numer) + 53
        && numer.bits().max(denom.bits()) <= 1000;
    if is_double {
        Some(numer.to_f64()? / denom.to_f64()?)
    } else {
        None
    }
}

/// The least common multiple of the odd parts of all denominators: times this number, all are whole but for powers of
/// two. `None` if it or a denominator is large, negative or zero.
pub(super) fn odd_unit(parts: impl Iterator<Item = Option<(u128, u32)>>) -> Option<u64> {
    let mut unit = 1;
    for part in parts {
        let odd = u64::try_from(part?.0).ok()?;
        if unit % odd != 0 {
            let least = Ratio::new(unit, odd);
            unit = unit.checked_mul(*least.denom())?;
        }
    }
    Some(unit)
}

/// The odd part of a denominator, and the exponent of the power of two in it; `None` for zero.
pub(super) fn odd_part(denominator: u128) -> Option<(u128, u32)> {
    let zeros = denominator.trailing_zeros();
    (denominator > 0).then(|| (denominator >> zeros, zeros))
}

/// The double of moderate size, if any, that equals a fraction of this denominator times `unit`, a multiple of `odd`.
pub(super) fn whole(numerator: i128, (odd, zeros): (u128, u32), unit: u64) -> Option<f64> {
    let factor = (u128::from(unit) / odd).cast_signed();
    let product = numerator.checked_mul(factor)?;
    let is_double = product.unsigned_abs() >> product.trailing_zeros().min(127) < 1 << 53;
    is_double.then(|| product as f64 / (1_u128 << zeros) as f64)
}

/// The points in doubles, if these equal them.
fn doubles<const N: usize>(points: [&[BigRational; 2]; N]) -> Option<[[f64; 2]; N]> {
    let mut result = [[0.0; 2]; N];
    for (to, number) in result
        .iter_mut()
        .flatten()
        .zip(points.into_iter().flatten())
    {
        *to = double(number)?;
    }
    Some(result)
}

/// The points times a common multiple of their denominators (not always the least), and that multiple.
pub(crate) fn integers<const N: usize>(
    points: [&[BigRational; 2]; N],
) -> ([[BigInt; 2]; N], BigInt) {
    let mut unit = BigInt::one();
    for denominator in points.iter().flat_map(|p| p.iter()).map(BigRational::denom) {
        if !(&unit % denominator).is_zero() {
            let contains_unit = (denominator % &unit).is_zero();
            unit = if contains_unit {
                denominator.clone()
            } else {
                unit * denominator
            };
        }
    }
    let integers = points.map(|p| [0, 1].map(|i| p[i].numer() * (&unit / p[i].denom())));
    (integers, unit)
}

fn small<const N: usize>(rows: &[[BigInt; 2]; N]) -> Option<[[i128; 2]; N]> {
    let mut result = [[0; 2]; N];
    for (small, big) in result.iter_mut().flatten().zip(rows.iter().flatten()) {
        *small = big.to_i128()?;
    }
    Some(result)
}

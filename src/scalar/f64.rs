//! `f64`: exact for every finite double, in four stages, each only where the one before decides nothing.
//!
//! 1. The [filter](super::filter): most signs.
//! 2. Machine integers. If all differences are exact and multiples of a power of two less than 2^30
//!    times as large as it, in 64 and 128 bits ([`narrow`]): ties on lattices, in about 15 ns. If not, but
//!    all coordinates are multiples of a power of two less than 2^61 times as large, in up to 256 bits
//!    ([`integers`]): most near-ties of other points, since coordinates of 53 bits may still differ by
//!    2^8 in size, in about 50 ns.
//! 3. The adaptive expansions of Shewchuk (1997; crate `robust`), 300 to 700 ns on ties. They are exact
//!    while nothing under- or overflows, which holds if every coordinate is zero or within
//!    2^-142..=2^201 in size; coordinates outside are multiplied by a power of two first if that
//!    brings all of them in, exactly. They begin with a filter of their own, which the crate gives no
//!    way around; it costs some nanoseconds.
//! 4. Big integers: every finite double is an integer times a power of two. They take microseconds, and are
//!    needed only if sizes differ by a factor of more than 2^342.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::Zero;
use num_traits::float::FloatCore;
use robust::Coord;

use super::doubles::{exponent, power};
use super::{Scalar, Stage, direct, unbounded, wide};

impl Scalar for f64 {
    const APPROX_IS_EXACT: bool = true;

    fn is_finite(&self) -> bool {
        f64::is_finite(*self)
    }

    fn approx(&self) -> f64 {
        *self
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.partial_cmp(other).expect("coordinates are numbers")
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
        direct::orient2d([a, b, c])
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
        direct::in_circle([a, b, c, d])
    }

    #[cold]
    fn orient2d_exact(&a: &[Self; 2], &b: &[Self; 2], &c: &[Self; 2]) -> (Ordering, Stage) {
        if let Some([a, b]) = narrow([a, b], c) {
            return ((a[0] * b[1]).cmp(&(a[1] * b[0])), Stage::Integers);
        }
        let points = [a, b, c];
        let Some(points) = moderate(points) else {
            let [a, b, c] = big(points);
            let sign = unbounded::turn(&unbounded::minus(&a, &c), &unbounded::minus(&b, &c));
            return (sign, Stage::BigIntegers);
        };
        if let Some([a, b, c]) = integers(&points) {
            return wide::turn(minus(a, c), minus(b, c));
        }
        let [a, b, c] = points.map(|[x, y]| Coord { x, y });
        (sign(robust::orient2d(a, b, c)), Stage::Expansions)
    }

    #[cold]
    fn in_circle_exact(
        &a: &[Self; 2],
        &b: &[Self; 2],
        &c: &[Self; 2],
        &d: &[Self; 2],
    ) -> (Ordering, Stage) {
        if let Some(rows) = narrow([a, b, c], d) {
            return (wide::in_circle_narrow(rows), Stage::Integers);
        }
        let points = [a, b, c, d];
        let Some(points) = moderate(points) else {
            let [a, b, c, d] = big(points);
            let sign = unbounded::lifted(&[a, b, c].map(|p| unbounded::minus(&p, &d)));
            return (sign, Stage::BigIntegers);
        };
        if let Some([a, b, c, d]) = integers(&points) {
            return wide::in_circle([a, b, c].map(|p| minus(p, d)));
        }
        let [a, b, c, d] = points.map(|[x, y]| Coord { x, y });
        (sign(robust::incircle(a, b, c, d)), Stage::Expansions)
    }
}

/// The differences of points to a last one in units of a power of two, if they are exact and that makes
/// integers below 2^30 of them.
///
/// A difference d = a - b is exact if a - d is b and d + b is a, by the error term of Knuth's two-sum.
/// Adding 3 * 2^51 rounds to an integer and leaves it in the low bits.
#[expect(clippy::float_cmp, reason = "asks for exact equality")]
fn narrow<const N: usize>(points: [[f64; 2]; N], last: [f64; 2]) -> Option<[[i64; 2]; N]> {
    const SHIFTER: f64 = 3.0 * power(51);
    let rows = points.map(|p| [p[0] - last[0], p[1] - last[1]]);
    let exponent = exponent(largest(&rows).max(power(-900)));
    if exponent > 900 {
        return None;
    }
    let (unit, per_unit) = (power(exponent - 29), power(29 - exponent));
    let mut exact = true;
    let mut result = [[0; 2]; N];
    for (to, (row, point)) in result.iter_mut().zip(rows.iter().zip(&points)) {
        for i in 0..2 {
            let (a, b, d) = (point[i], last[i], row[i]);
            let shifted = d * per_unit + SHIFTER;
            exact &= a - d == b && d + b == a && (shifted - SHIFTER) * unit == d;
            to[i] = shifted.to_bits().cast_signed() - SHIFTER.to_bits().cast_signed();
        }
    }
    exact.then_some(result)
}

/// Whether the adaptive expansions neither under- nor overflow on this coordinate (Shewchuk 1997,
/// section 1): zero or of a size within 2^-142..=2^201.
fn is_moderate(x: f64) -> bool {
    x == 0.0 || (power(-142)..=power(201)).contains(&x.abs())
}

/// The points, scaled by a power of two if need be, with moderate coordinates only; `None` if there is
/// no such scale.
fn moderate<const N: usize>(points: [[f64; 2]; N]) -> Option<[[f64; 2]; N]> {
    if points.iter().flatten().all(|&x| is_moderate(x)) {
        return Some(points);
    }
    // Upwards every scaling is exact. Afterwards the largest size is a normal double.
    let lifted = if largest(&points) < power(-500) {
        scale(points, power(500))
    } else {
        points
    };
    // Scaling by this one is exact wherever the product is moderate.
    let scaled = scale(lifted, power(200 - exponent(largest(&lifted))));
    let survives = |(&x, &y): (&f64, &f64)| is_moderate(y) && (x == 0.0) == (y == 0.0);
    points
        .iter()
        .flatten()
        .zip(scaled.iter().flatten())
        .all(survives)
        .then_some(scaled)
}

fn scale<const N: usize>(points: [[f64; 2]; N], factor: f64) -> [[f64; 2]; N] {
    points.map(|point| point.map(|x| x * factor))
}

fn largest<const N: usize>(points: &[[f64; 2]; N]) -> f64 {
    points
        .iter()
        .flatten()
        .fold(0.0, |m: f64, x| m.max(x.abs()))
}

/// Moderate points in units of a power of two, if that makes integers below 2^61 of them.
#[expect(
    clippy::cast_possible_truncation,
    reason = "the products are below 2^61"
)]
#[expect(clippy::float_cmp, reason = "asks for exact equality")]
fn integers<const N: usize>(points: &[[f64; 2]; N]) -> Option<[[i64; 2]; N]> {
    let exponent = exponent(largest(points).max(power(-142)));
    let scaled = scale(*points, power(60 - exponent));
    let integers = scaled.map(|point| point.map(|x| x as i64));
    let exact = |(&i, &x): (&i64, &f64)| i as f64 == x;
    if !integers
        .iter()
        .flatten()
        .zip(scaled.iter().flatten())
        .all(exact)
    {
        return None;
    }
    Some(integers)
}

fn minus(a: [i64; 2], b: [i64; 2]) -> [i128; 2] {
    [i128::from(a[0] - b[0]), i128::from(a[1] - b[1])]
}

/// The points in units of a power of two that makes integers of all of them.
fn big<const N: usize>(points: [[f64; 2]; N]) -> [[BigInt; 2]; N] {
    let exponent = |x: f64| FloatCore::integer_decode(x).1;
    let nonzero = points.iter().flatten().filter(|x| !x.is_zero());
    let unit = nonzero.map(|&x| exponent(x)).min().unwrap_or(0);
    points.map(|point| {
        point.map(|x| {
            let (mantissa, exponent, sign) = FloatCore::integer_decode(x);
            let size = BigInt::from(mantissa) << exponent.saturating_sub(unit).max(0);
            size * sign
        })
    })
}

/// The sign of what the expansions return.
fn sign(determinant: f64) -> Ordering {
    determinant
        .partial_cmp(&0.0)
        .expect("finite points have a determinant")
}

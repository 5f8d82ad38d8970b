//! `f64`: exact for every finite double, in three stages, each only where the one before decides nothing.
//!
//! 1. Machine integers of 64 to 256 bits. If all coordinates are multiples of a power of two and less
//!    than 2^61 times as large, they are integers in that unit, as for most ties and near-ties: coordinates of 53 bits
//!    may still differ by 2^8 in size. If not, the differences are, where none is rounded and the largest is less than
//!    2^61 units: points close together that lie far from the origin along one axis only.
//! 2. The adaptive expansions of Shewchuk (1997; crate `robust`), ten times as slow on ties. They are exact while
//!    nothing under- or overflows, so if every coordinate is zero or within 2^-142..=2^201 in size. Coordinates outside
//!    are first multiplied by a power of two, if that brings all of them in exactly. The crate's own filter comes
//!    first and cannot be skipped.
//! 3. Big integers, for sizes farther apart than a factor of 2^342: doubles are integers in some unit.

use core::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::Zero;
use num_traits::float::FloatCore;
use robust::Coord;

use super::doubles::{exponent, power};
use super::forward::forward;
use super::integer_points::{largest, whole};
use super::{Scalar, Stage, wide};

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

    forward!(signs);

    #[cold]
    fn orient2d_by_stage(&a: &[Self; 2], &b: &[Self; 2], &c: &[Self; 2]) -> (Ordering, Stage) {
        if let Some([a, b]) = differences([a, b], c) {
            return (wide::turn(a, b), Stage::Integers);
        }
        let points = [a, b, c];
        let Some(points) = moderate(points) else {
            let [a, b, c] = big(points);
            return BigInt::orient2d_by_stage(&a, &b, &c);
        };
        let [a, b, c] = points.map(|[x, y]| Coord { x, y });
        (sign(robust::orient2d(a, b, c)), Stage::Expansions)
    }

    #[cold]
    fn in_circle_by_stage(
        &a: &[Self; 2],
        &b: &[Self; 2],
        &c: &[Self; 2],
        &d: &[Self; 2],
    ) -> (Ordering, Stage) {
        if let Some(rows) = differences([a, b, c], d) {
            return (wide::in_circle(rows), Stage::Integers);
        }
        let points = [a, b, c, d];
        let Some(points) = moderate(points) else {
            let [a, b, c, d] = big(points);
            return BigInt::in_circle_by_stage(&a, &b, &c, &d);
        };
        let [a, b, c, d] = points.map(|[x, y]| Coord { x, y });
        (sign(robust::incircle(a, b, c, d)), Stage::Expansions)
    }

    fn depth(&a: &[Self; 2], &b: &[Self; 2], &c: &[Self; 2], &d: &[Self; 2]) -> Option<f64> {
        let [a, b, c, d] = big([a, b, c, d]);
        BigInt::depth(&a, &b, &c, &d)
    }

    fn height(&a: &[Self; 2], &b: &[Self; 2], &c: &[Self; 2]) -> Option<f64> {
        let [a, b, c] = big([a, b, c]);
        BigInt::height(&a, &b, &c)
    }
}

/// The differences of points to a last one in units of some power of two, if that makes them integers below 2^62. A
/// difference d = a - b is exact if a - d is b and d + b is a, by the error term of Knuth's two-sum.
#[expect(clippy::float_cmp, reason = "asks for exact equality")]
fn differences<const N: usize>(points: [[f64; 2]; N], last: [f64; 2]) -> Option<[[i64; 2]; N]> {
    let size = largest(&points).max(largest(&[last]));
    let (rows, is_whole) = whole(&points, size);
    let ([to], is_last_whole) = whole(&[last], size);
    if is_whole && is_last_whole {
        return Some(rows.map(|p| [p[0] - to[0], p[1] - to[1]]));
    }
    let rows = points.map(|p| [p[0] - last[0], p[1] - last[1]]);
    let mut exact = true;
    for (row, point) in rows.iter().zip(&points) {
        for i in 0..2 {
            let (a, b, d) = (point[i], last[i], row[i]);
            exact &= a - d == b && d + b == a;
        }
    }
    let (rows, is_whole) = whole(&rows, largest(&rows));
    (exact && is_whole).then_some(rows)
}

/// Whether the adaptive expansions neither under- nor overflow on `x` (Shewchuk 1997, section 1).
fn is_moderate(x: f64) -> bool {
    x == 0.0 || (power(-142)..=power(201)).contains(&x.abs())
}

/// The points with moderate coordinates only, scaled by a power of two if need be; `None` if no scale will do.
fn moderate<const N: usize>(points: [[f64; 2]; N]) -> Option<[[f64; 2]; N]> {
    if points.iter().flatten().all(|&x| is_moderate(x)) {
        return Some(points);
    }
    // Scaling up is always exact. Afterwards the largest size is a normal double.
    let lifted = if largest(&points) < power(-500) {
        scale(points, power(500))
    } else {
        points
    };
    // Scaling by this factor is exact wherever the product is moderate.
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

/// The points in units of a power of two that makes integers of all coordinates.
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

fn sign(determinant: f64) -> Ordering {
    determinant
        .partial_cmp(&0.0)
        .expect("finite points have a determinant")
}

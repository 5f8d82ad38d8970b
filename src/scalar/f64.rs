//! `f64`: exact for every finite double, in four stages, each only where the one before decides nothing.
//!
//! 1. The [filter](super::filter): most signs.
//! 2. Machine integers. If all differences are exact and multiples of a power of two less than 2^30
//!    times as large as it, in 64 and 128 bits: ties on lattices, in about 15 ns. If they are less than 2^61
//!    times as large, or rounded but all coordinates are multiples of a power of two less than 2^61 times
//!    as large, in up to 256 bits: most near-ties of other points, since coordinates of 53 bits may still
//!    differ by 2^8 in size, in about 50 ns.
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
use super::{Scalar, Stage, filtered_in_circle, filtered_orient2d, integer, unbounded, wide};

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
        filtered_orient2d([a, b, c])
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
        filtered_in_circle([a, b, c, d])
    }

    fn depth(&a: &[Self; 2], &b: &[Self; 2], &c: &[Self; 2], &d: &[Self; 2]) -> Option<f64> {
        unbounded::depth(&big([a, b, c, d]))
    }

    fn height(&a: &[Self; 2], &b: &[Self; 2], &c: &[Self; 2]) -> Option<f64> {
        unbounded::height(&big([a, b, c]))
    }

    #[cold]
    fn orient2d_exact(&a: &[Self; 2], &b: &[Self; 2], &c: &[Self; 2]) -> (Ordering, Stage) {
        if let Some([a, b]) = Differences::of([a, b], c).and_then(|rows| rows.narrow()) {
            return ((a[0] * b[1]).cmp(&(a[1] * b[0])), Stage::Integers);
        }
        let points = [a, b, c];
        let Some(points) = moderate(points) else {
            let [a, b, c] = big(points);
            let sign = unbounded::turn(&unbounded::minus(&a, &c), &unbounded::minus(&b, &c));
            return (sign, Stage::BigIntegers);
        };
        if let Some([a, b, c]) = integers(&points) {
            return integer::turn(minus(a, c), minus(b, c));
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
        if let Some(differences) = Differences::of([a, b, c], d) {
            if let Some(rows) = differences.narrow() {
                return (wide::in_circle_narrow(rows), Stage::Integers);
            }
            if let Some(rows) = differences.wide() {
                let rows = rows.map(|row| row.map(i128::from));
                return (wide::in_circle_middle(rows), Stage::Integers);
            }
        }
        let points = [a, b, c, d];
        let Some(points) = moderate(points) else {
            let [a, b, c, d] = big(points);
            let sign = unbounded::lifted(&[a, b, c].map(|p| unbounded::minus(&p, &d)));
            return (sign, Stage::BigIntegers);
        };
        if let Some([a, b, c, d]) = integers(&points) {
            return integer::in_circle([a, b, c].map(|p| minus(p, d)));
        }
        let [a, b, c, d] = points.map(|[x, y]| Coord { x, y });
        (sign(robust::incircle(a, b, c, d)), Stage::Expansions)
    }
}

/// The differences of points to a last one, all of them exact.
struct Differences<const N: usize> {
    rows: [[f64; 2]; N],
    /// All are below 2^(`exponent` + 1) in size.
    exponent: i64,
}

impl<const N: usize> Differences<N> {
    /// The differences, if all are exact.
    ///
    /// A difference d = a - b is exact if a - d is b and d + b is a, by the error term of Knuth's two-sum.
    #[expect(clippy::float_cmp, reason = "asks for exact equality")]
    fn of(points: [[f64; 2]; N], last: [f64; 2]) -> Option<Self> {
        let rows = points.map(|p| [p[0] - last[0], p[1] - last[1]]);
        let exponent = exponent(largest(&rows).max(power(-900)));
        let mut exact = exponent <= 900;
        for (row, point) in rows.iter().zip(&points) {
            for i in 0..2 {
                let (a, b, d) = (point[i], last[i], row[i]);
                exact &= a - d == b && d + b == a;
            }
        }
        exact.then_some(Differences { rows, exponent })
    }

    /// In units of a power of two, if that makes integers below 2^30 of them.
    ///
    /// Adding 3 * 2^51 rounds to an integer and leaves it in the low bits.
    #[expect(clippy::float_cmp, reason = "asks for exact equality")]
    fn narrow(&self) -> Option<[[i64; 2]; N]> {
        const SHIFTER: f64 = 3.0 * power(51);
        let (unit, per_unit) = (power(self.exponent - 29), power(29 - self.exponent));
        let mut exact = true;
        let narrow = self.rows.map(|row| {
            row.map(|d| {
                let shifted = d * per_unit + SHIFTER;
                exact &= (shifted - SHIFTER) * unit == d;
                shifted.to_bits().cast_signed() - SHIFTER.to_bits().cast_signed()
            })
        });
        exact.then_some(narrow)
    }

    /// In units of a power of two, if that makes integers below 2^61 of them.
    fn wide(&self) -> Option<[[i64; 2]; N]> {
        whole(&self.rows, self.exponent)
    }
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
fn integers<const N: usize>(points: &[[f64; 2]; N]) -> Option<[[i64; 2]; N]> {
    let exponent = exponent(largest(points).max(power(-142)));
    whole(points, exponent)
}

/// Numbers below 2^(`exponent` + 1) in size in units of a power of two, if that makes integers below 2^61 of
/// them.
#[expect(
    clippy::cast_possible_truncation,
    reason = "the products are below 2^61"
)]
#[expect(clippy::float_cmp, reason = "asks for exact equality")]
fn whole<const N: usize>(numbers: &[[f64; 2]; N], exponent: i64) -> Option<[[i64; 2]; N]> {
    let (unit, per_unit) = (power(exponent - 60), power(60 - exponent));
    let integers = numbers.map(|row| row.map(|x| (x * per_unit) as i64));
    let exact = |(&i, &x): (&i64, &f64)| i as f64 * unit == x;
    integers
        .iter()
        .flatten()
        .zip(numbers.iter().flatten())
        .all(exact)
        .then_some(integers)
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

//! Numbers whose arithmetic is exact and without bounds: big integers, and whatever else says so by
//! implementing [`Unbounded`]. And doubles near big integers and quotients of them.
//!
//! Why it is right: a sign comes from doubles only if the [filter](super::filter) is certain of it for
//! the numbers that they approximate, else from the determinant in the number's own arithmetic.
//!
//! Cost: six or eight conversions to doubles and some nanoseconds; where the filter decides nothing,
//! about 20 operations of the number.
//!
//! Besides the signs, how much they are about ([`Scalar::depth`], [`Scalar::height`]), relative to the size of what the
//! points span, so that rounding looks the same at all sizes (some units of 1e-16):
//!
//! ```text
//! depth of d in the circle of a, b, c:     (r^2 - |d - o|^2) / r^2 = 4 D A / (|ab|^2 |bc|^2 |ca|^2)
//! height of the turn a, b, c:              A / |ac|^2
//! ```
//!
//! o and r are the circle's centre and radius, D is the in-circle determinant, and A twice the area of the
//! triangle. For the power of d to the circle is -D / A, and r is |ab| |bc| |ca| / 2 A. All factors are
//! polynomials, computed exactly. Only then is each rounded to a double, with its exponent apart, and a few roundings
//! follow. So the sign is exact, and the size right in relative terms however small it is. (What is too small for a
//! double becomes the smallest one.) That takes some microseconds.

use std::cmp::Ordering;
use std::ops::{Mul, Sub};

use num_bigint::{BigInt, BigUint, Sign};
use num_traits::{ToPrimitive, Zero};

use super::doubles::{exponent, power};
use super::{Scalar, Stage, all_doubles, filtered_in_circle, filtered_orient2d};

/// Says that a number's `+`, `-`, `*` and comparisons are exact and never overflow, which makes it a
/// [`Scalar`].
///
/// Implement it for exact numbers of your own; there is nothing to write. `to_f64` must return what
/// [`Scalar::approx`] demands: monotone, never `None` or NaN, within a relative error of 2^-52,
/// infinite only for what is too large.
///
/// It is implemented for the `BigInt` of `num-bigint` 0.4; `BigRational`, of `num-rational` 0.4, is a
/// [`Scalar`] too. Those of other versions are other types. The traits asked for are those of
/// `num-traits` 0.2.
///
/// ```
/// use std::cmp::Ordering;
/// use num_bigint::BigInt;
/// use sweep_cdt::scalar::Scalar;
///
/// let point = |x: i32, y: i32| [BigInt::from(x).pow(99), BigInt::from(y).pow(99)];
/// let (a, b, c) = (point(-3, -5), point(0, 0), point(3, 5));
/// assert_eq!(Scalar::orient2d(&a, &b, &c), Ordering::Equal);
/// ```
pub trait Unbounded:
    Clone + Ord + Zero + Sub<Output = Self> + Mul<Output = Self> + ToPrimitive
{
    /// What [`Counters`](crate::Counters) count the number's arithmetic as.
    const STAGE: Stage = Stage::Own;

    /// A double and a power of two, `(x, power)` for x * 2^power, near the number; `None` if there is no
    /// telling.
    ///
    /// It must be monotone, finite, zero for zero only, and within a relative error of 2^-52, as
    /// [`Scalar::difference`] says. Numbers far larger or smaller than doubles should have their own;
    /// this one takes what `to_f64` returns, unless that is near an end of the range of doubles.
    fn near(&self) -> Option<(f64, i64)> {
        let near = self.to_f64()?;
        let is_certain = (power(-1000)..f64::MAX).contains(&near.abs()) || self.is_zero();
        is_certain.then_some((near, 0))
    }

    /// The double that equals the number, if there is one and the type can tell at little cost.
    fn double(&self) -> Option<f64> {
        None
    }
}

impl Unbounded for BigInt {
    const STAGE: Stage = Stage::BigIntegers;

    fn double(&self) -> Option<f64> {
        (self.bits() <= 53).then(|| self.to_f64())?
    }

    fn near(&self) -> Option<(f64, i64)> {
        Some(near_integer(self))
    }
}

impl<T: Unbounded> Scalar for T {
    fn approx(&self) -> f64 {
        self.to_f64().expect("a number has a double near it")
    }

    fn as_doubles(points: &[[Self; 2]]) -> Option<Vec<[f64; 2]>> {
        all_doubles(points, Self::double)
    }

    fn difference(&self, other: &Self) -> Option<(f64, i64)> {
        (self.clone() - other.clone()).near()
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
        depth(&[a, b, c, d].map(Clone::clone))
    }

    fn height(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Option<f64> {
        height(&[a, b, c].map(Clone::clone))
    }

    fn orient2d_exact(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
        (turn(&minus(a, c), &minus(b, c)), T::STAGE)
    }

    fn in_circle_exact(
        a: &[Self; 2],
        b: &[Self; 2],
        c: &[Self; 2],
        d: &[Self; 2],
    ) -> (Ordering, Stage) {
        (lifted(&[a, b, c].map(|p| minus(p, d))), T::STAGE)
    }
}

/// The difference of two points.
pub(super) fn minus<T: Unbounded>(a: &[T; 2], b: &[T; 2]) -> [T; 2] {
    [a[0].clone() - b[0].clone(), a[1].clone() - b[1].clone()]
}

/// The sign of the turn from `a` to `b`, two differences to the same point.
pub(super) fn turn<T: Unbounded>(a: &[T; 2], b: &[T; 2]) -> Ordering {
    let left = a[0].clone() * b[1].clone();
    left.cmp(&(a[1].clone() * b[0].clone()))
}

/// The sign of the in-circle determinant whose rows are the differences of three points to a fourth.
pub(super) fn lifted<T: Unbounded>(rows: &[[T; 2]; 3]) -> Ordering {
    determinant(rows).cmp(&T::zero())
}

fn determinant<T: Unbounded>([a, b, c]: &[[T; 2]; 3]) -> T {
    square(a) * cross(b, c) + square(b) * cross(c, a) + square(c) * cross(a, b)
}

fn cross<T: Unbounded>(p: &[T; 2], q: &[T; 2]) -> T {
    p[0].clone() * q[1].clone() - p[1].clone() * q[0].clone()
}

fn square<T: Unbounded>(p: &[T; 2]) -> T {
    p[0].clone() * p[0].clone() + p[1].clone() * p[1].clone()
}

/// How deep `d` lies in the circle; `None` if the first three points have none, or the type does not tell sizes.
pub(super) fn depth<T: Unbounded>([a, b, c, d]: &[[T; 2]; 4]) -> Option<f64> {
    let rows = [a, b, c].map(|p| minus(p, d));
    let [ab, bc, ca] = [minus(b, a), minus(c, b), minus(a, c)];
    let area = cross(&ab, &bc);
    let squares = [square(&ab), square(&bc), square(&ca)];
    quotient(4.0, &[determinant(&rows), area], &squares)
}

/// How far a turn is from straight, positive to the left; `None` if it is one of a right angle or more, or the type
/// does not tell sizes.
pub(super) fn height<T: Unbounded>([a, b, c]: &[[T; 2]; 3]) -> Option<f64> {
    let [ab, bc, ac] = [minus(b, a), minus(c, b), minus(c, a)];
    let forward = ab[0].clone() * bc[0].clone() + ab[1].clone() * bc[1].clone();
    let goes_on = forward > T::zero();
    let height = || quotient(1.0, &[cross(&ab, &bc)], &[square(&ac)]);
    goes_on.then(height).flatten()
}

/// `first` times all of `over`, divided by all of `under`; `None` if one of these is zero.
fn quotient<T: Unbounded>(first: f64, over: &[T], under: &[T]) -> Option<f64> {
    let (mut value, mut exponent) = (first, 0);
    for factor in under {
        let (x, power) = parts(factor)?;
        if x == 0.0 {
            return None;
        }
        (value, exponent) = (value / x, exponent - power);
    }
    for factor in over {
        let (x, power) = parts(factor)?;
        (value, exponent) = (value * x, exponent + power);
    }
    // Two steps, since the power itself may be no double.
    let bounded = exponent.clamp(-1200, 1000);
    let size = value.abs() * power(bounded / 2) * power(bounded - bounded / 2);
    let size = if value == 0.0 {
        0.0
    } else {
        size.max(f64::from_bits(1))
    };
    Some(size.copysign(value))
}

/// A number as a double from 1 to 2, or zero, with its sign, and a power of two.
fn parts<T: Unbounded>(number: &T) -> Option<(f64, i64)> {
    const MANTISSA: u64 = (1 << 52) - 1;
    let (x, power) = number.near()?;
    let one = f64::from_bits(x.to_bits() & MANTISSA | 1.0_f64.to_bits());
    Some(if x == 0.0 {
        (0.0, 0)
    } else {
        (one.copysign(x), exponent(x.abs()) + power)
    })
}

/// `(x, power)`, where x * 2^power is near the number, whatever its size.
fn near_integer(number: &BigInt) -> (f64, i64) {
    let size = number.magnitude();
    let surplus = size.bits().saturating_sub(65);
    let is_rest = size.trailing_zeros().is_some_and(|zeros| zeros < surplus);
    rounded(
        number.sign(),
        &(size >> surplus),
        is_rest,
        surplus.cast_signed(),
    )
}

/// `(x, power)`, where x * 2^power is near the quotient; the denominator is not zero.
pub(super) fn near_quotient(numerator: &BigInt, denominator: &BigInt) -> (f64, i64) {
    let (n, d) = (numerator.magnitude(), denominator.magnitude());
    let shift = 65 - n.bits().cast_signed() + d.bits().cast_signed();
    let size = shift.unsigned_abs();
    let [n, d] = if shift < 0 {
        [n.clone(), d << size]
    } else {
        [n << size, d.clone()]
    };
    let whole = &n / &d;
    let is_rest = &whole * &d != n;
    let sign = numerator.sign() * denominator.sign();
    rounded(sign, &whole, is_rest, -shift)
}

/// A number of at most 66 bits and whether there is a rest, times 2^`power`, with a sign.
///
/// Why it is right: as many bits are taken as make a quotient of 64 to 66 bits, rounded down. If anything
/// is left, the last of these bits is set, which lies below all that a double holds. So rounding to a double
/// is that of the exact quotient: to the nearest, hence monotone, and off by at most 2^-53 of it.
///
/// Cost: that of a division by the denominator with a quotient of two machine words.
fn rounded(sign: Sign, whole: &BigUint, is_rest: bool, power: i64) -> (f64, i64) {
    if whole.is_zero() {
        return (0.0, 0);
    }
    let bits = whole.to_u128().expect("few bits") | u128::from(is_rest);
    let size = bits as f64;
    (if sign == Sign::Minus { -size } else { size }, power)
}

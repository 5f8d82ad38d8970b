//! Numbers whose arithmetic is exact and without bounds: big integers, big rationals, and whatever else
//! says so by implementing [`Unbounded`].
//!
//! Why it is right: a sign is taken from doubles only if the [`filter`] is certain of it for the
//! numbers that they approximate, or if every one of them equals its number, so that the exact
//! predicates of `f64` decide; else the determinant is computed in the number's own arithmetic.
//!
//! Cost: six or eight conversions to doubles, then a few nanoseconds; where the filter is silent,
//! about 20 operations of the number.

use std::cmp::Ordering;
use std::ops::{Mul, Sub};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::{Scalar, filter};

/// Says that a number's `+`, `-`, `*` and comparisons are exact and never overflow, which makes it a
/// [`Scalar`].
///
/// Implement it for your own exact numbers (one line, if you have neither numbers that are none nor
/// wishes for speed). `to_f64` must return what [`Scalar::approx`] demands: monotone, never `None` or
/// NaN, within a relative error of 2^-52, infinite only for what is too large.
///
/// ```
/// use std::cmp::Ordering;
/// use num_rational::BigRational;
/// use sweep_cdt::Scalar;
///
/// let third = |n: i32, m: i32| [n, m].map(|n| BigRational::new(n.into(), 3.into()));
/// let (a, b, c) = (third(0, 0), third(1, 2), third(2, 4));
/// assert_eq!(Scalar::orient2d(&a, &b, &c), Ordering::Equal);
/// ```
pub trait Unbounded:
    Clone + Ord + Zero + Sub<Output = Self> + Mul<Output = Self> + ToPrimitive
{
    /// Whether the value is a number at all (a fraction with denominator zero is none). The predicates
    /// are asked about numbers only.
    fn is_number(&self) -> bool {
        true
    }

    /// Whether `to_f64` returns the value itself; then the predicates of `f64` decide, which is faster.
    /// `false` is always right.
    fn is_double(&self) -> bool {
        false
    }
}

/// Integers up to this many bits, and quotients of two of them, are within the normal doubles.
const NORMAL_BITS: u64 = 1000;

impl Unbounded for BigInt {
    fn is_double(&self) -> bool {
        self.bits() <= NORMAL_BITS && self.bits() <= 53 + self.trailing_zeros().unwrap_or(0)
    }
}

impl Unbounded for BigRational {
    fn is_number(&self) -> bool {
        !self.denom().is_zero()
    }

    fn is_double(&self) -> bool {
        let power_of_two = |n: &BigInt| {
            n.trailing_zeros()
                .is_some_and(|zeros| n.bits() == zeros + 1)
        };
        self.numer().is_double() && self.denom().bits() <= NORMAL_BITS && power_of_two(self.denom())
    }
}

impl<T: Unbounded> Scalar for T {
    fn is_finite(&self) -> bool {
        self.is_number()
    }

    fn approx(&self) -> f64 {
        self.to_f64().expect("a number has a double near it")
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.cmp(other)
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
        let points = [a, b, c];
        let near @ [x, y, z] = points.map(approx);
        let are_doubles = || points.iter().all(|p| p.iter().all(T::is_double));
        filter::orient2d(x, y, z, false)
            .or_else(|| are_doubles().then(|| f64::orient2d(&near[0], &near[1], &near[2])))
            .unwrap_or_else(|| turn(&minus(a, c), &minus(b, c)))
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
        let points = [a, b, c, d];
        let [w, x, y, z] = points.map(approx);
        let are_doubles = || points.iter().all(|p| p.iter().all(T::is_double));
        filter::in_circle(w, x, y, z, false)
            .or_else(|| are_doubles().then(|| f64::in_circle(&w, &x, &y, &z)))
            .unwrap_or_else(|| lifted(&[a, b, c].map(|p| minus(p, d))))
    }
}

fn approx<T: Scalar>(point: &[T; 2]) -> [f64; 2] {
    [point[0].approx(), point[1].approx()]
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
    let [a, b, c] = rows;
    let times = |x: &T, y: &T| x.clone() * y.clone();
    let lift = |p: &[T; 2]| times(&p[0], &p[0]) + times(&p[1], &p[1]);
    let cross = |p: &[T; 2], q: &[T; 2]| times(&p[0], &q[1]) - times(&p[1], &q[0]);
    let det = lift(a) * cross(b, c) + lift(b) * cross(c, a) + lift(c) * cross(a, b);
    det.cmp(&T::zero())
}

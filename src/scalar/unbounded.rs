//! Exact numbers without bounds (big integers, all that implement [`Unbounded`]); big integers and quotients, rounded.
//! Why it is right: a sign is that of the [determinant](super::determinants) in the number's own arithmetic.
//! Cost: 7 operations of the number for an orientation, 30 for the in-circle test.

use alloc::vec::Vec;
use core::cmp::Ordering;
use core::ops::{Mul, Sub};

use num_bigint::{BigInt, BigUint, Sign};
use num_traits::{ToPrimitive, Zero};

use super::determinants::{self, Arithmetic};
use super::doubles::power;
use super::forward::forward;
use super::{Scalar, Stage, all_doubles, measure};

/// Marks a number whose `+`, `-`, `*` and comparisons are exact and never overflow, which makes it a [`Scalar`].
///
/// Implement `Unbounded` for exact numbers of your own; beyond the traits that it asks for there is nothing to write.
/// `to_f64` must return what [`Scalar::approx`] demands, never `None`, and infinity only for what is too large.
///
/// The `BigInt` of `num-bigint` 0.4 implements it; the `BigRational` of `num-rational` 0.4 is a [`Scalar`] too. Other
/// versions have other types. The traits asked for are those of `num-traits` 0.2.
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
    /// The stage as which [`Counters`](crate::Counters) count the number's arithmetic.
    #[doc(hidden)]
    const STAGE: Stage = Stage::Own;

    /// The number, rounded: `(x, power)` for x * 2^power; `None` if there is no telling. Rounding must be monotone,
    /// finite, zero for zero only, and within a relative error of 2^-52, as [`Scalar::difference`] says. The provided
    /// function takes what `to_f64` returns; numbers beyond the range of doubles, where it is `None`, need their own.
    fn near(&self) -> Option<(f64, i64)> {
        let approx = self.to_f64()?;
        let is_certain = (power(-1000)..f64::MAX).contains(&approx.abs()) || self.is_zero();
        is_certain.then_some((approx, 0))
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
        Some(approx_integer(self))
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

    forward!(signs);

    fn compare(&self, other: &Self) -> Ordering {
        self.cmp(other)
    }

    fn orient2d_by_stage(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
        (determinants::orient2d([a, b, c]), T::STAGE)
    }

    fn in_circle_by_stage(
        a: &[Self; 2],
        b: &[Self; 2],
        c: &[Self; 2],
        d: &[Self; 2],
    ) -> (Ordering, Stage) {
        (determinants::in_circle([a, b, c, d]), T::STAGE)
    }

    fn depth(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Option<f64> {
        measure::depth([a, b, c, d], T::near)
    }

    fn height(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Option<f64> {
        measure::height([a, b, c], T::near)
    }
}

impl<T: Unbounded> Arithmetic for T {
    fn plus(self, other: Self) -> Self {
        self + other
    }

    fn minus(self, other: &Self) -> Self {
        self - other.clone()
    }

    fn times(self, other: &Self) -> Self {
        self * other.clone()
    }

    fn sign(&self) -> Ordering {
        self.cmp(&T::zero())
    }
}

/// A big integer of any size, rounded: `(x, power)` for x * 2^power.
fn approx_integer(number: &BigInt) -> (f64, i64) {
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

/// A quotient, rounded: `(x, power)` for x * 2^power. The denominator is not zero.
pub(super) fn approx_quotient(numerator: &BigInt, denominator: &BigInt) -> (f64, i64) {
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

/// The rounded value of a number of at most 66 bits, plus a rest if there is one, times 2^`power`, with a sign.
/// Why it is right: as many bits are taken as make a quotient of 64 to 66 bits, rounded down. If there is a rest, the
/// last of these bits is set, which lies below all that a double holds. So rounding to a double is that of the exact
/// quotient: to the nearest, hence monotone, and off by at most 2^-53 of it.
/// Cost: a division by the denominator with a quotient of two machine words.
fn rounded(sign: Sign, whole: &BigUint, is_rest: bool, power: i64) -> (f64, i64) {
    if whole.is_zero() {
        return (0.0, 0);
    }
    let bits = whole.to_u128().expect("few bits") | u128::from(is_rest);
    let size = bits as f64;
    (if sign == Sign::Minus { -size } else { size }, power)
}

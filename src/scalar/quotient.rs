//! Doubles near big integers and quotients of them, whatever their size: each with a power of two.
//!
//! Why it is right: as many bits are taken as make a quotient of 64 to 66 bits, rounded down. If anything
//! is left, the last of these bits is set, which lies below all that a double holds. So rounding to a double
//! is that of the exact quotient: to the nearest, hence monotone, and off by at most 2^-53 of it.
//!
//! Cost: that of a division by the denominator with a quotient of two machine words.

use num_bigint::{BigInt, BigUint, Sign};
use num_traits::{ToPrimitive, Zero};

/// `(x, power)`, where x * 2^power is near the number.
pub(super) fn of_integer(number: &BigInt) -> (f64, i64) {
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
pub(super) fn of(numerator: &BigInt, denominator: &BigInt) -> (f64, i64) {
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
fn rounded(sign: Sign, whole: &BigUint, is_rest: bool, power: i64) -> (f64, i64) {
    if whole.is_zero() {
        return (0.0, 0);
    }
    let bits = whole.to_u128().expect("few bits") | u128::from(is_rest);
    let size = bits as f64;
    (if sign == Sign::Minus { -size } else { size }, power)
}

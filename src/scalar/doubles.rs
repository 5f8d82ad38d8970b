//! The format of doubles (IEEE 754, section 3.4): powers of two, exponents, rounding.

/// The unit roundoff, 2^-53: a sum, difference or product is rounded by at most this part of itself,
/// unless it underflows.
pub(crate) const U: f64 = power(-53);

/// 2^`exponent`, for the exponents of normal doubles, -1022 to 1023.
pub(crate) const fn power(exponent: i64) -> f64 {
    f64::from_bits((exponent + 1023).cast_unsigned() << 52)
}

/// The exponent of a positive double: `power(exponent(x)) <= x < power(exponent(x) + 1)` where `x` is
/// normal; -1023 where it is subnormal or zero.
pub(crate) const fn exponent(x: f64) -> i64 {
    (x.to_bits() >> 52).cast_signed() - 1023
}

//! The rationals that the command computes with: GMP's with the feature `rug`, pure Rust ones otherwise.
//!
//! Files are read as pure Rust rationals in both cases, and converted once.

use std::borrow::Cow;

use num_rational::BigRational;

#[cfg(not(feature = "rug"))]
pub(crate) use num_rational::BigRational as Rational;
#[cfg(feature = "rug")]
pub(crate) use rug::Rational;

/// The exact value of a finite double.
pub(crate) fn exact(value: f64) -> Rational {
    #[cfg(not(feature = "rug"))]
    let exact = Rational::from_float(value);
    #[cfg(feature = "rug")]
    let exact = Rational::from_f64(value);
    exact.expect("others were refused")
}

/// The points of a file.
#[cfg(not(feature = "rug"))]
pub(crate) fn points(points: &[[BigRational; 2]]) -> Cow<'_, [[Rational; 2]]> {
    Cow::Borrowed(points)
}

/// The points of a file.
#[cfg(feature = "rug")]
pub(crate) fn points(points: &[[BigRational; 2]]) -> Cow<'_, [[Rational; 2]]> {
    use num_bigint::{BigInt, Sign};
    use rug::{Integer, integer::Order};

    let integer = |number: &BigInt| {
        let (sign, digits) = number.to_u64_digits();
        let size = Integer::from_digits(&digits, Order::Lsf);
        if sign == Sign::Minus { -size } else { size }
    };
    let rational = |x: &BigRational| Rational::from((integer(x.numer()), integer(x.denom())));
    points
        .iter()
        .map(|point| point.each_ref().map(rational))
        .collect()
}

//! Rationals as coordinates: the exact scalar of files with fractions in them.

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::formats::{Coordinate, CoordinateError};
use crate::scalar::Scalar;

/// How many digits a numerator or a denominator may have. A double needs at most 1,100.
const MAX_DIGITS: usize = 10_000;

/// A decimal means just what it says: `0.1` is one tenth, not the double near it.
///
/// ```
/// use num_rational::BigRational;
/// use sweep_cdt::formats::Coordinate;
///
/// assert_eq!(BigRational::from_text("0.25e1"), BigRational::from_text("10/4"));
/// assert_eq!(BigRational::from_text("-2/6").unwrap().text(), "-1/3");
/// ```
impl Coordinate for BigRational {
    fn from_text(token: &str) -> Result<Self, CoordinateError> {
        let unsigned = token.strip_prefix(['-', '+']).unwrap_or(token);
        let (numerator, denominator) = match unsigned.split_once('/') {
            Some((numerator, denominator)) => (numerator.to_owned(), denominator.to_owned()),
            None => decimal(unsigned)?,
        };
        let is_number =
            |digits: &str| !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit());
        if !is_number(&numerator) || !is_number(&denominator) {
            return Err(CoordinateError::NotANumber);
        }
        if numerator.len().max(denominator.len()) > MAX_DIGITS {
            return Err(CoordinateError::TooLong);
        }
        if denominator.bytes().all(|digit| digit == b'0') {
            return Err(CoordinateError::NotANumber);
        }
        let value = fraction(&numerator, &denominator).ok_or(CoordinateError::NotANumber)?;
        Ok(if token.starts_with('-') {
            -value
        } else {
            value
        })
    }

    fn text(&self) -> String {
        let text = self.to_string();
        // A whole number that is not a double is written as a fraction: a file of whole numbers alone is
        // read as doubles, which would round it.
        if text.contains('/') || BigRational::from_float(self.approx()).as_ref() == Some(self) {
            text
        } else {
            format!("{text}/1")
        }
    }
}

/// Numerator and denominator of an unsigned decimal.
fn decimal(token: &str) -> Result<(String, String), CoordinateError> {
    let (mantissa, exponent) = token.split_once(['e', 'E']).unwrap_or((token, "0"));
    let (whole, digits) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let exponent = exponent
        .parse::<i32>()
        .map_err(|_| CoordinateError::NotANumber)?;
    if digits.len().max(exponent.unsigned_abs() as usize) > MAX_DIGITS {
        return Err(CoordinateError::TooLong);
    }
    let mut numerator = [whole, digits].concat();
    let mut denominator = format!("1{}", "0".repeat(digits.len()));
    let longer = if exponent < 0 {
        &mut denominator
    } else {
        &mut numerator
    };
    if !longer.is_empty() {
        longer.push_str(&"0".repeat(exponent.unsigned_abs() as usize));
    }
    Ok((numerator, denominator))
}

/// The quotient of two strings of decimal digits, the second not zero.
fn fraction(numerator: &str, denominator: &str) -> Option<BigRational> {
    let parts: (BigInt, BigInt) = (numerator.parse().ok()?, denominator.parse().ok()?);
    Some(BigRational::from(parts))
}

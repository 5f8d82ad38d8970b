//! Rationals as coordinates: GMP's with the feature `rug`, pure Rust ones otherwise.

use crate::Scalar;
use crate::formats::{Coordinate, Unreadable};

/// The exact scalar of files with fractions in them.
#[cfg(not(feature = "rug"))]
pub type Rational = num_rational::BigRational;
/// The exact scalar of files with fractions in them.
#[cfg(feature = "rug")]
pub type Rational = rug::Rational;

/// How many digits a numerator or a denominator may have. A double needs at most 1,100.
const MAX_DIGITS: usize = 10_000;

/// The exact value of a double, or `None` if it is not finite.
pub fn exact(value: f64) -> Option<Rational> {
    #[cfg(not(feature = "rug"))]
    return Rational::from_float(value);
    #[cfg(feature = "rug")]
    return Rational::from_f64(value);
}

/// A decimal means just what it says: `0.1` is one tenth, not the double near it.
///
/// ```
/// use sweep_cdt::formats::{Coordinate, Rational};
///
/// assert_eq!(Rational::from_text("0.25e1"), Rational::from_text("10/4"));
/// assert_eq!(Rational::from_text("-2/6").unwrap().text(), "-1/3");
/// ```
impl Coordinate for Rational {
    fn from_text(token: &str) -> Result<Self, Unreadable> {
        let unsigned = token.strip_prefix(['-', '+']).unwrap_or(token);
        let (numerator, denominator) = match unsigned.split_once('/') {
            Some((numerator, denominator)) => (numerator.to_owned(), denominator.to_owned()),
            None => decimal(unsigned)?,
        };
        let is_number =
            |digits: &str| !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit());
        if !is_number(&numerator) || !is_number(&denominator) {
            return Err(Unreadable::NotANumber);
        }
        if numerator.len().max(denominator.len()) > MAX_DIGITS {
            return Err(Unreadable::TooLong);
        }
        if denominator.bytes().all(|digit| digit == b'0') {
            return Err(Unreadable::NotANumber);
        }
        let value = fraction(&numerator, &denominator).ok_or(Unreadable::NotANumber)?;
        Ok(if token.starts_with('-') {
            -value
        } else {
            value
        })
    }

    fn text(&self) -> String {
        let text = self.to_string();
        // A whole number that is not a double would be rounded where no fraction is left in a file.
        if text.contains('/') || exact(self.approx()).as_ref() == Some(self) {
            text
        } else {
            format!("{text}/1")
        }
    }
}

/// Numerator and denominator of an unsigned decimal.
fn decimal(token: &str) -> Result<(String, String), Unreadable> {
    let (mantissa, exponent) = token.split_once(['e', 'E']).unwrap_or((token, "0"));
    let (whole, digits) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let exponent = exponent
        .parse::<i32>()
        .map_err(|_| Unreadable::NotANumber)?;
    if digits.len().max(exponent.unsigned_abs() as usize) > MAX_DIGITS {
        return Err(Unreadable::TooLong);
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
fn fraction(numerator: &str, denominator: &str) -> Option<Rational> {
    #[cfg(not(feature = "rug"))]
    type Integer = num_bigint::BigInt;
    #[cfg(feature = "rug")]
    type Integer = rug::Integer;

    let parts: (Integer, Integer) = (numerator.parse().ok()?, denominator.parse().ok()?);
    Some(Rational::from(parts))
}

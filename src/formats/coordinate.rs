//! Coordinates as text.

use crate::scalar::Scalar;

/// A scalar that files can hold.
pub trait Coordinate: Scalar + Clone + PartialEq + Send + Sync {
    /// The value of a token such as `12`, `-0.5`, `1e-3` or `2/3`.
    ///
    /// # Errors
    /// See [`CoordinateError`].
    fn from_text(token: &str) -> Result<Self, CoordinateError>;

    /// The shortest text from which [`from_text`](Coordinate::from_text) makes the same value again.
    fn text(&self) -> String;

    /// Appends [`text`](Coordinate::text) to a text.
    fn write_text(&self, text: &mut Vec<u8>) {
        text.extend_from_slice(self.text().as_bytes());
    }
}

/// Why a token gives no coordinate: a sentence that begins with the token.
///
/// ```
/// use sweep_cdt::formats::Coordinate;
///
/// let error = f64::from_text("1,5").unwrap_err();
/// assert_eq!(format!("`1,5` {error}"), "`1,5` is not a coordinate");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CoordinateError {
    /// It is not a number.
    #[error("is not a coordinate")]
    NotANumber,
    /// It is a fraction, and the type has none.
    #[error("is a fraction")]
    Fraction,
    /// It is a number beyond the largest double.
    #[error("is too large for a double")]
    TooLarge,
    /// It has more digits than are read.
    #[error("has too many digits")]
    TooLong,
}

/// The nearest double. `nan` and `inf` are read too, for the library to refuse them.
///
/// ```
/// use sweep_cdt::formats::{Coordinate, CoordinateError};
///
/// assert_eq!(f64::from_text("-1e-3"), Ok(-0.001));
/// assert_eq!(f64::from_text("2/3"), Err(CoordinateError::Fraction));
/// assert_eq!(f64::from_text("1e400"), Err(CoordinateError::TooLarge));
/// assert_eq!(0.1.text(), "0.1");
/// assert_eq!(4e300.text(), "4e300");
/// assert_eq!(7.0.text(), "7");
/// ```
impl Coordinate for f64 {
    fn from_text(token: &str) -> Result<Self, CoordinateError> {
        match token.parse::<f64>() {
            // `inf` is not a number too large, but none.
            Ok(value) if value.is_infinite() && token.contains(|c: char| c.is_ascii_digit()) => {
                Err(CoordinateError::TooLarge)
            }
            Ok(value) => Ok(value),
            Err(_) if token.contains('/') => Err(CoordinateError::Fraction),
            Err(_) => Err(CoordinateError::NotANumber),
        }
    }

    fn text(&self) -> String {
        let mut text = Vec::new();
        self.write_text(&mut text);
        String::from_utf8(text).expect("digits and signs")
    }

    fn write_text(&self, text: &mut Vec<u8>) {
        // `zmij` is faster than the standard library. Its text is the same but for exponents, and where two
        // shortest texts are equally near. There a number has at most 18 digits, and every one of this size
        // that is no multiple of 2^-24 has more.
        let (mut fast, slow);
        let is_plain = (1e-4..1e16).contains(&self.abs());
        let number = if is_plain && (self * f64::from(1 << 24)).fract() != 0.0 {
            fast = zmij::Buffer::new();
            fast.format_finite(*self)
        } else {
            // Unlike `{}`, `{:?}` writes powers of ten where they are shorter.
            slow = format!("{self:?}");
            slow.strip_suffix(".0").unwrap_or(&slow)
        };
        text.extend_from_slice(number.as_bytes());
    }
}

//! Coordinates as text: doubles, and rationals, the exact scalar of files with fractions in them.

use std::fmt;
use std::num::IntErrorKind;

use num_bigint::{BigInt, Sign};
use num_rational::BigRational;

use sweep_cdt::crossings::Exact;
use sweep_cdt::scalar::Scalar;

/// A scalar that files can hold.
pub trait Coordinate: Exact + PartialEq + Send + Sync {
    /// The value of a token such as `12`, `-0.5`, `1e-3` or `2/3`.
    ///
    /// # Errors
    /// See [`CoordinateError`].
    fn from_text(token: &str) -> Result<Self, CoordinateError>;

    /// The value of a double, as binary files hold it.
    ///
    /// # Errors
    /// See [`CoordinateError`]: the type has no such value.
    fn from_double(value: f64) -> Result<Self, CoordinateError>;

    /// The value as an integer times a power of two, `(x, power)` for x * 2^power; `None` if it is none.
    ///
    /// ```
    /// use num_bigint::BigInt;
    /// use num_rational::BigRational;
    /// use sweep_cdt_formats::Coordinate;
    ///
    /// assert_eq!((-0.75).binary(), Some((BigInt::from(-3), -2)));
    /// assert_eq!(BigRational::from_text("3/4")?.binary(), Some((BigInt::from(3), -2)));
    /// assert_eq!(BigRational::from_text("0.1")?.binary(), None);
    /// # Ok::<(), sweep_cdt_formats::CoordinateError>(())
    /// ```
    fn binary(&self) -> Option<(BigInt, i64)>;

    /// Like [`binary`](Coordinate::binary), where 64 bits hold the integer with its sign and a quick way is known.
    ///
    /// ```
    /// use sweep_cdt_formats::Coordinate;
    ///
    /// assert_eq!((-0.75).small_binary(), Some((-3, -2)));
    /// ```
    fn small_binary(&self) -> Option<(i64, i64)> {
        None
    }

    /// The least and the greatest number of the type that differ from this one by no more than a tolerance.
    ///
    /// ```
    /// use sweep_cdt_formats::Coordinate;
    ///
    /// // 1 + 2^-60 is no double, and the sum of the doubles 0.3 and 0.1 is a little less than the double 0.4.
    /// assert_eq!(1.0.within(2_f64.powi(-60)), [1.0, 1.0]);
    /// assert_eq!(0.3.within(0.1), [0.2_f64.next_down(), 0.4_f64.next_down()]);
    /// ```
    fn within(&self, tolerance: f64) -> [Self; 2];

    /// The least double that is no less than the difference to another number; at most the largest one.
    ///
    /// ```
    /// use sweep_cdt_formats::Coordinate;
    ///
    /// assert_eq!(1.0.apart(&1e-30), 1.0);
    /// assert_eq!(1.0.apart(&-1e-30), 1_f64.next_up());
    /// ```
    fn apart(&self, other: &Self) -> f64;

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
/// use sweep_cdt_formats::Coordinate;
///
/// let error = f64::from_text("1,5").unwrap_err();
/// assert_eq!(format!("`1,5` {error}"), "`1,5` is not a coordinate");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum CoordinateError {
    /// The text is not a number.
    NotANumber,
    /// The text is a fraction, and the type has none.
    Fraction,
    /// The text is a number beyond the largest double.
    TooLarge,
    /// The text is to be read exactly, and has more digits than [`MAX_DIGITS`].
    TooLong,
    /// The text is to be read exactly, and its exponent is beyond [`MAX_EXPONENT`].
    ExponentTooLarge,
}

impl fmt::Display for CoordinateError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CoordinateError::NotANumber => write!(f, "is not a coordinate"),
            CoordinateError::Fraction => write!(f, "is a fraction"),
            CoordinateError::TooLarge => write!(f, "is too large for a double"),
            CoordinateError::TooLong => write!(
                f,
                "has more than {MAX_DIGITS} digits, the most that are read exactly"
            ),
            CoordinateError::ExponentTooLarge => write!(
                f,
                "has an exponent beyond {MAX_EXPONENT}, the limit where numbers are read exactly"
            ),
        }
    }
}

impl std::error::Error for CoordinateError {}

/// The nearest double. `nan` and `inf` are read too, for the library to refuse them.
///
/// ```
/// use sweep_cdt_formats::{Coordinate, CoordinateError};
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

    fn from_double(value: f64) -> Result<Self, CoordinateError> {
        Ok(value)
    }

    fn binary(&self) -> Option<(BigInt, i64)> {
        BigRational::from_float(*self)?.binary()
    }

    fn small_binary(&self) -> Option<(i64, i64)> {
        // The fraction is 52 bits, before which stands another one unless the exponent is 0.
        let bits = self.to_bits();
        let exponent = i64::try_from(bits >> 52 & 0x7ff).ok()?;
        let fraction = i64::try_from(bits & ((1 << 52) - 1)).ok()?;
        let integer = if exponent > 0 {
            fraction | 1 << 52
        } else {
            fraction
        };
        if integer == 0 {
            return Some((0, 0));
        }
        let zeros = integer.trailing_zeros();
        let integer = if self.is_sign_negative() {
            -integer
        } else {
            integer
        };
        self.is_finite()
            .then(|| (integer >> zeros, exponent.max(1) - 1075 + i64::from(zeros)))
    }

    fn within(&self, tolerance: f64) -> [Self; 2] {
        [-sum_below(-self, tolerance), sum_below(*self, tolerance)]
    }

    fn apart(&self, other: &Self) -> f64 {
        -sum_below(-self.max(*other), self.min(*other))
    }

    fn text(&self) -> String {
        let mut text = Vec::new();
        self.write_text(&mut text);
        String::from_utf8(text).expect("digits and signs")
    }

    fn write_text(&self, text: &mut Vec<u8>) {
        // `itoa` and `zmij` are faster than the standard library. All digits of a whole number below 2^53 tell
        // it from the doubles beside it. The text of `zmij` is the same but for exponents, and where two shortest
        // texts are equally near. There a number has at most 18 digits, and every one of this size that is no
        // multiple of 2^-24 has more.
        let (mut whole, mut fast, slow);
        let is_plain = (1e-4..1e15).contains(&self.abs());
        #[expect(
            clippy::cast_possible_truncation,
            reason = "it is whole and below 2^53"
        )]
        let number = if is_plain && self.fract() == 0.0 {
            whole = itoa::Buffer::new();
            whole.format(*self as i64)
        } else if is_plain && (self * f64::from(1 << 24)).fract() != 0.0 {
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

/// The most digits that a numerator or a denominator may have. A double needs at most 1,100.
pub const MAX_DIGITS: usize = 10_000;

/// The most that an exponent of a number that is read exactly may be, up or down. A double needs at most 324.
///
/// The limit is below [`MAX_DIGITS`] since digits that are written out make a file longer, as they make the arithmetic, and
/// an exponent does not.
pub const MAX_EXPONENT: u32 = 400;

/// A decimal means just what it says: `0.1` is one tenth, not the double near it. The limits are [`MAX_DIGITS`] and
/// [`MAX_EXPONENT`].
///
/// ```
/// use num_rational::BigRational;
/// use sweep_cdt_formats::{Coordinate, CoordinateError};
///
/// assert_eq!(BigRational::from_text("0.25e1"), BigRational::from_text("10/4"));
/// assert_eq!(BigRational::from_text("-2/6").unwrap().text(), "-1/3");
/// assert_eq!(BigRational::from_text("1e-401"), Err(CoordinateError::ExponentTooLarge));
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
        let parse = |digits: String| digits.parse().map_err(|_| CoordinateError::NotANumber);
        let value = quotient(parse(numerator)?, parse(denominator)?)?;
        Ok(if token.starts_with('-') {
            -value
        } else {
            value
        })
    }

    fn from_double(value: f64) -> Result<Self, CoordinateError> {
        BigRational::from_float(value).ok_or(CoordinateError::NotANumber)
    }

    fn binary(&self) -> Option<(BigInt, i64)> {
        let halves = self.denom().trailing_zeros().unwrap_or(0);
        if halves + 1 != self.denom().bits() {
            return None;
        }
        let doubles = self.numer().trailing_zeros().unwrap_or(0);
        let power = i64::try_from(doubles).ok()? - i64::try_from(halves).ok()?;
        Some((self.numer() >> doubles, power))
    }

    fn within(&self, tolerance: f64) -> [Self; 2] {
        let tolerance = BigRational::from_float(tolerance).unwrap_or_default();
        [self - &tolerance, self + &tolerance]
    }

    fn apart(&self, other: &Self) -> f64 {
        let difference = self.max(other) - self.min(other);
        let near = difference.approx().min(f64::MAX);
        match BigRational::from_float(near).is_some_and(|near| near < difference) {
            true => near.next_up().min(f64::MAX),
            false => near,
        }
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

/// The greatest double that is no more than the sum of two; at least the least one.
fn sum_below(x: f64, y: f64) -> f64 {
    let sum = (x + y).clamp(-f64::MAX, f64::MAX);
    // What the sum lost by rounding is a double (Knuth); where it was clamped, this has its sign.
    let of_y = sum - x;
    let lost = (x - (sum - of_y)) + (y - of_y);
    match lost < 0.0 {
        true => sum.next_down().max(-f64::MAX),
        false => sum,
    }
}

/// Numerator and denominator of an unsigned decimal.
fn decimal(token: &str) -> Result<(String, String), CoordinateError> {
    let (mantissa, exponent) = token.split_once(['e', 'E']).unwrap_or((token, "0"));
    let (whole, digits) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let exponent = exponent
        .parse::<i32>()
        .map_err(|error| match error.kind() {
            IntErrorKind::PosOverflow | IntErrorKind::NegOverflow => {
                CoordinateError::ExponentTooLarge
            }
            _ => CoordinateError::NotANumber,
        })?;
    if exponent.unsigned_abs() > MAX_EXPONENT {
        return Err(CoordinateError::ExponentTooLarge);
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

/// The quotient of two whole numbers, neither of which may have more digits than [`MAX_DIGITS`].
///
/// ```
/// use num_bigint::BigInt;
/// use sweep_cdt_formats::{Coordinate, CoordinateError, quotient};
///
/// let (three, zero) = (BigInt::from(3), BigInt::from(0));
/// assert_eq!(quotient(three.clone(), BigInt::from(-6)).map(|half| half.text()), Ok("-1/2".to_owned()));
/// assert_eq!(quotient(three.clone(), zero), Err(CoordinateError::NotANumber));
/// assert_eq!(quotient(three, BigInt::from(10).pow(10_000)), Err(CoordinateError::TooLong));
/// ```
///
/// # Errors
/// [`CoordinateError::TooLong`], and [`CoordinateError::NotANumber`] where the denominator is zero.
pub fn quotient(numerator: BigInt, denominator: BigInt) -> Result<BigRational, CoordinateError> {
    // A digit is more than three bits and less than four, so that digits are seldom counted.
    let is_long = |number: &BigInt| {
        let bits = number.bits();
        let most = MAX_DIGITS as u64;
        bits > 4 * most || bits > 3 * most && number.magnitude().to_string().len() > MAX_DIGITS
    };
    if is_long(&numerator) || is_long(&denominator) {
        return Err(CoordinateError::TooLong);
    }
    if denominator.sign() == Sign::NoSign {
        return Err(CoordinateError::NotANumber);
    }
    Ok(BigRational::new(numerator, denominator))
}

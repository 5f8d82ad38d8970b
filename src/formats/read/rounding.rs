//! Whether one number is another one, printed with fewer digits.
//!
//! A program that prints a coordinate with k significant digits moves it by at most half a unit of its
//! k-th digit. How many digits were printed is seen in the file: as many as stand there, without leading
//! zeros, but 6 at least, since many programs (`%g`, C++ streams) drop zeros at the end of their 6. So a
//! number that is written with more digits than 6 must agree in all of them.

/// The fewest significant digits that a program is taken to have printed.
const FEWEST: usize = 6;
/// A double is known from so many digits.
const MOST: usize = 17;

/// Whether a value is what printing `exact` gives, as this text has it.
///
/// Half a unit may be rounded to either side. `exact` is known to one unit in its last place only, if
/// `is_near` says so.
pub(super) fn is_rounded(exact: f64, is_near: bool, text: &str, value: f64) -> bool {
    let Some(digits) = digits(text) else {
        return false;
    };
    let digits = digits.clamp(FEWEST, MOST);
    // Digits that a double has for certain leave room for both ways to round a half. (Next to zero is a
    // number of other digits.)
    let either_way = exact.is_normal() && (is_near || digits <= f64::DIGITS as usize);
    let printed = |exact: f64| format!("{exact:.*e}", digits - 1).parse() == Ok(value);
    printed(exact) || either_way && (printed(exact.next_up()) || printed(exact.next_down()))
}

/// How many significant digits are written; `None` for a fraction, which is not rounded.
fn digits(text: &str) -> Option<usize> {
    let mantissa = text.split(['e', 'E']).next()?;
    let digits = mantissa.bytes().filter(u8::is_ascii_digit);
    (!text.contains('/')).then(|| digits.skip_while(|&digit| digit == b'0').count())
}

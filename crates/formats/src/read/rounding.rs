//! Which doubles a number in a file may stand for: those that a program rounds to it.
//!
//! A program that prints a coordinate with k significant digits moves it by at most half a unit of its k-th digit. How
//! many digits were printed is seen in the file: as many as stand there, without leading zeros, but 6 at least, since
//! many programs (`%g`, C++ streams) drop zeros at the end of their 6. So a number that is written with more digits
//! than 6 must agree in all of them. A half may be rounded to either side. A program that prints a fixed number of
//! decimals prints few digits of small numbers: where all numbers of a file are such, and one has 6 decimals or more, the
//! greatest number of decimals counts. A number of single precision stands for the doubles to which it is the nearest.
//!
//! All are ranges of doubles, because rounding keeps the order. The ends of a range are the halves, each as the nearest
//! double; beyond 15 digits, where a double has several texts, an end must also be printed as the number in the file.
//!
//! Cost: a number is printed once, and two are read.

use crate::read::content::Vertices;
use sweep_cdt::scalar::Scalar;

/// How a program rounds.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Rule {
    /// To the digits that it prints.
    Decimals,
    /// To so many decimals.
    Fixed(usize),
    /// To single precision.
    Singles,
}

/// The fewest significant digits that a program is taken to have printed.
const FEWEST: usize = 6;
/// A double is known from so many digits.
const MOST: usize = 17;

impl Rule {
    /// The least and the greatest double that are rounded to this value, as this text has it; `None` for a fraction,
    /// which is not rounded, and for what the rule cannot make.
    pub(super) fn doubles(self, text: &str, value: f64) -> Option<[f64; 2]> {
        match self {
            Rule::Decimals => decimals(digits(text)?.clamp(FEWEST, MOST), value),
            Rule::Fixed(places) => fixed(places, value),
            Rule::Singles => singles(value),
        }
    }
}

/// Whether all coordinates are numbers of single precision, printed.
pub(super) fn are_singles(vertices: &Vertices<'_>, values: &[[f64; 2]]) -> bool {
    let is_single = |vertex: usize, axis: usize| {
        let value = values[vertex][axis];
        let digits = digits(&vertices.text(vertex, axis));
        digits.is_some_and(|digits| is_printed(single(value), digits.clamp(1, MOST), value))
    };
    (0..values.len()).all(|v| is_single(v, 0) && is_single(v, 1))
}

/// How many decimals the numbers of a file have, the most of them; `None`, if these are too few to tell, or if numbers
/// have exponents or are fractions.
pub(super) fn fixed_places(vertices: &Vertices<'_>) -> Option<usize> {
    let mut places = 0;
    for vertex in 0..vertices.coordinates.len() {
        for axis in 0..2 {
            let text = vertices.text(vertex, axis);
            if text.contains(['e', 'E', '/']) {
                return None;
            }
            places = places.max(
                text.split_once('.')
                    .map_or(0, |(_, decimals)| decimals.len()),
            );
        }
    }
    (FEWEST..=MOST).contains(&places).then_some(places)
}

/// The doubles that are printed with so many decimals as this value.
fn fixed(places: usize, value: f64) -> Option<[f64; 2]> {
    if value == 0.0 {
        let half: f64 = format!("0.5e-{places}").parse().ok()?;
        return Some([-half, half]);
    }
    // Digits are counted from the first one of the value.
    let text = format!("{:e}", value.abs());
    let exponent: i32 = text.split_once('e')?.1.parse().ok()?;
    let digits = exponent + 1 + i32::try_from(places).ok()?;
    let digits = usize::try_from(digits).ok()?;
    decimals(digits.clamp(1, MOST), value)
}

/// The doubles that are printed with so many digits as this value.
fn decimals(digits: usize, value: f64) -> Option<[f64; 2]> {
    if value == 0.0 {
        return Some([0.0, 0.0]);
    }
    let text = format!("{:.*e}", digits - 1, value.abs());
    let (mantissa, exponent) = text.split_once('e')?;
    let mantissa: u64 = mantissa.replace('.', "").parse().ok()?;
    let exponent = exponent.parse::<i32>().ok()? + 1 - i32::try_from(digits).ok()?;
    // A half of the last digit is a 5 behind it. Below a power of ten the digits are ten times as fine.
    let power = 10_u64.checked_pow(u32::try_from(digits - 1).ok()?)?;
    let below = match mantissa == power {
        true => format!("{}95e{}", mantissa - 1, exponent - 2),
        false => format!("{}5e{}", mantissa - 1, exponent - 1),
    };
    let above = format!("{mantissa}5e{}", exponent - 1);
    let (mut low, mut high): (f64, f64) = (below.parse().ok()?, above.parse().ok()?);
    if digits > f64::DIGITS as usize {
        let is_of_it = |end: f64| is_printed(end, digits, value.abs());
        low = if is_of_it(low) { low } else { low.next_up() };
        high = if is_of_it(high) {
            high
        } else {
            high.next_down()
        };
    }
    let is_positive = value > 0.0;
    Some(if is_positive {
        [low, high]
    } else {
        [-high, -low]
    })
}

/// The doubles that have this value in single precision.
#[expect(
    clippy::cast_possible_truncation,
    reason = "this is how programs round"
)]
fn singles(value: f64) -> Option<[f64; 2]> {
    let nearest = value as f32;
    let end = |beside: f32| {
        let half = 0.5 * (f64::from(beside) - f64::from(nearest));
        let end = f64::from(nearest) + half;
        // A half goes to the even one.
        match single(end).compare(&f64::from(nearest)).is_eq() {
            true => end,
            false if half > 0.0 => end.next_down(),
            false => end.next_up(),
        }
    };
    let [before, after] = [nearest.next_down(), nearest.next_up()];
    let is_inside = before.is_finite() && after.is_finite();
    is_inside.then(|| [end(before), end(after)])
}

/// The nearest number of single precision.
#[expect(
    clippy::cast_possible_truncation,
    reason = "this is how programs round"
)]
fn single(x: f64) -> f64 {
    f64::from(x as f32)
}

/// Whether so many digits of a number are read as this value.
fn is_printed(number: f64, digits: usize, value: f64) -> bool {
    format!("{number:.*e}", digits - 1).parse() == Ok(value)
}

/// How many significant digits are written; `None` for a fraction.
fn digits(text: &str) -> Option<usize> {
    let mantissa = text.split(['e', 'E']).next()?;
    let digits = mantissa.bytes().filter(u8::is_ascii_digit);
    (!text.contains('/')).then(|| digits.skip_while(|&digit| digit == b'0').count())
}

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

use crate::read::matching::written::Written;
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
    /// Not at all.
    Exact,
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
            Rule::Decimals => printed(digits(text)?.clamp(FEWEST, MOST), true, value),
            Rule::Fixed(places) => fixed(places, value),
            Rule::Singles => singles(value),
            Rule::Exact => None,
        }
    }
}

/// Whether all coordinates are numbers of single precision, printed.
pub(super) fn are_singles(written: &impl Written, values: &[[f64; 2]]) -> bool {
    let is_single = |vertex: usize, axis: usize| {
        let value = values[vertex][axis];
        let digits = digits(&written.text(vertex, axis));
        digits.is_some_and(|digits| is_printed(single(value), digits.clamp(1, MOST), value))
    };
    (0..values.len()).all(|v| is_single(v, 0) && is_single(v, 1))
}

/// How many decimals the coordinates of so many vertices have, the most of them; `None`, if these are too few to tell, or
/// if numbers have exponents or are fractions.
pub(super) fn fixed_places(written: &impl Written, count: usize) -> Option<usize> {
    let mut places = 0;
    for vertex in 0..count {
        for axis in 0..2 {
            places = places.max(written.decimals(vertex, axis)?);
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
    printed(digits.clamp(1, MOST), false, value)
}

/// The doubles that are printed with so many digits as this value. Below a power of ten the digits may be finer: ten
/// times as many units are there.
fn printed(digits: usize, is_finer_below: bool, value: f64) -> Option<[f64; 2]> {
    if value == 0.0 {
        return Some([0.0, 0.0]);
    }
    let text = format!("{:.*e}", digits - 1, value.abs());
    let (mantissa, exponent) = text.split_once('e')?;
    let mantissa: u64 = mantissa.replace('.', "").parse().ok()?;
    let exponent = exponent.parse::<i32>().ok()? + 1 - i32::try_from(digits).ok()?;
    // A half of the last digit is a 5 behind it.
    let power = 10_u64.checked_pow(u32::try_from(digits - 1).ok()?)?;
    let below = match is_finer_below && mantissa == power {
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

#[cfg(test)]
mod tests {
    use sweep_cdt_testing::Random;

    use super::{Rule, single};

    /// The ends of a range are rounded to the value or are halves, and the doubles beyond are not rounded to it.
    #[test]
    fn ranges_hold_what_is_printed_so_and_nothing_else() {
        let mut random = Random::new(3);
        for _ in 0..20_000 {
            let digits = 6 + random.below(12);
            let exponent = [-300, -7, -1, 0, 3, 8, 290][random.below(7)];
            let exact: f64 = format!("{}e{exponent}", 1 + random.below(1 << 40))
                .parse()
                .expect("a number");
            let exact = if random.below(2) == 0 { exact } else { -exact };
            let text = format!("{exact:.*e}", digits - 1);
            let value: f64 = text.parse().expect("a number");
            let [low, high] = Rule::Decimals.doubles(&text, value).expect("a range");
            assert!(
                low <= exact && exact <= high,
                "{exact:e} {text} {low:e} {high:e}"
            );
            let is_printed = |x: f64| format!("{x:.*e}", digits - 1).parse() == Ok(value);
            // A half may be nearer to a double beyond it.
            assert!(
                !is_printed(low.next_down().next_down()) && !is_printed(high.next_up().next_up())
            );
            assert!(
                is_printed(low) || digits <= 15 && is_printed(low.next_up()),
                "{text} {low:e}"
            );
            assert!(
                is_printed(high) || digits <= 15 && is_printed(high.next_down()),
                "{text} {high:e}"
            );
        }
    }

    #[test]
    fn ranges_of_singles_end_where_rounding_does() {
        let mut random = Random::new(4);
        for _ in 0..20_000 {
            let exponent = random.below(60);
            let exact = (1 + random.below(1 << 40)) as f64
                / 2_f64.powi(i32::try_from(exponent).expect("small"));
            let value = single(exact);
            let [low, high] = Rule::Singles.doubles("", value).expect("a range");
            assert!(
                [low, exact, high]
                    .iter()
                    .all(|&x| single(x).to_bits() == value.to_bits())
            );
            assert!(
                [low.next_down(), high.next_up()]
                    .iter()
                    .all(|&x| single(x).to_bits() != value.to_bits())
            );
        }
        assert_eq!(Rule::Singles.doubles("", f64::from(f32::MAX)), None);
    }

    /// By hand.
    #[test]
    fn fixed_decimals_are_halves_of_the_last_one() {
        let fixed = |places, value| Rule::Fixed(places).doubles("0", value);
        assert_eq!(fixed(6, 0.009604), Some([0.0096035, 0.0096045]));
        assert_eq!(fixed(6, -33.5), Some([-33.5000005, -33.4999995]));
        assert_eq!(fixed(6, 0.0), Some([-5e-7, 5e-7]));
        assert_eq!(fixed(9, 0.000001), Some([0.0000009995, 0.0000010005]));
        // A power of ten has finer numbers below it, but not with fixed decimals.
        assert_eq!(fixed(6, 1.0), Some([0.9999995, 1.0000005]));
        assert_eq!(
            Rule::Decimals.doubles("1.00000", 1.0),
            Some([0.9999995, 1.000005])
        );
        // More digits than a double has.
        assert_eq!(fixed(17, 123.25), Some([123.25, 123.25]));
    }
}

//! Levels that are equally far apart.
//!
//! Each is computed as a fraction, and rounded once to the nearest double: the third multiple of 0.1 is the double that
//! the text `0.3` means, and a height of 0.3 in a file is exactly at it.

use std::fmt;

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::crossings::Exact;

/// More levels are refused.
const MOST: usize = 1_000_000;

/// Why there are no levels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LevelsError {
    /// The distance between levels is zero or less.
    NotPositive,
    /// The distance between levels is too small for the heights.
    TooMany,
}

impl fmt::Display for LevelsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LevelsError::NotPositive => write!(f, "levels must be more than 0 apart"),
            LevelsError::TooMany => write!(
                f,
                "there are more than {MOST} levels between the lowest and the highest height: choose levels that are \
                 further apart"
            ),
        }
    }
}

impl std::error::Error for LevelsError {}

/// The levels `from + k * every`, for all whole numbers k, that are at least `low` and at most `high`. These are finite.
///
/// ```
/// use num_rational::BigRational;
/// use sweep_cdt_terrain::levels;
///
/// let tenth = BigRational::new(1.into(), 10.into());
/// let zero = BigRational::from_integer(0.into());
/// assert_eq!(levels(&zero, &tenth, [0.05, 0.3])?, [0.1, 0.2, 0.3]);
/// # Ok::<(), sweep_cdt_terrain::LevelsError>(())
/// ```
///
/// # Errors
/// See [`LevelsError`].
pub fn levels(
    from: &BigRational,
    every: &BigRational,
    [low, high]: [f64; 2],
) -> Result<Vec<f64>, LevelsError> {
    if *every <= BigRational::from_integer(BigInt::ZERO) {
        return Err(LevelsError::NotPositive);
    }
    let number = |height: f64| (height.to_fraction() - from) / every;
    // A level that is rounded may lie on the other side of a height than its fraction: one more at each end is looked at.
    let first = number(low).floor().to_integer();
    let last = number(high).ceil().to_integer();
    if &last - &first >= BigInt::from(MOST) {
        return Err(LevelsError::TooMany);
    }
    let mut levels = Vec::new();
    let mut level = every * BigRational::from_integer(first.clone()) + from;
    let mut number = first;
    while number <= last {
        levels.push(f64::nearest(&level));
        level += every;
        number += 1;
    }
    levels.retain(|level| (low..=high).contains(level));
    levels.dedup();
    Ok(levels)
}

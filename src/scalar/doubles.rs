//! Doubles by their exponents (IEEE 754, section 3.4): powers of two, rounding, and the factor that scales an input.
//! The floating-point [`filter`](super::filter) works on sizes from about 2^-150 to 2^200: below, products underflow;
//! above, they overflow. Where sizes are farther apart, the fullest window of [`WIDTH`] binary orders of magnitude
//! counts. Its largest number stays where it is or goes to 1, and numbers far outside, such as a "no data" point at the
//! largest double, cost the others nothing. The highest window at least half as full as the fullest comes first: x and
//! y may have units that far apart, and numbers above the window become infinite, which no longer tells points apart.
//! Cost of finding the window: O(n) for n numbers, O(n log k) for k different exponents beyond those of doubles.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;
use core::ops::RangeInclusive;

/// The unit roundoff, 2^-53: without underflow a sum, difference or product is rounded by at most this part of itself.
pub(crate) const U: f64 = power(-53);

/// 2^`exponent`, for the exponents of normal doubles, -1022 to 1023.
pub(crate) const fn power(exponent: i64) -> f64 {
    f64::from_bits((exponent + 1023).cast_unsigned() << 52)
}

/// The exponent of x >= 0: `power(exponent(x)) <= x < power(exponent(x) + 1)`, or -1023 if x is subnormal or zero.
pub(crate) const fn exponent(x: f64) -> i64 {
    (x.to_bits() >> 52).cast_signed() - 1023
}

/// The exponents at which a largest number stays where it is.
const IN_RANGE: RangeInclusive<i64> = -120..=199;
/// The greatest exponent of a window minus the least.
const WIDTH: i64 = 100;

/// The exponent of the power of two by which numbers with these exponents are multiplied.
pub(super) fn shift(exponents: impl Iterator<Item = i64>) -> i64 {
    // Exponents of doubles, which are nearly always all, are counted in an array.
    let (mut of_doubles, mut others) = ([0_usize; 2048], BTreeMap::new());
    for exponent in exponents {
        let place = usize::try_from(exponent.saturating_add(1024)).ok();
        match place.and_then(|place| of_doubles.get_mut(place)) {
            Some(count) => *count += 1,
            None => *others.entry(exponent).or_insert(0_usize) += 1,
        }
    }
    let counts = (-1024..).zip(of_doubles).filter(|&(_, count)| count > 0);
    let mut counts: Vec<(i64, usize)> = counts.chain(others).collect();
    counts.sort_unstable();
    // For the window that ends with each exponent how many numbers it holds.
    let (mut from, mut held) = (0, 0);
    let mut windows = Vec::with_capacity(counts.len());
    for &(last, count) in &counts {
        held += count;
        while counts[from].0 < last - WIDTH {
            held -= counts[from].1;
            from += 1;
        }
        windows.push((last, held));
    }
    let fullest = windows.iter().map(|&(_, held)| held).max().unwrap_or(0);
    let chosen = windows.iter().rev().find(|&&(_, held)| 2 * held >= fullest);
    match chosen {
        Some((last, _)) if !IN_RANGE.contains(last) => -last,
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::shift;

    #[test]
    fn the_fullest_window_is_moved_unless_it_is_in_range() {
        for (exponents, expected) in [
            (&[][..], 0),
            (&[-120, 199], 0),
            (&[0, -2, 0, 1023], 0),
            (&[-110, -130, -130, 80, 150], 0),
            (&[0, 0, -1000, -1001], 0),
            (&[0, 0, 1000, 1001], -1001),
            (&[0, -1000, -1001, -1100], 1000),
            (&[1000, 1001, 900, -700], -1001),
            (&[-200, 0, -201, -203], 200),
            (&[0, 0, 0, 200, 201], -201),
            (&[30_000, 29_000, 29_001, 29_001, -1], -29_001),
        ] {
            let found = shift(exponents.iter().copied());
            assert_eq!(found, expected, "{exponents:?}");
        }
    }
}

//! Which power of two the doubles of one input are multiplied by.
//!
//! The floating-point [`filter`](super::filter) works on sizes from about 2^-120 to 2^200: below, products
//! underflow; above, they overflow. Sizes that differ by more than that do not fit in together. So the
//! window of [`WIDTH`] binary orders of magnitude that holds the most numbers is moved to the middle,
//! unless these numbers are in range as they are. Of equally full ones that comes first, then the upper one. What is far outside, such as a "no data" point at the
//! largest double, costs the others nothing then.
//!
//! Cost: O(n log k) for n numbers of k different exponents.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;

/// The exponents of sizes that are left as they are.
const IN_RANGE: RangeInclusive<i64> = -120..=199;
/// How many exponents lie between the least and the greatest of a window.
const WIDTH: i64 = 200;
/// Where the greatest exponent of a window goes. Differences are smaller than coordinates, so there is
/// more room below.
const TOP: i64 = 100;

/// The power of two by which numbers with these exponents are multiplied.
pub(super) fn shift(exponents: impl Iterator<Item = i64>) -> i64 {
    let mut counts = BTreeMap::new();
    for exponent in exponents {
        *counts.entry(exponent).or_insert(0_usize) += 1;
    }
    let counts: Vec<(i64, usize)> = counts.into_iter().collect();
    // The window that ends with each exponent in turn; `from` is the first in it, `held` how many it holds.
    let (mut from, mut held) = (0, 0);
    let mut best = (0, true);
    let mut shift = 0;
    for &(last, count) in &counts {
        held += count;
        while counts[from].0 < last - WIDTH {
            held -= counts[from].1;
            from += 1;
        }
        let is_in_range = IN_RANGE.contains(&counts[from].0) && IN_RANGE.contains(&last);
        if (held, is_in_range) >= best {
            best = (held, is_in_range);
            shift = if is_in_range { 0 } else { TOP - last };
        }
    }
    shift
}

#[cfg(test)]
mod tests {
    use super::shift;

    #[test]
    fn the_fullest_window_is_moved_unless_it_is_in_range() {
        for (exponents, expected) in [
            (&[][..], 0),
            (&[-120, 199], 0),
            (&[0, 0, 1023], 0),
            (&[0, 0, -1000, -1001], 0),
            (&[0, 0, 1000, 1001], 0),
            (&[500, 501, 900, 901], 100 - 901),
            (&[0, -1000, -1001], 1100),
            (&[1000, 1001, 900, -700], -901),
            (&[-200, 0, -201], 100),
            (&[0, 0, 200, 200, 200, 201], -100),
            (&[30_000, 29_000, 29_001, -1], 100 - 29_001),
        ] {
            let found = shift(exponents.iter().copied());
            assert_eq!(found, expected, "{exponents:?}");
        }
    }
}

//! Doubles as integers of 61 bits, where these are possible in units of one power of two.
//! An input with many near-ties, such as points on a circle, keeps the integers of all its points ([`IntegerPoints`]),
//! so that a test only subtracts and multiplies.
//! Why it is right: a product by a power of two keeps all digits, unless it falls below the normal doubles. Turning an
//! integer back shows whether digits are lost. Differences of numbers below 2^61 are below 2^62, as [`wide`] demands.
//! Cost: some 20 instructions a coordinate; 16 bytes a point where all are kept.

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::doubles::{exponent, power};
use super::wide;

/// The numbers in units of the power of two that makes an integer of 61 bits of `size`, and whether all are integers.
#[inline(always)]
#[expect(
    clippy::cast_possible_truncation,
    reason = "the products are below 2^61"
)]
#[expect(clippy::float_cmp, reason = "asks for exact equality")]
pub(super) fn whole<const N: usize>(numbers: &[[f64; 2]; N], size: f64) -> ([[i64; 2]; N], bool) {
    // The unit must be a normal double.
    let exponent = exponent(size).max(-900);
    let (unit, per_unit) = (power(exponent - 60), power(60 - exponent));
    let (mut integers, mut is_whole) = ([[0; 2]; N], true);
    let flat = integers.as_flattened_mut().iter_mut();
    for (integer, &x) in flat.zip(numbers.as_flattened()) {
        *integer = (x * per_unit) as i64;
        is_whole &= *integer as f64 * unit == x;
    }
    (integers, is_whole)
}

pub(super) fn largest(points: &[[f64; 2]]) -> f64 {
    // Numbers that are not negative have the order of their bits.
    let bits = points.as_flattened().iter().map(|x| x.abs().to_bits());
    f64::from_bits(bits.fold(0, u64::max))
}

/// Points as integers in one unit for all; [`NO_INTEGERS`] in place of a point that has none in that unit.
#[derive(Debug)]
pub(super) struct IntegerPoints(Vec<[i64; 2]>);

/// The mark of a point without integers: no integer of 61 bits is so small.
const NO_INTEGERS: [i64; 2] = [i64::MIN; 2];

impl IntegerPoints {
    pub(super) fn of(points: &[[f64; 2]]) -> IntegerPoints {
        let size = largest(points);
        let integers = points.iter().map(|&point| match whole(&[point], size) {
            ([integers], true) => integers,
            _ => NO_INTEGERS,
        });
        IntegerPoints(integers.collect())
    }

    /// The side of the circle through the first three points on which the last lies, if all four have integers.
    // Not inlined, since most inputs have no use for it.
    #[inline(never)]
    pub(super) fn in_circle(&self, points: [usize; 4]) -> Option<Ordering> {
        let [a, b, c, d] = points.map(|i| self.0[i]);
        if [a, b, c, d].iter().any(|p| p[0] == i64::MIN) {
            return None;
        }
        let rows = [a, b, c].map(|p| [p[0] - d[0], p[1] - d[1]]);
        Some(wide::in_circle(rows))
    }

    pub(super) fn heap_bytes(&self) -> usize {
        self.0.capacity() * size_of::<[i64; 2]>()
    }
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering::{Equal, Greater, Less};

    use super::{IntegerPoints, power};

    /// The unit is 2^-60, and the three points are counter-clockwise.
    #[test]
    fn points_that_are_not_whole_decide_nothing() {
        for (point, expected) in [
            ([-1.0, 0.0], Some(Equal)),
            ([power(-53) - 1.0, 0.0], Some(Greater)),
            ([-1.0, power(-60)], Some(Less)),
            ([-1.0, power(-61)], None),
            ([1e-300, 1e-300], None),
            ([-0.0, -0.0], Some(Greater)),
        ] {
            let points = [[1.0, 0.0], [0.0, 1.0], [0.0, -1.0], point];
            let found = IntegerPoints::of(&points).in_circle([1, 2, 0, 3]);
            assert_eq!(found, expected, "{point:?}");
        }
    }
}

//! Inputs on a lattice: determinants in doubles are exact on a coarse one and take few integer operations on a finer.
//!
//! Coordinates that are integers, times one power of two for all, and not too far apart are common: pixels, rasters,
//! drawings. On a coarse lattice nearly all their ties are ties of the determinant in doubles too, once that is known
//! to have no error. On a finer lattice their differences are taken for integers without a test.
//! Why it is right: in units of the lattice differences of coordinates are integers of at most 2^b in size. Products of
//! two are at most 2^2b, lifts and minors twice that, and the in-circle determinant, a sum of three products of these,
//! at most 3 * 2^(4b + 2). Integers up to 2^53 are doubles. So nothing is rounded in the in-circle determinant with
//! b = [`IN_CIRCLE`], the orientation determinant with b = [`ORIENT2D`], or a difference with b = [`DIFFERENCES`]. No
//! coordinate but zero is below 2^-120 in size, so the unit is at least 2^-172 and nothing underflows.
//! Cost: a look at a few points; where they lie on such a lattice, one pass over all, or two.

use core::cmp::Ordering;

use super::doubles::{exponent, power};
use super::wide;
use crate::tuning::SAMPLE_OF_LATTICE;

/// The most bits of differences for which the orientation determinant is exact.
const ORIENT2D: i64 = 25;
/// The most bits of differences for which the in-circle determinant is exact.
const IN_CIRCLE: i64 = 12;
/// The most bits of differences that are taken for integers. Five fewer than would do: multiples of 2^-53 below 1, such
/// as many generators of random numbers return, gain nothing.
const DIFFERENCES: i64 = 48;

/// The lattice of some points, as far as it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lattice {
    /// The most bits that a difference of coordinates has, in units of the lattice.
    bits: i64,
    /// How many units of the lattice make 1.
    per_unit: f64,
}

impl Lattice {
    /// The lattice of points about which nothing is known.
    pub(super) const UNKNOWN: Lattice = Lattice {
        bits: i64::MAX,
        per_unit: 0.0,
    };

    /// The lattice of points whose coordinates are zero or from 2^-120 to 2^200 in size.
    pub(super) fn of(points: usize, point: impl Fn(usize) -> [f64; 2]) -> Lattice {
        let all = (0..points).map(&point);
        let sample = all
            .clone()
            .step_by(points.div_ceil(SAMPLE_OF_LATTICE).max(1));
        let (unit, ranges) = unit_and_ranges(sample);
        let lattice = Lattice::new(unit, ranges);
        if lattice == Lattice::UNKNOWN || points <= SAMPLE_OF_LATTICE {
            return lattice;
        }
        // Nearly always the sample has the unit of all points.
        if let Some(ranges) = ranges_in_units(all.clone(), lattice.per_unit) {
            return Lattice::new(unit, ranges);
        }
        let (unit, ranges) = unit_and_ranges(all);
        Lattice::new(unit, ranges)
    }

    /// The lattice with the unit 2^`unit` and these ranges of x and y.
    fn new(unit: i64, ranges: [Range; 2]) -> Lattice {
        let longest = ranges.map(|[least, most]| most - least);
        let longest = longest.into_iter().fold(power(unit), f64::max);
        let bits = exponent(longest) - unit + i64::from(longest > power(exponent(longest)));
        if bits > DIFFERENCES {
            return Lattice::UNKNOWN;
        }
        let per_unit = power(-unit);
        Lattice { bits, per_unit }
    }

    pub(super) fn has_exact_orient2d(self) -> bool {
        self.bits <= ORIENT2D
    }

    pub(super) fn has_exact_in_circle(self) -> bool {
        self.bits <= IN_CIRCLE
    }

    /// The side of the circle through the first three points on which the last lies, if the lattice is known.
    #[inline(always)]
    pub(super) fn in_circle(self, points: [[f64; 2]; 4]) -> Option<Ordering> {
        (self.bits <= DIFFERENCES).then(|| in_circle(points, self.per_unit))
    }
}

/// The least and the greatest coordinate.
type Range = [f64; 2];

const NO_RANGES: [Range; 2] = [[f64::INFINITY, f64::NEG_INFINITY]; 2];

#[inline(always)]
fn extended([least, most]: Range, x: f64) -> Range {
    [
        if x < least { x } else { least },
        if x > most { x } else { most },
    ]
}

/// The exponent of the largest power of two that divides all coordinates, and the ranges of x and y.
fn unit_and_ranges(points: impl Iterator<Item = [f64; 2]>) -> (i64, [Range; 2]) {
    let mut unit = 200;
    let mut ranges = NO_RANGES;
    for point in points {
        for (x, range) in point.into_iter().zip(&mut ranges) {
            *range = extended(*range, x);
            if x != 0.0 {
                // The last bit of the mantissa that is set, or the implicit one before it.
                let zeros = (x.to_bits() | 1 << 52).trailing_zeros();
                unit = unit.min(exponent(x.abs()) - 52 + i64::from(zeros));
            }
        }
    }
    (unit, ranges)
}

/// The ranges of x and y, if all coordinates are multiples of a unit, at most 2^51 of it. No branches, for speed.
#[expect(clippy::float_cmp, reason = "integers are rounded to themselves")]
fn ranges_in_units(points: impl Iterator<Item = [f64; 2]>, per_unit: f64) -> Option<[Range; 2]> {
    // Adding and subtracting this number rounds smaller ones to integers.
    let rounding = 1.5 * power(52);
    let mut ranges = NO_RANGES;
    let mut are_multiples = true;
    for point in points {
        let units = point.map(|x| x * per_unit);
        let rounded = units.map(|x| (x + rounding) - rounding);
        are_multiples &= (units[0] == rounded[0]) & (units[1] == rounded[1]);
        ranges = [extended(ranges[0], point[0]), extended(ranges[1], point[1])];
    }
    // Coordinates of 2^51 units or more are not rounded to integers.
    let are_small = |range: Range| range.iter().all(|x| (x * per_unit).abs() < power(51));
    (are_multiples && ranges.into_iter().all(are_small)).then_some(ranges)
}

/// The side of the circle through `a`, `b`, `c` on which `d` lies, from integers.
#[expect(
    clippy::cast_possible_truncation,
    reason = "the products are integers of at most 2^48"
)]
fn in_circle([a, b, c, d]: [[f64; 2]; 4], per_unit: f64) -> Ordering {
    let rows = [a, b, c].map(|p| [0, 1].map(|i| ((p[i] - d[i]) * per_unit) as i64));
    wide::in_circle(rows)
}

#[cfg(test)]
mod tests {
    use super::{Lattice, power};

    #[test]
    fn the_widest_differences_decide() {
        for (points, bits) in [
            (&[[0.0, 0.0], [4096.0, 1.0]][..], Some(12)),
            (&[[0.0, 0.0], [4097.0, 2.0]], Some(13)),
            (&[[0.0, 0.0], [4096.0, 0.5]], Some(13)),
            (&[[1e15, 0.0], [1e15 + 4096.0, 1.0]], Some(12)),
            (&[[-0.25, 0.0], [8_388_607.75, 0.0]], Some(25)),
            (&[[-0.25, 0.0], [8_388_608.0, 0.0]], Some(26)),
            (&[[-1.0, 0.0], [power(48) - 1.0, 0.0]], Some(48)),
            (&[[-1.0, 0.0], [power(48), 0.0]], None),
            (&[[0.1, 0.0], [0.2, 0.0]], None),
            (&[[3.0, -3.0], [3.0, -3.0]], Some(0)),
            (&[[0.0, 0.0]], Some(0)),
            (&[], Some(0)),
        ] {
            let lattice = Lattice::of(points.len(), |i| points[i]);
            assert_eq!((lattice != Lattice::UNKNOWN).then_some(lattice.bits), bits);
        }
        // A point beyond the sample, which has the unit 1.
        for (point, bits) in [
            ([0.1, 0.0], None),
            ([0.5, 0.0], Some(1)),
            ([power(30), power(31)], Some(31)),
            ([power(30) + 0.5, 0.0], Some(32)),
            ([power(48), 0.0], Some(48)),
            ([power(48) + 1.0, 0.0], None),
            ([power(70), 0.0], None),
        ] {
            let mut points = vec![[0.0, 1.0]; 1000];
            points[501] = point;
            let lattice = Lattice::of(points.len(), |i| points[i]);
            assert_eq!((lattice != Lattice::UNKNOWN).then_some(lattice.bits), bits);
        }
        // Far from zero, where half a unit is not rounded.
        let far = -power(51);
        let mut points: Vec<_> = (0..1000).map(|i| [far - f64::from(i), far]).collect();
        points[501] = [far - 0.5, far];
        let lattice = Lattice::of(points.len(), |i| points[i]);
        assert_eq!((lattice.bits, lattice.per_unit), (11, 2.0));
    }
}

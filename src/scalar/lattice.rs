//! Inputs on a lattice so coarse that the determinants of doubles are not rounded.
//!
//! Coordinates that are integers, times one power of two for all, and not too far apart are common: pixels,
//! rasters, drawings. Nearly all their ties are ties of the determinant in doubles too, once it is known that
//! this has no error.
//!
//! Why it is right: in units of the lattice all differences of coordinates are integers of at most 2^b in size.
//! Products of two of them are at most 2^2b, lifts and minors twice that, and the in-circle determinant, the
//! sum of three products of these, at most 3 * 2^(4b + 2). Integers up to 2^53 are doubles, so with
//! b = [`IN_CIRCLE`] no step of it is rounded; with b = [`ORIENT2D`] none of the orientation determinant is.
//! The unit is at least 2^-172, since no coordinate is below 2^-120 in size but zero, so nothing underflows.
//!
//! Cost: a look at a few points; where they lie on such a lattice, one pass over all.

use super::doubles::{exponent, power};

/// The most bits of differences for which the orientation determinant is exact.
const ORIENT2D: i64 = 25;
/// The same for the in-circle determinant.
const IN_CIRCLE: i64 = 12;
/// How many points are looked at before all are.
const SAMPLE: usize = 64;

/// Which determinants of doubles are exact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Lattice {
    /// None for certain.
    Fine,
    /// That of the orientation.
    Coarse,
    /// Both.
    Coarsest,
}

impl Lattice {
    /// That of these points, whose coordinates are zero or from 2^-120 to 2^200 in size.
    pub(super) fn of(points: usize, point: impl Fn(usize) -> [f64; 2]) -> Lattice {
        let sample = (0..points).step_by(points.div_ceil(SAMPLE).max(1));
        match Lattice::of_all(sample.map(&point)) {
            Lattice::Fine => Lattice::Fine,
            _ => Lattice::of_all((0..points).map(point)),
        }
    }

    fn of_all(points: impl Iterator<Item = [f64; 2]>) -> Lattice {
        let mut unit = i64::MAX;
        let mut ranges = [(f64::INFINITY, f64::NEG_INFINITY); 2];
        for point in points {
            for (x, (least, most)) in point.into_iter().zip(&mut ranges) {
                (*least, *most) = (x.min(*least), x.max(*most));
                if x != 0.0 {
                    // The last bit of the mantissa that is set, or else the one before all of them.
                    let zeros = (x.to_bits() | 1 << 52).trailing_zeros();
                    unit = unit.min(exponent(x.abs()) - 52 + i64::from(zeros));
                }
            }
        }
        let are_within = |bits| {
            let longest = power(unit.min(200) + bits);
            ranges.iter().all(|(least, most)| most - least <= longest)
        };
        if are_within(IN_CIRCLE) {
            Lattice::Coarsest
        } else if are_within(ORIENT2D) {
            Lattice::Coarse
        } else {
            Lattice::Fine
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Lattice;

    #[test]
    fn the_widest_differences_decide() {
        for (points, expected) in [
            (&[[0.0, 0.0], [4096.0, 1.0]][..], Lattice::Coarsest),
            (&[[0.0, 0.0], [4097.0, 2.0]], Lattice::Coarse),
            (&[[0.0, 0.0], [4096.0, 0.5]], Lattice::Coarse),
            (&[[1e15, 0.0], [1e15 + 4096.0, 1.0]], Lattice::Coarsest),
            (&[[-0.25, 0.0], [8_388_607.75, 0.0]], Lattice::Coarse),
            (&[[-0.25, 0.0], [8_388_608.0, 0.0]], Lattice::Fine),
            (&[[0.1, 0.0], [0.2, 0.0]], Lattice::Fine),
            (&[[0.0, 0.0]], Lattice::Coarsest),
            (&[], Lattice::Coarsest),
        ] {
            assert_eq!(Lattice::of(points.len(), |i| points[i]), expected);
        }
        // Beyond the sample.
        let mut points = vec![[0.0, 1.0]; 1000];
        points[501] = [0.1, 0.0];
        assert_eq!(Lattice::of(points.len(), |i| points[i]), Lattice::Fine);
    }
}

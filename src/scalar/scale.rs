//! The scale of doubles: what the floating-point [`filter`](super::filter) knows about its input.
//!
//! The filter must not overflow, and underflow must do it no harm. So where some doubles of an input are below 2^-120
//! or not below 2^200, all are multiplied by one power of two, the *factor*, which the [window](super::doubles) of most
//! of them chooses. No sign changes: the orientation determinant is multiplied by the factor's square, the in-circle
//! determinant by its fourth power. Doubles still not below 2^200 become infinite: the filter decides nothing of them.
//!
//! A finite double X is off the scaled coordinate by at most `relative` |X| + `absolute` / 2:
//! - nothing, where the doubles are the coordinates and scaling keeps every digit: no product is below normal doubles;
//! - less than 2^-1022, where scaling alone may lose digits;
//! - by the contract of [`approx`](super::Scalar::approx) an approximation X of a coordinate x is off by at most
//!   2u |x|, that is 2u / (1 - 2u) |X|, or by 2^-1022 where x is below the normal doubles (u = 2^-53).
//!   `(2 + 16 u) u` |X| covers the first error, and the rounding of this bound itself. A factor above 1 makes the
//!   second larger. Where |X| is the largest double nothing is known of x, so X becomes infinite (where it is the
//!   coordinate too, so that every scalar takes the same steps);
//! - by the contract of [`difference`](super::Scalar::difference) a difference to an origin
//!   ([`recenter`](mod@super::recenter)) is off by the first error, and by at most 2^-1022 below the normal doubles.
//!
//! Scaling and becoming infinite keep the order: a larger coordinate never has a smaller double.
//! Cost: one pass over the doubles; a few where some are out of range.

use super::doubles::{self, U, exponent, power};
use super::lattice::Lattice;

/// More than 2u / (1 - 2u), by enough for the three roundings of [`Scale::error`].
const RELATIVE_ERROR: f64 = (2.0 + 16.0 * U) * U;

/// The most that underflow adds to a determinant and to what its bound is computed from.
pub(super) const UNDERFLOW: f64 = power(-660);

/// How the doubles that filter and steer relate to the coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    /// [`UNDERFLOW`] where finite doubles are the coordinates, up to the factor; infinite elsewhere.
    underflow_bound: f64,
    /// Whether coordinates of equal doubles are equal: all doubles are finite and exact.
    is_injective: bool,
    /// The lattice of the doubles, as far as it is known.
    lattice: Lattice,
    relative: f64,
    absolute: f64,
}

impl Default for Scale {
    fn default() -> Scale {
        Scale::EXACT
    }
}

impl Scale {
    /// The scale of doubles that are the coordinates.
    pub(super) const EXACT: Scale = Scale {
        underflow_bound: UNDERFLOW,
        is_injective: true,
        lattice: Lattice::UNKNOWN,
        relative: 0.0,
        absolute: 0.0,
    };

    /// The scale of doubles in range that are the coordinates, with what their lattice promises.
    pub(crate) fn exact(points: usize, point: impl Fn(usize) -> [f64; 2]) -> Scale {
        Scale {
            lattice: Lattice::of(points, point),
            ..Scale::EXACT
        }
    }

    /// The scale of doubles each off by at most 2u / (1 - 2u) of itself, or 2^-1022 times `unit`, and 2^-1022 more.
    pub(super) const fn rounded(unit: f64) -> Scale {
        Scale {
            underflow_bound: f64::INFINITY,
            is_injective: false,
            lattice: Lattice::UNKNOWN,
            relative: RELATIVE_ERROR,
            absolute: power(-1019) * unit.max(1.0),
        }
    }

    /// Brings many coordinates to one scale, and looks for their lattice where that moves none of them.
    pub(super) fn of_coordinates(approx: &mut [[f64; 2]]) -> Scale {
        if approx.iter().all(|&point| is_in_range(point)) {
            return Scale::exact(approx.len(), |i| approx[i]);
        }
        Scale::move_into_range(approx, true)
    }

    /// Brings approximations, which are the coordinates themselves if `exact`, to one scale.
    pub(super) fn unify(approx: &mut [[f64; 2]], exact: bool) -> Scale {
        if approx.iter().all(|&point| is_in_range(point)) {
            return if exact {
                Scale::EXACT
            } else {
                Scale::rounded(1.0)
            };
        }
        Scale::move_into_range(approx, exact)
    }

    #[cold]
    fn move_into_range(approx: &mut [[f64; 2]], exact: bool) -> Scale {
        let sizes = approx.iter().flatten().map(|x| x.abs());
        let known = sizes.filter(|&size| size > 0.0 && size < f64::MAX);
        // The exponents that a single factor can have.
        let factor = power(doubles::shift(known.map(exponent)).clamp(-1022, 1000));
        let mut keeps_digits = true;
        for x in approx.iter_mut().flatten() {
            let scaled = *x * factor;
            // Products above 2^-960 keep all digits, and so do those by a factor above 1.
            keeps_digits &= factor >= 1.0 || *x == 0.0 || scaled.abs() > power(-960);
            *x = if x.abs() < f64::MAX {
                bounded(scaled)
            } else {
                x.signum() * f64::INFINITY
            };
        }
        let (rounded, is_injective) = (
            Scale::rounded(factor),
            approx.iter().flatten().all(|x| x.is_finite()),
        );
        match (exact, keeps_digits) {
            (true, true) => Scale {
                is_injective,
                ..Scale::EXACT
            },
            (true, false) => Scale {
                relative: 0.0,
                ..rounded
            },
            (false, _) => rounded,
        }
    }

    /// Whether the doubles are the coordinates, up to the factor, wherever they are finite.
    pub(crate) fn is_exact(self) -> bool {
        self.underflow_bound == UNDERFLOW
    }

    #[inline(always)]
    pub(super) fn lattice(self) -> Lattice {
        self.lattice
    }

    /// The most that underflow adds to a determinant; infinite for inexact doubles, so that the filter decides nothing.
    #[inline(always)]
    pub(super) fn underflow_bound(self) -> f64 {
        self.underflow_bound
    }

    #[inline(always)]
    pub(crate) fn is_injective(self) -> bool {
        self.is_injective
    }

    /// How far the difference of two coordinates may be off that of their doubles `a` and `b`.
    #[inline(always)]
    pub(super) fn error(self, a: f64, b: f64) -> f64 {
        self.relative * (a.abs() + b.abs()) + self.absolute
    }
}

/// Whether the doubles of a point need no factor. Has no branches, so that a pass over many points is fast.
#[inline(always)]
pub(crate) fn is_in_range(point: [f64; 2]) -> bool {
    let is_moderate = |x: f64| {
        let size = x.abs();
        (x == 0.0) | (size >= power(-120)) & (size < power(200))
    };
    is_moderate(point[0]) & is_moderate(point[1])
}

/// A double below 2^200, or an infinite one in its place.
pub(super) fn bounded(x: f64) -> f64 {
    if x.abs() < power(200) {
        x
    } else {
        x.signum() * f64::INFINITY
    }
}

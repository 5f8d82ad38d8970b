//! The scale of doubles: what the floating-point [`filter`](super::filter) knows about its input.
//!
//! The filter must not overflow, and underflow must do it no harm. So all approximations of one input
//! are multiplied by one power of two, the *factor*, where the largest of them is below 2^-120 or above
//! 2^200. No sign changes by that: the orientation determinant is multiplied by the factor's square, the
//! in-circle determinant by its fourth power. Afterwards the largest is 2^-120 to 2^200 in size, or
//! all are zero.
//!
//! The *error* bounds how far each scaled double may be off the scaled coordinate:
//! - nothing, where the approximations are the coordinates and scaling keeps every digit, which it does
//!   unless a product falls below the normal doubles;
//! - less than 2^-1022, where scaling alone may lose digits;
//! - by the contract of [`approx`](super::Scalar::approx) an approximation X of a coordinate x is off by
//!   at most 2u |x|, that is 2u / (1 - 2u) |X|, or by 2^-1022 where x is below the normal doubles
//!   (u = 2^-53). `(2 + 16 u) u` times the largest |X| covers that, the rounding of this bound itself,
//!   and the 2^-1075 that scaling down may add. Where the largest |X| is the largest double or
//!   infinite, nothing is known of x.
//!
//! Cost: one pass over the approximations.

use super::doubles::{U, exponent, power};

/// More than 2u / (1 - 2u), by enough for the three roundings of [`Scale::of`].
const RELATIVE_ERROR: f64 = (2.0 + 16.0 * U) * U;

/// How the doubles that filter and steer relate to the coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    factor: f64,
    error: f64,
}

impl Scale {
    /// The scale for these approximations, which are the coordinates themselves if `exact`.
    pub(crate) fn of(approximations: impl Iterator<Item = f64>, exact: bool) -> Scale {
        let (small, large) =
            approximations
                .map(f64::abs)
                .fold((f64::INFINITY, 0.0_f64), |(small, large), size| {
                    let small = if size > 0.0 { small.min(size) } else { small };
                    (small, large.max(size))
                });
        let factor = if large == 0.0 || (power(-120)..=power(200)).contains(&large) {
            1.0
        } else {
            // Brings the largest near 1, as far as one factor can.
            power((-exponent(large)).clamp(-1022, 1000))
        };
        let error = if exact {
            // Products above 2^-960 keep all digits, and so do those by a factor above 1.
            let keeps_digits = factor >= 1.0 || small * factor > power(-960);
            if keeps_digits { 0.0 } else { power(-1022) }
        } else if large < f64::MAX {
            (RELATIVE_ERROR * large + power(-1021)) * factor
        } else {
            f64::INFINITY
        };
        Scale { factor, error }
    }

    /// The doubles for a point with these approximations.
    #[inline(always)]
    pub(crate) fn apply(self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x * self.factor, y * self.factor]
    }

    /// Whether the doubles are the coordinates, up to the factor.
    #[inline(always)]
    pub(crate) fn is_exact(self) -> bool {
        self.error == 0.0
    }

    /// What each double may be off by.
    pub(crate) fn error(self) -> f64 {
        self.error
    }
}

//! How doubles stand for coordinates of any scalar: one power of two for all, one bound on the error.

/// How the doubles that filter and steer relate to the coordinates.
///
/// They are the scalar's approximations, all multiplied by one power of two where the largest is
/// outside 2^-120 to 2^200, so that no product overflows. `error` bounds what each may be off by.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    factor: f64,
    pub(crate) error: f64,
}

impl Scale {
    /// Power of two `2^exponent`, if that is a normal double.
    fn power(exponent: i64) -> f64 {
        f64::from_bits(u64::try_from(exponent + 1023).expect("a normal exponent") << 52)
    }

    /// The scale for these approximations, which are the values themselves if `exact`.
    pub(crate) fn of(approximations: impl Iterator<Item = f64>, exact: bool) -> Scale {
        let (small, large) = approximations
            .map(f64::abs)
            .fold((f64::INFINITY, 0.0_f64), |(small, large), c| {
                (if c > 0.0 { small.min(c) } else { small }, large.max(c))
            });
        if large.is_infinite() {
            return Scale {
                factor: 1.0,
                error: f64::INFINITY,
            };
        }
        let mut factor = 1.0;
        if large > 0.0 && !(Scale::power(-120)..=Scale::power(200)).contains(&large) {
            // Brings the largest near 1, as far as one factor can.
            let exponent = (large.to_bits() >> 52).cast_signed() - 1023;
            factor = Scale::power((-exponent).clamp(-1022, 1000));
        }
        // Below 2^-960 a scaled value may have lost digits.
        let is_kept = factor.to_bits() == 1.0_f64.to_bits() || small * factor > Scale::power(-960);
        if exact && is_kept {
            return Scale { factor, error: 0.0 };
        }
        // One unit in the last place of the largest covers rounding and, far below, underflow.
        Scale {
            factor,
            error: (large * factor * f64::EPSILON).max(f64::MIN_POSITIVE),
        }
    }

    /// The double for a coordinate with this approximation.
    #[inline(always)]
    pub(crate) fn apply(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x * self.factor, y * self.factor]
    }

    /// Whether the doubles are the coordinates, up to the factor.
    #[inline(always)]
    pub(crate) fn is_exact(&self) -> bool {
        self.error == 0.0
    }
}

//! The worst approximation that the contract of `approx` allows.

use std::ops::{Add, Mul, Sub};

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive, Zero};
use sweep_cdt::scalar::Unbounded;

use super::rational;

/// A rational number that becomes a double of 52 bits, so it is off by up to a whole unit in the last
/// place; zero for what is below the normal doubles, the largest double for what is above.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Crude<const MOVES: bool>(pub(crate) BigRational);

impl<const MOVES: bool> Unbounded for Crude<MOVES> {
    fn near(&self) -> Option<(f64, i64)> {
        let near = self.to_f64()?;
        (MOVES && (self.is_zero() || (1e-300..f64::MAX).contains(&near.abs()))).then_some((near, 0))
    }
}

impl<const MOVES: bool> ToPrimitive for Crude<MOVES> {
    fn to_f64(&self) -> Option<f64> {
        let size = self.0.abs();
        let nearest = size.to_f64()?.min(f64::MAX);
        let short = match nearest.to_bits() % 2 {
            0 => nearest,
            _ if rational(nearest) < size => nearest.next_up().min(f64::MAX),
            _ => nearest.next_down(),
        };
        let normal = if short < f64::MIN_POSITIVE {
            0.0
        } else {
            short
        };
        Some(if self.0.is_negative() {
            -normal
        } else {
            normal
        })
    }

    fn to_i64(&self) -> Option<i64> {
        self.0.to_i64()
    }

    fn to_u64(&self) -> Option<u64> {
        self.0.to_u64()
    }
}

impl<const MOVES: bool> Add for Crude<MOVES> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Crude(self.0 + other.0)
    }
}

impl<const MOVES: bool> Sub for Crude<MOVES> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Crude(self.0 - other.0)
    }
}

impl<const MOVES: bool> Mul for Crude<MOVES> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Crude(self.0 * other.0)
    }
}

impl<const MOVES: bool> Zero for Crude<MOVES> {
    fn zero() -> Self {
        Crude(BigRational::zero())
    }

    fn is_zero(&self) -> bool {
        self.0.is_zero()
    }
}

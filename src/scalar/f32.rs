//! `f32`: every value is a double too, so [`f64`](super::f64) decides.

use core::cmp::Ordering;

use super::Scalar;
use super::forward::forward;

impl Scalar for f32 {
    const APPROX_IS_EXACT: bool = true;

    fn is_finite(&self) -> bool {
        f32::is_finite(*self)
    }

    fn approx(&self) -> f64 {
        f64::from(*self)
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.approx().compare(&other.approx())
    }

    forward!(predicates: f64, |&x: &f32| f64::from(x));
}

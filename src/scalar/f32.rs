//! `f32`: every value is a double too, so [`f64`](super::f64) decides.

use std::cmp::Ordering;

use super::{Scalar, Stage};

impl Scalar for f32 {
    const APPROX_IS_EXACT: bool = true;

    fn is_finite(&self) -> bool {
        f32::is_finite(*self)
    }

    fn approx(&self) -> f64 {
        f64::from(*self)
    }

    fn compare(&self, other: &Self) -> Ordering {
        f64::from(*self).compare(&f64::from(*other))
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
        let [a, b, c] = [a, b, c].map(|p| p.map(f64::from));
        f64::orient2d(&a, &b, &c)
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
        let [a, b, c, d] = [a, b, c, d].map(|p| p.map(f64::from));
        f64::in_circle(&a, &b, &c, &d)
    }

    fn orient2d_exact(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
        let [a, b, c] = [a, b, c].map(|p| p.map(f64::from));
        f64::orient2d_exact(&a, &b, &c)
    }

    fn in_circle_exact(
        a: &[Self; 2],
        b: &[Self; 2],
        c: &[Self; 2],
        d: &[Self; 2],
    ) -> (Ordering, Stage) {
        let [a, b, c, d] = [a, b, c, d].map(|p| p.map(f64::from));
        f64::in_circle_exact(&a, &b, &c, &d)
    }
}

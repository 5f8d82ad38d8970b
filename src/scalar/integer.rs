//! `i32` and `i64`: exact for every value, in integers as wide as the differences require.
//!
//! Cost: 5 to 15 ns a test; big integers only for in-circle tests with differences above 2^62.

use std::cmp::Ordering;

use super::{Scalar, Stage, wide};

/// The difference of two points; it always fits.
fn minus(a: &[i64; 2], b: &[i64; 2]) -> [i128; 2] {
    [0, 1].map(|i| i128::from(a[i]) - i128::from(b[i]))
}

impl Scalar for i64 {
    fn approx(&self) -> f64 {
        *self as f64
    }

    fn difference(&self, other: &Self) -> Option<(f64, i64)> {
        Some(((i128::from(*self) - i128::from(*other)) as f64, 0))
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.cmp(other)
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
        Self::orient2d_exact(a, b, c).0
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
        Self::in_circle_exact(a, b, c, d).0
    }

    fn orient2d_exact(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
        wide::turn(minus(a, c), minus(b, c))
    }

    fn in_circle_exact(
        a: &[Self; 2],
        b: &[Self; 2],
        c: &[Self; 2],
        d: &[Self; 2],
    ) -> (Ordering, Stage) {
        wide::in_circle([a, b, c].map(|p| minus(p, d)))
    }
}

impl Scalar for i32 {
    const APPROX_IS_EXACT: bool = true;

    fn approx(&self) -> f64 {
        f64::from(*self)
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.cmp(other)
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
        Self::orient2d_exact(a, b, c).0
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
        Self::in_circle_exact(a, b, c, d).0
    }

    fn orient2d_exact(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
        let [a, b, c] = [a, b, c].map(|p| p.map(i64::from));
        i64::orient2d_exact(&a, &b, &c)
    }

    fn in_circle_exact(
        a: &[Self; 2],
        b: &[Self; 2],
        c: &[Self; 2],
        d: &[Self; 2],
    ) -> (Ordering, Stage) {
        let [a, b, c, d] = [a, b, c, d].map(|p| p.map(i64::from));
        i64::in_circle_exact(&a, &b, &c, &d)
    }
}

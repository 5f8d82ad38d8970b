//! The exact signs that the checks ask for: the floating-point [`filter`], then the scalar.
//!
//! Vertices go by rank, the order in which the triangles name them first, so that memory follows the
//! triangles; each distinct point has one rank, whatever number of equal points the caller gave.

use std::cmp::Ordering;
use std::ops::AddAssign;

use crate::scalar::{Scalar, Scale, filter};

/// Points by rank.
#[derive(Debug)]
pub(super) struct Signs<'a, S> {
    pub(super) points: &'a [[S; 2]],
    /// For each rank an index into `points`.
    pub(super) vertex: Vec<u32>,
    /// For each rank the approximated coordinates, scaled.
    pub(super) near: Vec<[f64; 2]>,
    pub(super) scale: Scale,
}

/// How signs were decided.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tally {
    pub(super) filtered: u64,
    pub(super) exact: u64,
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Tally) {
        self.filtered += other.filtered;
        self.exact += other.exact;
    }
}

impl Tally {
    #[inline]
    fn count(&mut self, filtered: Option<Ordering>, exact: impl FnOnce() -> Ordering) -> Ordering {
        match filtered {
            Some(sign) => {
                self.filtered += 1;
                sign
            }
            None => {
                self.exact += 1;
                exact()
            }
        }
    }
}

impl<S: Scalar> Signs<'_, S> {
    /// The caller's index of a vertex.
    pub(super) fn name(&self, v: u32) -> usize {
        self.vertex[v as usize] as usize
    }

    fn point(&self, v: u32) -> &[S; 2] {
        &self.points[self.name(v)]
    }

    #[inline]
    pub(super) fn orient2d(&self, [a, b, c]: [u32; 3], tally: &mut Tally) -> Ordering {
        let near = |v: u32| self.near[v as usize];
        let near = [near(a), near(b), near(c)];
        let filtered = filter::orient2d(near, self.scale);
        let filtered = filtered.or_else(|| filter::orient2d_approx(near, self.scale));
        tally.count(filtered, || {
            S::orient2d_exact(self.point(a), self.point(b), self.point(c)).0
        })
    }

    #[inline]
    pub(super) fn in_circle(&self, [a, b, c, d]: [u32; 4], tally: &mut Tally) -> Ordering {
        let near = |v: u32| self.near[v as usize];
        let near = [near(a), near(b), near(c), near(d)];
        let filtered = filter::in_circle(near, self.scale);
        let filtered = filtered.or_else(|| filter::in_circle_approx(near, self.scale));
        tally.count(filtered, || {
            S::in_circle_exact(self.point(a), self.point(b), self.point(c), self.point(d)).0
        })
    }

    /// Order by x, then y.
    pub(super) fn order(&self, a: u32, b: u32) -> Ordering {
        let (p, q) = (self.point(a), self.point(b));
        p[0].compare(&q[0]).then_with(|| p[1].compare(&q[1]))
    }

    /// Whether `a` is left of `b`, or above it.
    pub(super) fn is_left_or_above(&self, a: u32, b: u32) -> bool {
        let (p, q) = (self.point(a), self.point(b));
        p[0].compare(&q[0]).then_with(|| q[1].compare(&p[1])) == Ordering::Less
    }
}

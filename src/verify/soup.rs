//! The input of the verifier, a *triangle soup*: points and triangles of which nothing is known yet; and the exact
//! signs that the checks ask for, from the [`Predicates`] of scalars.
//!
//! Vertices go by rank, the order in which the triangles name them first, so that memory follows the triangles; equal
//! points have one rank. How the triangles fit together is for the checks to find out.

use alloc::vec::Vec;
use core::cmp::Ordering;
use core::ops::AddAssign;

use crate::scalar::{NearTies, Predicates, Scalar, Scale, Stage};

/// How many points or corners of triangles can be verified: ranks and sides are numbers of 31 bits.
pub(super) const LIMIT: usize = 1 << 31;

/// In place of a rejected triangle, since no rank is as large. Later checks skip it, so that a fault is reported once.
pub(super) const REJECTED: [u32; 3] = [u32::MAX; 3];

/// Points and triangles by rank.
#[derive(Debug)]
pub(super) struct Soup<'a, S> {
    pub(super) points: &'a [[S; 2]],
    /// The index of the first added point. Added points that equal one of the input stand for it.
    pub(super) added_from: usize,
    /// For each rank an index into `points`.
    pub(super) vertex: Vec<u32>,
    /// For each rank the approximated coordinates, scaled.
    pub(super) approx: Vec<[f64; 2]>,
    pub(super) scale: Scale,
    pub(super) near_ties: NearTies,
    /// From below; [`REJECTED`] ones stay in their places.
    pub(super) triangles: Vec<[u32; 3]>,
    /// For each of them its number in the caller's list.
    pub(super) numbers: Vec<u32>,
}

impl<S: Scalar> Soup<'_, S> {
    pub(super) fn vertices(&self) -> u32 {
        u32::try_from(self.vertex.len()).expect("the size was checked")
    }

    /// The triangles that no check has rejected, with their numbers.
    pub(super) fn accepted(&self) -> impl Iterator<Item = (u32, [u32; 3])> {
        let triangles = (0..).zip(self.triangles.iter().copied());
        triangles.filter(|&(_, corners)| corners != REJECTED)
    }

    /// The caller's number of a triangle.
    pub(super) fn number(&self, triangle: usize) -> usize {
        self.numbers[triangle] as usize
    }

    /// The ends of side `3 t + i`, which runs from corner `i` of triangle `t` to the next corner.
    pub(super) fn side(&self, side: u32) -> [u32; 2] {
        let (triangle, i) = (self.triangles[side as usize / 3], side as usize % 3);
        [triangle[i], triangle[(i + 1) % 3]]
    }

    /// The caller's indices of vertices.
    pub(super) fn names<const N: usize>(&self, vertices: [u32; N]) -> [usize; N] {
        vertices.map(|v| self.name(v))
    }
}

/// How many signs doubles decided, and how many exact arithmetic did.
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
    fn count(&mut self, stage: Option<Stage>) {
        match stage {
            None => self.filtered += 1,
            Some(_) => self.exact += 1,
        }
    }
}

impl<S: Scalar> Soup<'_, S> {
    /// The caller's index of a vertex.
    pub(super) fn name(&self, v: u32) -> usize {
        self.vertex[v as usize] as usize
    }

    /// Whether a vertex is an added point.
    pub(super) fn is_added(&self, v: u32) -> bool {
        self.name(v) >= self.added_from
    }

    fn point(&self, v: u32) -> &[S; 2] {
        &self.points[self.name(v)]
    }

    #[inline(always)]
    fn predicates(&self) -> Predicates<'_, &[[S; 2]]> {
        Predicates {
            points: &self.points,
            index: &self.vertex,
            approx: &self.approx,
            scale: &self.scale,
            near_ties: &self.near_ties,
        }
    }

    #[inline]
    pub(super) fn orient2d(&self, vertices: [u32; 3], tally: &mut Tally) -> Ordering {
        let (sign, stage) = self.predicates().orient2d(vertices);
        tally.count(stage);
        sign
    }

    /// [`orient2d`](Soup::orient2d), not counted: the standard library decides how many signs a sort or a search takes.
    pub(super) fn turn(&self, vertices: [u32; 3]) -> Ordering {
        self.orient2d(vertices, &mut Tally::default())
    }

    #[inline]
    pub(super) fn in_circle(&self, vertices: [u32; 4], tally: &mut Tally) -> Ordering {
        let (sign, stage) = self.predicates().in_circle(vertices);
        tally.count(stage);
        sign
    }

    /// The order of two vertices by x, then y.
    pub(super) fn order(&self, a: u32, b: u32) -> Ordering {
        let (p, q) = (self.point(a), self.point(b));
        p[0].compare(&q[0]).then_with(|| p[1].compare(&q[1]))
    }

    /// Whether `a` is left of `b`, or above it.
    pub(super) fn is_left_or_above(&self, a: u32, b: u32) -> bool {
        let (p, q) = (self.point(a), self.point(b));
        p[0].compare(&q[0]).then_with(|| q[1].compare(&p[1])) == Ordering::Less
    }

    /// How deep the last vertex lies in the circle of the others, if the scalar tells.
    pub(super) fn depth(&self, vertices: [u32; 4]) -> Option<f64> {
        let [a, b, c, d] = vertices.map(|v| self.point(v));
        S::depth(a, b, c, d)
    }

    /// How far a turn is from straight, if the scalar tells.
    pub(super) fn height(&self, vertices: [u32; 3]) -> Option<f64> {
        let [a, b, c] = vertices.map(|v| self.point(v));
        S::height(a, b, c)
    }
}

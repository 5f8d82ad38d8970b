//! What is to be verified: a *triangle soup*, points and triangles of which nothing is known yet.
//!
//! Vertices go by rank, the order in which the triangles name them first. How the triangles fit together
//! is for the checks to find out.

use super::signs::Signs;
use crate::scalar::Scalar;

/// How many points or corners of triangles can be verified: ranks and sides are numbers of 31 bits.
pub(super) const LIMIT: usize = 1 << 31;

/// Stands in place of a triangle that a check has rejected. Later checks skip it, so that one fault is
/// reported once. No rank is as large.
pub(super) const REJECTED: [u32; 3] = [u32::MAX; 3];

/// Points and triangles by rank.
#[derive(Debug)]
pub(super) struct Soup<'a, S> {
    pub(super) signs: Signs<'a, S>,
    /// In the caller's order; [`REJECTED`] ones stay in their places.
    pub(super) triangles: Vec<[u32; 3]>,
}

impl<S: Scalar> Soup<'_, S> {
    /// How many vertices there are.
    pub(super) fn vertices(&self) -> u32 {
        u32::try_from(self.signs.vertex.len()).expect("the size was checked")
    }

    /// The triangles that no check has rejected, with their numbers.
    pub(super) fn accepted(&self) -> impl Iterator<Item = (u32, [u32; 3])> {
        let triangles = (0..).zip(self.triangles.iter().copied());
        triangles.filter(|&(_, corners)| corners != REJECTED)
    }

    /// The ends of side `3 t + i`, which runs from corner `i` of triangle `t` to the next corner.
    pub(super) fn side(&self, side: u32) -> [u32; 2] {
        let (triangle, i) = (self.triangles[side as usize / 3], side as usize % 3);
        [triangle[i], triangle[(i + 1) % 3]]
    }

    /// The caller's indices of vertices.
    pub(super) fn names<const N: usize>(&self, vertices: [u32; N]) -> [usize; N] {
        vertices.map(|v| self.signs.name(v))
    }
}

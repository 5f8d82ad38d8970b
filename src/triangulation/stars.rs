//! The triangles around each vertex, counter-clockwise.
//!
//! Why it is right: one triangle is kept for each vertex. At a vertex on the hull it is the one with nothing across its
//! clockwise side there, so turning counter-clockwise finds all triangles. At others turning ends where it began. Cost:
//! one pass over the triangles, and 4 bytes a vertex. Each step around a vertex reads one triangle.

use crate::ids::TriangleId;
use crate::mesh::{HalfEdge, next, prev};
use crate::triangulation::Triangulation;
use alloc::vec;
use alloc::vec::Vec;

/// The triangles around each vertex of a [`Triangulation`]; [`Triangulation::vertex_stars`] makes it.
///
/// ```
/// let points = [[0, 0], [2, 0], [2, 2], [0, 2], [1, 1]];
/// let result = sweep_cdt::triangulate(&points, &[])?;
/// let stars = result.vertex_stars();
/// assert_eq!(stars.star(4).count(), 4);
/// assert_eq!(stars.neighbors(1).collect::<Vec<_>>(), [2, 4, 0]);
/// assert!(stars.is_on_hull(1) && !stars.is_on_hull(4));
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct VertexStars<'a> {
    result: &'a Triangulation,
    /// For each vertex the half-edge opposite it in its first triangle.
    first: Vec<HalfEdge>,
}

impl Triangulation {
    /// Finds the triangles around each vertex.
    pub fn vertex_stars(&self) -> VertexStars<'_> {
        let count = self.triangles().flatten().max().map_or(0, |v| v + 1);
        let mut first = vec![HalfEdge::NO_TRIANGLE; count];
        for (t, triangle) in self.triangles.iter().enumerate() {
            for corner in 0..3 {
                let begins = triangle.twin(prev(corner)).is_border();
                let kept = &mut first[self.input_index(triangle.vertex(corner))];
                if begins || *kept == HalfEdge::NO_TRIANGLE {
                    *kept = HalfEdge::new(TriangleId::at(t), corner);
                }
            }
        }
        VertexStars {
            result: self,
            first,
        }
    }
}

impl VertexStars<'_> {
    /// The triangles at vertex `v`, counter-clockwise, each with the position of the vertex in it: 0, 1 or 2.
    ///
    /// At a vertex on the hull the first triangle has its clockwise side there on the hull. A number that is no vertex
    /// of a triangle has no triangles; a duplicate has those of its representative.
    pub fn star(&self, v: usize) -> impl Iterator<Item = (usize, usize)> + Clone + '_ {
        let first = self.first(v);
        let turn = move |side: &HalfEdge| {
            let corner = next(side.corner());
            let across = self.result.triangles[side.triangle().index()].twin(corner);
            // The vertex follows the side that both triangles have.
            let after = (!across.is_border()).then(|| across.next());
            after.filter(|&side| Some(side) != first)
        };
        let sides = core::iter::successors(first, turn);
        sides.map(|side| (side.triangle().index(), side.corner() as usize))
    }

    /// The vertices that sides join to vertex `v`, counter-clockwise; on the hull from one of its sides to the other.
    pub fn neighbors(&self, v: usize) -> impl Iterator<Item = usize> + Clone + '_ {
        let corner = |(t, corner), step: usize| self.result.triangle(t)[(corner + step) % 3];
        let last = self.is_on_hull(v).then(|| self.star(v).last()).flatten();
        let each = self.star(v).map(move |at| corner(at, 1));
        each.chain(last.map(|at| corner(at, 2)))
    }

    /// Whether vertex `v` lies on the border of the hull.
    pub fn is_on_hull(&self, v: usize) -> bool {
        self.first(v).is_some_and(|side| {
            let triangle = &self.result.triangles[side.triangle().index()];
            triangle.twin(prev(side.corner())).is_border()
        })
    }

    /// The half-edge opposite a vertex in its first triangle.
    fn first(&self, v: usize) -> Option<HalfEdge> {
        let first = self.first.get(self.result.representative(v)).copied();
        first.filter(|&side| side != HalfEdge::NO_TRIANGLE)
    }
}

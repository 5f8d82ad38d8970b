//! The edges from band to band, inserted when the hull is complete.
//!
//! Each begins at its upper end, so a triangle must be found there. Most of these edges are short and begin near
//! the bottom of a band. The triangles of a band were made in the order of its vertices, and a flip leaves them in
//! their places. So those of its first vertices are among its first triangles, and these are looked through. For
//! a vertex that is not found there the table of all vertices is made ([`super::super::vertex_triangles`]).
//!
//! Why it is right: a table is made after the last flip, and renewed where triangles are replaced.
//!
//! Cost: O(m log m) to sort m edges. For each band O(k) where the highest upper end is its k-th vertex, and
//! [`MORE`]; or once O(n) for all n vertices. And the insertions.

use super::super::Sweep;
use super::partition::Edge;
use crate::error::Error;
use alloc::vec::Vec;

/// Triangles that are looked through, more than two for each vertex: some of the first vertices' triangles are made
/// late.
const MORE: usize = 1 << 16;

impl Sweep<'_, ()> {
    /// Inserts these edges, numbered in the whole: of each the part down to the first vertex on it. `starts` are the
    /// numbers of the first vertex and the first triangle of each band but the lowest, which has no upper ends.
    pub(super) fn insert_across(
        &mut self,
        mut edges: Vec<Edge>,
        starts: &[(usize, usize)],
    ) -> Result<(), Error> {
        let vertices = self.delaunay.predicates.vertices.len();
        edges.sort_by_key(|&(_, [upper, _])| upper);
        let mut list = Vec::new();
        let (mut edges, mut end) = (&edges[..], self.delaunay.mesh.len());
        for &(vertex, triangle) in starts.iter().rev() {
            let below = edges.partition_point(|(_, [upper, _])| upper.index() < vertex);
            let (others, here) = edges.split_at(below);
            if let Some((_, [highest, _])) = here.last()
                && self.vertex_triangles.len() < vertices
            {
                let listed = vertex..highest.index() + 1;
                let end = end.min(triangle + 2 * listed.len() + MORE);
                self.vertex_triangles
                    .make(&self.delaunay.mesh, listed, triangle..end);
            }
            for edges in here.chunk_by(|(_, [a, _]), (_, [b, _])| a == b) {
                let (_, [upper, _]) = edges[0];
                list.clear();
                list.extend(edges.iter().map(|&(edge, [_, lower])| (lower, edge)));
                let around = self.side_opposite(upper);
                self.insert_edges(upper, &mut list, around)?;
            }
            (edges, end) = (others, triangle);
        }
        Ok(())
    }
}

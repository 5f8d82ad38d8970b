//! The edges from band to band, inserted when the hull is complete.
//!
//! An edge begins at its upper end, so a triangle must be found there. Most of these edges are short and begin near the
//! bottom of a band. A band's triangles were made in the order of its vertices, and flips leave them in their places.
//! So triangles of its first vertices are among its first triangles, and only these are searched. If a vertex is not
//! found there, the vertex triangles table of all vertices is made ([`super::super::vertex_triangles`]).
//!
//! Why it is right: a table is made after the last flip, and renewed where triangles are replaced. Cost, besides the
//! insertions: O(m log m) to sort m edges; for each band O(k) where the highest upper end is its k-th vertex, and
//! [`MADE_LATE`]; or once O(n) for all n vertices.

use super::super::Sweep;
use super::partition::Edge;
use crate::error::Error;
use crate::observe::probe::Probe;
use crate::tuning::MADE_LATE;
use alloc::vec::Vec;

impl<P: Probe> Sweep<'_, P> {
    /// Inserts edges whose ends are numbered in the whole, each down to the first vertex on it. `starts` has the first
    /// vertex and the first triangle of each band but the lowest, in which no such edge has its upper end.
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
                && self.lists.vertex_triangles.len() < vertices
            {
                let listed = vertex..highest.index() + 1;
                let end = end.min(triangle + 2 * listed.len() + MADE_LATE);
                self.lists
                    .vertex_triangles
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

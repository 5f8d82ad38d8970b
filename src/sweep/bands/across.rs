//! The edges from band to band, inserted when the hull is complete.
//!
//! Each begins at its upper end, so a triangle must be found there. Most of these edges are short and begin near
//! the bottom of a band. The triangles of a band were made in the order of its vertices, and a flip leaves them in
//! their places. So those of its first vertices are among its first triangles, and these are looked through. Where
//! none is found there, or it has changed since, the table of all vertices is made ([`super::super::incidence`]).
//!
//! Cost: O(k) where the highest upper end is the k-th vertex of its band, or O(n) for n vertices where the table is
//! made; and the insertions.

use super::super::state::Sweep;
use crate::error::Error;
use crate::front::FrontSearch;
use crate::ids::{TriangleId, VertexId};
use crate::mesh::{Mesh, Side};
use crate::scalar::Scalar;

/// How many triangles more than two for each vertex are looked through.
const MORE: usize = 1 << 16;

/// Where the bands begin, but the lowest: the numbers of their first vertices and first triangles.
#[derive(Debug, Default)]
pub(super) struct Starts {
    bands: Vec<(usize, usize)>,
}

impl Starts {
    /// Adds the band above the others.
    pub(super) fn add(&mut self, vertex: usize, triangle: usize) {
        self.bands.push((vertex, triangle));
    }

    /// The band in which a vertex is.
    fn band(&self, v: VertexId) -> usize {
        self.bands
            .partition_point(|&(vertex, _)| vertex <= v.index())
            - 1
    }
}

/// For the first vertices of a band the side opposite each in one of its triangles, or nothing.
struct Bottom {
    first: usize,
    opposite: Vec<Side>,
}

impl Bottom {
    /// Those of so many vertices, from these numbers of a vertex and of a triangle on.
    fn new(mesh: &Mesh, (first, triangle): (usize, usize), vertices: usize) -> Bottom {
        let mut opposite = vec![Side::NOTHING; vertices];
        let end = mesh.len().min(triangle + 2 * vertices + MORE);
        for t in (triangle..end).map(TriangleId::at) {
            for (corner, v) in (0..).zip(mesh.get(t).vertices()) {
                let place = v.index().checked_sub(first);
                if let Some(entry) = place.and_then(|place| opposite.get_mut(place)) {
                    *entry = Side::new(t, corner);
                }
            }
        }
        Bottom { first, opposite }
    }

    /// What was noted for a vertex, if it is still so.
    fn at(&self, mesh: &Mesh, v: VertexId) -> Option<Side> {
        let side = *self.opposite.get(v.index() - self.first)?;
        (side != Side::NOTHING && mesh.opposite(side) == v).then_some(side)
    }
}

impl<S: Scalar, F: FrontSearch> Sweep<'_, S, F, ()> {
    /// Inserts these edges, given with both ends, upper one first: of each the part down to the first vertex on it.
    pub(super) fn insert_across(
        &mut self,
        mut across: Vec<(u32, [VertexId; 2])>,
        starts: &Starts,
    ) -> Result<(), Error> {
        across.sort_unstable_by_key(|&(edge, [upper, _])| (upper, edge));
        let band = |edge: &(u32, [VertexId; 2])| starts.band(edge.1[0]);
        for edges in across.chunk_by(|a, b| band(a) == band(b)) {
            let (first, triangle) = starts.bands[band(&edges[0])];
            let highest = edges.last().map_or(first, |(_, [upper, _])| upper.index());
            let bottom = Bottom::new(&self.fabric.mesh, (first, triangle), highest + 1 - first);
            for edges in edges.chunk_by(|(_, [a, _]), (_, [b, _])| a == b) {
                let (_, [upper, _]) = edges[0];
                self.list.clear();
                self.list
                    .extend(edges.iter().map(|&(edge, [_, lower])| (lower, edge)));
                let around = match bottom.at(&self.fabric.mesh, upper) {
                    Some(side) => side,
                    None => self.around(upper),
                };
                self.insert_edges(upper, around)?;
            }
        }
        Ok(())
    }
}

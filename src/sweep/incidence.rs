//! For vertices one of their triangles each, in a triangulation that is complete.
//!
//! While vertices are swept, the front leads to the triangles of the vertex swept last. Once the hull is
//! complete, an edge may begin at any vertex, and this table says where. It lists all vertices, or some that
//! follow each other ([`super::bands`]).
//!
//! Why it stays right: the insertion of a part changes only the triangles that it pierces. The new ones
//! take their places, and each of their vertices is a vertex of a new one ([`super::pseudo_polygons`]).
//!
//! Cost: O(k + t) to make for k vertices and t triangles, O(k) to renew for k pierced triangles; 4 bytes a vertex.

use std::ops::Range;

use crate::ids::{TriangleId, VertexId};
use crate::mesh::{HalfEdge, Mesh};

/// For each vertex from number `first` on the side opposite it in one of its triangles, or nothing. Empty until it
/// is made.
#[derive(Debug, Default)]
pub(super) struct Incidence {
    first: usize,
    opposite: Vec<HalfEdge>,
}

impl Incidence {
    /// Makes the table of these vertices, and finds them in these triangles.
    pub(super) fn make(&mut self, mesh: &Mesh, vertices: Range<usize>, triangles: Range<usize>) {
        self.clear();
        self.first = vertices.start;
        self.opposite.resize(vertices.len(), HalfEdge::NOTHING);
        for t in triangles.map(TriangleId::at) {
            self.note(mesh, t);
        }
    }

    /// Forgets the table.
    pub(super) fn clear(&mut self) {
        self.opposite.clear();
    }

    /// How many vertices are listed.
    pub(super) fn len(&self) -> usize {
        self.opposite.len()
    }

    /// The side opposite `v` in one of its triangles, if the table knows one.
    pub(super) fn at(&self, v: VertexId) -> Option<HalfEdge> {
        let place = v.index().checked_sub(self.first)?;
        let side = *self.opposite.get(place)?;
        (side != HalfEdge::NOTHING).then_some(side)
    }

    /// Notes new triangles in these places, if the table has been made.
    pub(super) fn renew(&mut self, mesh: &Mesh, places: &[TriangleId]) {
        if self.len() > 0 {
            for &t in places {
                self.note(mesh, t);
            }
        }
    }

    fn note(&mut self, mesh: &Mesh, t: TriangleId) {
        for (corner, v) in (0..).zip(mesh.get(t).vertices()) {
            let place = v.index().checked_sub(self.first);
            if let Some(entry) = place.and_then(|place| self.opposite.get_mut(place)) {
                *entry = HalfEdge::new(t, corner);
            }
        }
    }

    /// Bytes held.
    pub(super) fn heap_bytes(&self) -> usize {
        self.opposite.capacity() * size_of::<HalfEdge>()
    }
}

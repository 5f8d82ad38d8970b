//! For each vertex one of its triangles, in a triangulation that is complete.
//!
//! While vertices are swept, the front leads to the triangles of the vertex swept last. Once the hull is
//! complete, an edge may begin at any vertex, and this table says where.
//!
//! Why it stays right: the insertion of a part changes only the triangles that it pierces. The new ones
//! take their places, and each of their vertices is a vertex of a new one ([`super::pseudo_polygons`]).
//!
//! Cost: O(n) to make, O(k) to renew for k pierced triangles; 4 bytes a vertex.

use crate::ids::{TriangleId, VertexId};
use crate::mesh::{Mesh, Side};

/// For each vertex the side opposite it in one of its triangles. Empty until it is made.
#[derive(Debug, Default)]
pub(super) struct Incidence {
    opposite: Vec<Side>,
}

impl Incidence {
    /// Makes the table of all `vertices` vertices, artificial ones excluded.
    pub(super) fn make(&mut self, mesh: &Mesh, vertices: usize) {
        self.clear();
        self.opposite.resize(vertices, Side::NOTHING);
        for t in (0..mesh.len()).map(TriangleId::at) {
            self.note(mesh, t);
        }
    }

    /// Forgets the table.
    pub(super) fn clear(&mut self) {
        self.opposite.clear();
    }

    /// Whether the table has been made.
    pub(super) fn is_made(&self) -> bool {
        !self.opposite.is_empty()
    }

    /// The side opposite `v` in one of its triangles.
    pub(super) fn at(&self, v: VertexId) -> Side {
        self.opposite[v.index()]
    }

    /// Notes new triangles in these places, if the table has been made.
    pub(super) fn renew(&mut self, mesh: &Mesh, places: &[TriangleId]) {
        if self.is_made() {
            for &t in places {
                self.note(mesh, t);
            }
        }
    }

    fn note(&mut self, mesh: &Mesh, t: TriangleId) {
        for (corner, v) in (0..).zip(mesh.get(t).vertices()) {
            if let Some(entry) = self.opposite.get_mut(v.index()) {
                *entry = Side::new(t, corner);
            }
        }
    }

    /// Bytes held.
    pub(super) fn memory(&self) -> usize {
        self.opposite.capacity() * size_of::<Side>()
    }
}

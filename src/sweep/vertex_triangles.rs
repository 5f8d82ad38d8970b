//! A triangle of each vertex, for edges that begin at any vertex.
//!
//! While vertices are swept, the front leads to the triangles of the vertex swept last. Once the hull is complete, an
//! edge may begin anywhere, and a table says where: it has a triangle of each vertex, or of some that follow each other
//! (`bands`). It stays right, because the insertion of a part changes only the triangles that it pierces. The new ones
//! take their places, and have all their vertices ([`super::delaunay`]).
//!
//! Cost: O(k + t) to make for k vertices and t triangles, O(k) to renew for k pierced triangles; 4 bytes a vertex.

use alloc::vec::Vec;
use core::ops::Range;

use super::Sweep;
use crate::ids::{TriangleId, VertexId};
use crate::mesh::{HalfEdge, Mesh};
use crate::observe::probe::Probe;

impl<P: Probe> Sweep<'_, P> {
    /// A half-edge opposite `v`. Makes the table of all vertices if the present one has no triangle of `v`.
    pub(super) fn side_opposite(&mut self, v: VertexId) -> HalfEdge {
        if let Some(side) = self.lists.vertex_triangles.at(v) {
            return side;
        }
        let (mesh, vertices) = (&self.delaunay.mesh, self.delaunay.predicates.vertices.len());
        self.lists
            .vertex_triangles
            .make(mesh, 0..vertices, 0..mesh.len());
        let side = self.lists.vertex_triangles.at(v);
        side.expect("every vertex has triangles, if only artificial ones")
    }
}

/// A half-edge opposite each vertex from rank `first` on, or nothing: the vertex triangles table. Empty until made.
#[derive(Debug, Default)]
pub(super) struct VertexTriangles {
    first: usize,
    opposite: Vec<HalfEdge>,
}

impl VertexTriangles {
    /// Makes the table of these vertices by looking through these triangles.
    pub(super) fn make(&mut self, mesh: &Mesh, vertices: Range<usize>, triangles: Range<usize>) {
        self.clear();
        self.first = vertices.start;
        self.opposite.resize(vertices.len(), HalfEdge::NOTHING);
        for t in triangles.map(TriangleId::at) {
            self.note(mesh, t);
        }
    }

    pub(super) fn clear(&mut self) {
        self.opposite.clear();
    }

    pub(super) fn len(&self) -> usize {
        self.opposite.len()
    }

    /// A half-edge opposite `v`, if the table has one.
    pub(super) fn at(&self, v: VertexId) -> Option<HalfEdge> {
        let place = v.index().checked_sub(self.first)?;
        let side = *self.opposite.get(place)?;
        (side != HalfEdge::NOTHING).then_some(side)
    }

    /// Notes the new triangles in these places, if the table has been made.
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

    pub(super) fn heap_bytes(&self) -> usize {
        self.opposite.capacity() * size_of::<HalfEdge>()
    }
}

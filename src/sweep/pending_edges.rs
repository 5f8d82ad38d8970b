//! Pending edges: what is left of edges that pass through vertices, inserted when the hull is complete.
//!
//! The edge event (section 3.4.2) inserts an edge down to the first vertex on it. The rest is an edge that begins at
//! this vertex. All pending edges that begin at one vertex are inserted together, vertex by vertex from the last in
//! sweep order to the first, because a pending edge may leave another one, further down.
//!
//! ```text
//!    a   b   c        Three edges through one vertex (a-a', b-b', c-c'). Each edge event inserts its
//!     \  |  /         upper half. The lower halves leave the hub in all directions; sorted by angle
//!      \ | /          they are found by one turn around the hub. Inserted one by one, each would need
//!       hub           a turn of its own, and m edges through the hub would take O(m^2).
//!      / | \
//!     /  |  \
//!    c'  b'  a'
//! ```
//!
//! Why it is right: the insertion of an edge in parts gives the same triangulation in whichever order the parts come,
//! because there is only one (the canonical rule). Cost: O(d + k log k) for k edges at a vertex with d triangles.
//!
//! While vertices are swept, the front leads to the triangles of the vertex swept last. Once the hull is complete, an
//! edge may begin at any vertex, and the table [`VertexTriangles`] says where: it has a triangle of each vertex, or of
//! some that follow each other (`bands`). It stays right, because the insertion of a part changes only the triangles
//! that it pierces. The new ones take their places, and have all their vertices ([`super::delaunay`]). Cost: O(k + t)
//! to make for k vertices and t triangles, O(k) to renew for k pierced triangles; 4 bytes a vertex.
use alloc::collections::BinaryHeap;
use alloc::vec::Vec;
use core::ops::Range;

use super::Sweep;
use crate::error::Error;
use crate::ids::{TriangleId, VertexId};
use crate::mesh::{HalfEdge, Mesh};
use crate::observe::probe::Probe;

/// The rest of an edge behind a vertex on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct PendingEdge {
    /// The vertex on the edge where the pending edge begins.
    pub(super) from: VertexId,
    pub(super) edge: u32,
    pub(super) lower: VertexId,
}

impl PendingEdge {
    pub(super) fn new(from: VertexId, lower: VertexId, edge: u32) -> PendingEdge {
        PendingEdge { from, edge, lower }
    }
}

/// The pending edges; the one that begins last in sweep order comes first.
pub(super) type PendingEdges = BinaryHeap<PendingEdge>;

impl<P: Probe> Sweep<'_, P> {
    /// Inserts all pending edges; the hull is complete.
    pub(super) fn insert_pending(&mut self) -> Result<(), Error> {
        let mut list = Vec::new();
        while let Some(&PendingEdge { from, .. }) = self.pending.peek() {
            list.clear();
            while let Some(rest) = self.pending.peek().copied()
                && rest.from == from
            {
                list.push((rest.lower, rest.edge));
                self.pending.pop();
            }
            list.reverse();
            let around = self.side_opposite(from);
            self.insert_edges(from, &mut list, around)?;
        }
        Ok(())
    }

    /// A half-edge opposite `v`. Makes the table of all vertices if the present one has no triangle of `v`.
    pub(super) fn side_opposite(&mut self, v: VertexId) -> HalfEdge {
        if let Some(side) = self.vertex_triangles.at(v) {
            return side;
        }
        let (mesh, vertices) = (&self.delaunay.mesh, self.delaunay.predicates.vertices.len());
        self.vertex_triangles.make(mesh, 0..vertices, 0..mesh.len());
        let side = self.vertex_triangles.at(v);
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

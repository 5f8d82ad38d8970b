//! The pending edges of edges that pass through vertices, inserted when the hull is complete.
//!
//! The edge event (section 3.4.2) inserts an edge down to the first vertex on it. The rest of the edge is an
//! edge that begins at this vertex. All pending edges that begin at one vertex are inserted together, vertex by
//! vertex from the last in sweep order to the first, because a rest may leave another one, further down.
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
//! Why it is right: the insertion of an edge in parts gives the same triangulation in whichever order the
//! parts come, because there is only one (the canonical rule).
//!
//! Cost: O(d + k log k) to find the ways of k pending edges that begin at a vertex with d triangles.
//!
//! Differs from the paper: it does not speak of vertices on edges.

use super::edges::PendingEdge;
use super::state::Sweep;
use crate::error::Error;
use crate::ids::VertexId;
use crate::mesh::HalfEdge;
use crate::probe::Probe;
use crate::scalar::Scalar;

impl<S: Scalar, P: Probe> Sweep<'_, S, P> {
    /// Inserts all pending edges; the hull is complete.
    pub(super) fn insert_pending(&mut self) -> Result<(), Error> {
        while let Some(&PendingEdge { from, .. }) = self.pending.peek() {
            self.list.clear();
            while let Some(rest) = self.pending.peek().copied()
                && rest.from == from
            {
                self.list.push((rest.lower, rest.edge));
                self.pending.pop();
            }
            self.list.reverse();
            let around = self.side_opposite(from);
            self.insert_edges(from, around)?;
        }
        Ok(())
    }

    /// The side opposite `v` in one of its triangles. If the table does not know one, that of all vertices is made.
    pub(super) fn side_opposite(&mut self, v: VertexId) -> HalfEdge {
        if let Some(side) = self.incidence.at(v) {
            return side;
        }
        let (mesh, vertices) = (&self.delaunay.mesh, self.delaunay.predicates.vertices.len());
        self.incidence.make(mesh, 0..vertices, 0..mesh.len());
        let side = self.incidence.at(v);
        side.expect("every vertex has triangles, if only artificial ones")
    }
}

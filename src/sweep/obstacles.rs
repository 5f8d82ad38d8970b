//! What is in the way of an edge (section 3.4.2): pierced triangles and pockets of the front. The traversal
//! ([`super::traversal`]) finds them, and the edge event removes the triangles and fills the pockets.

use crate::ids::{TriangleId, VertexId};
use crate::mesh::HalfEdge;

/// One part of an edge: down to the first vertex on it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    /// The vertex where it ends.
    pub(super) end: VertexId,
    /// A side opposite the vertex where it starts.
    pub(super) start: HalfEdge,
    /// The side that the part is, if it is a side already; otherwise it pierces triangles or pockets.
    pub(super) present: Option<HalfEdge>,
}

/// Both vertices of a constrained side that the edge would cross.
pub(super) type Crossed = [VertexId; 2];

/// What is in the way of a part.
#[derive(Debug, Default)]
pub(super) struct Obstacles {
    /// The pierced triangles, from the upper end down.
    pub(super) pierced: Vec<TriangleId>,
    /// The sides of pierced triangles on the border of the pseudo-polygon left of the part, from the
    /// upper end down.
    pub(super) left: Vec<HalfEdge>,
    /// Those on the border of the one right of it.
    pub(super) right: Vec<HalfEdge>,
    /// For each pocket under the part the two nodes where it begins and ends, left one first.
    pub(super) pockets: Vec<[VertexId; 2]>,
    /// The sides that edges with one upper end are already, so that nothing is in their way.
    pub(super) present: Vec<HalfEdge>,
}

impl Obstacles {
    /// Forgets what was in the way of the part before.
    pub(super) fn begin_part(&mut self) {
        self.pierced.clear();
        self.left.clear();
        self.right.clear();
    }
}

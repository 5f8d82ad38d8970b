//! What an edge runs into (section 3.4.2): found by the traversal ([`super::traversal`]), filled and
//! removed by the edge event.

use crate::ids::{TriangleId, VertexId};
use crate::mesh::Side;

/// What one part of an edge, down to the next vertex on it, runs into.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    /// The vertex where it ends.
    pub(super) end: VertexId,
    /// A side opposite the vertex where it starts.
    pub(super) start: Side,
    /// A side opposite the vertex where it ends.
    pub(super) onward: Side,
    /// The side that the part is, if it is there already; else triangles are pierced.
    pub(super) present: Option<Side>,
}

/// Both vertices of a fixed side that the edge would cross.
pub(super) type Crossed = [VertexId; 2];

/// What the last part met, and the pockets under all parts.
#[derive(Debug, Default)]
pub(super) struct Obstacles {
    /// The pierced triangles, from the upper end down.
    pub(super) pierced: Vec<TriangleId>,
    /// The sides of pierced triangles on the border of the pseudo-polygon left of the part, from the
    /// upper end down.
    pub(super) left: Vec<Side>,
    /// Those on the border of the one right of it.
    pub(super) right: Vec<Side>,
    /// The nodes between which the front runs below the edge, left one first; of all parts.
    pub(super) pockets: Vec<[VertexId; 2]>,
}

impl Obstacles {
    /// Forgets what the part before met.
    pub(super) fn begin_part(&mut self) {
        self.pierced.clear();
        self.left.clear();
        self.right.clear();
    }
}

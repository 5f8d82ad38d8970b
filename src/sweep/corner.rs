//! One corner of a chain of border half-edges; see [`super::chain`].

use crate::ids::{BorderId, VertexId};

/// A vertex of a chain and the border half-edge from it to the next one (meaningless for the last one).
///
/// If a triangle borders on the border half-edge from outside, closing the corner joins it to the new triangle,
/// and their common side goes on the flip stack. If none does, the border half-edge stays, and the new triangle
/// borders on it.
#[derive(Clone, Copy, Debug)]
pub(super) struct ChainVertex {
    pub(super) vertex: VertexId,
    pub(super) border: BorderId,
}

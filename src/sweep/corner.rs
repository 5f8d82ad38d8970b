//! One corner of a chain of open sides; see [`super::chain`].

use crate::ids::{OpenId, VertexId};

/// A vertex of a chain and the open side from it to the next one (meaningless for the last one).
///
/// If a triangle borders on the open side from outside, closing the corner joins it to the new triangle,
/// and their common side becomes a suspect. If none does, the open side stays, and the new triangle
/// borders on it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) vertex: VertexId,
    pub(super) open: OpenId,
}

//! One corner of a chain of open sides; see [`super::chain`].

use crate::ids::{OpenId, VertexId};

/// A vertex of a chain and the open side from it to the next one (of the last one it means nothing).
///
/// Where a triangle borders on the open side from outside, closing a corner joins that triangle and the
/// new one, and their common side becomes a suspect. Where none does, the new triangle is what borders
/// on it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) vertex: VertexId,
    pub(super) open: OpenId,
}

//! The two pseudo-polygons of an edge (section 3.4.2, figure 12) while they are filled ([`super::pseudo_polygons`]):
//! working memory, kept from one edge to the next.

use super::corner::ChainVertex;
use crate::ids::{BorderId, TriangleId};
use crate::mesh::HalfEdge;

/// Both pseudo-polygons of an edge.
#[derive(Debug, Default)]
pub(super) struct Polygons {
    pub(super) right: Vec<ChainVertex>,
    pub(super) left: Vec<ChainVertex>,
    pub(super) seams: Seams,
}

/// The border half-edges on the border of both pseudo-polygons.
#[derive(Debug, Default)]
pub(super) struct Seams {
    /// The pierced triangles, ascending.
    pub(super) pierced: Vec<TriangleId>,
    /// Each with what lies across it.
    pub(super) outer: Vec<(BorderId, HalfEdge)>,
    /// Hanging edges: the pierced triangle's side, what lies across, and the border half-edge in its place.
    pub(super) hanging: Vec<(HalfEdge, HalfEdge, BorderId)>,
}

impl Seams {
    /// Begins with these pierced triangles, which are needed until the borders are known; then their places are used
    /// again.
    pub(super) fn begin(&mut self, pierced: &[TriangleId]) {
        self.pierced.clear();
        self.pierced.extend_from_slice(pierced);
        self.pierced.sort_unstable();
        self.outer.clear();
        self.hanging.clear();
    }
}

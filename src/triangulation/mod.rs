//! The result: triangles, neighbours, constrained sides, hull, duplicates, and chains of edges, by input indices.

pub(crate) mod canonical;
pub(crate) mod edge_chains;
pub(crate) mod locate;
mod locate_all;
#[cfg(feature = "serde")]
mod serialized;
pub(crate) mod stars;
mod strips;
pub(crate) mod with_points;

use alloc::vec::Vec;

use crate::ids::{VertexId, narrow};
use crate::mesh::{self, HalfEdge, Triangle};
use crate::triangulation::canonical::canonical;
use crate::triangulation::edge_chains::EdgeChains;

/// A constrained Delaunay triangulation: plain indices, no coordinates.
///
/// Triangles are numbered `0..len()`, in the order in which the sweep left them. As a *set* they are the same for every
/// front, scalar and heuristic setting and, up to the numbers of the points, for every order of the input. Results are
/// equal (`==`) if they have the same triangles, however numbered, the same duplicates, and the same chains. The vertices
/// of a triangle run counter-clockwise; side `i` lies opposite vertex `i`. Of equal input points only the one with the
/// lowest index, their [`representative`](Triangulation::representative), occurs in triangles, hull and chains. Methods
/// panic if there is no triangle `t`, side `side` (0, 1 or 2) or edge `e`.
///
/// ```
/// let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0], [2.0, 1.0]];
/// let result = sweep_cdt::triangulate(&points, &[[0, 2]])?;
/// assert_eq!(result.len(), 4);
/// assert_eq!(result.canonical_triangles()[0], [0, 1, 4]);
/// assert_eq!(result.hull().collect::<Vec<_>>(), [3, 0, 1, 2]);
/// assert_eq!(result.edge_chain(0).collect::<Vec<_>>(), [0, 2]);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Triangulation {
    /// The triangles; their vertices are positions in `vertices`.
    pub(crate) triangles: Vec<Triangle>,
    /// The input index of each vertex, by rank. Looked up when a triangle is read: a pass over all would take longer.
    pub(crate) vertices: Vec<u32>,
    pub(crate) hull: Vec<u32>,
    /// `(vertex, representative)` of each duplicate, by vertex.
    pub(crate) duplicates: Vec<(u32, u32)>,
    pub(crate) chains: EdgeChains,
}

impl Triangulation {
    /// How many triangles there are; none if fewer than three points are distinct or all lie on a line.
    pub fn len(&self) -> usize {
        self.triangles.len()
    }

    /// Whether there is no triangle.
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// The vertices of triangle `t`, counter-clockwise.
    #[inline]
    pub fn triangle(&self, t: usize) -> [usize; 3] {
        self.corners(&self.triangles[t]).map(|v| v as usize)
    }

    /// The vertices in the order of the sweep, one for each set of equal points. For windows of streams.
    #[doc(hidden)]
    pub fn sweep_order(&self) -> &[u32] {
        &self.vertices
    }

    /// The vertices of triangle `t` by their places in that order.
    #[doc(hidden)]
    #[inline]
    pub fn places(&self, t: usize) -> [usize; 3] {
        self.triangles[t].vertices().map(VertexId::index)
    }

    /// All triangles, by number.
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = [usize; 3]> + Clone + '_ {
        let corners = |triangle| self.corners(triangle).map(|v| v as usize);
        self.triangles.iter().map(corners)
    }

    /// The triangles in one order for all runs on the same input: each begins with its lowest vertex, and the list is
    /// sorted. With the feature `parallel` long lists are sorted on all threads of the current rayon pool.
    pub fn canonical_triangles(&self) -> Vec<[usize; 3]> {
        canonical(self.len(), |t| self.corners(&self.triangles[t]))
    }

    /// The triangle across side `side` of triangle `t`, or `None` on the hull.
    #[inline]
    pub fn neighbor(&self, t: usize, side: usize) -> Option<usize> {
        self.twin(t, side).map(|(across, _)| across)
    }

    /// The triangles across the three sides of triangle `t`.
    #[inline]
    pub fn neighbors(&self, t: usize) -> [Option<usize>; 3] {
        [0, 1, 2].map(|side| self.neighbor(t, side))
    }

    /// The triangle across side `side` of triangle `t`, and which of its sides this one is; `None` on the hull.
    #[inline]
    pub fn twin(&self, t: usize, side: usize) -> Option<(usize, usize)> {
        let twin = self.half_edge_across(t, side);
        (!twin.is_border()).then(|| (twin.triangle().index(), twin.corner() as usize))
    }

    /// The ends of side `side` of triangle `t`, which lies on the left on the way from the first to the second.
    #[inline]
    pub fn side(&self, t: usize, side: usize) -> [usize; 2] {
        let corners = self.triangle(t);
        assert!(side < 3, "a triangle has sides 0, 1 and 2");
        [corners[(side + 1) % 3], corners[(side + 2) % 3]]
    }

    /// Whether side `side` of triangle `t` is an input edge or a piece of one.
    #[inline]
    pub fn is_constrained(&self, t: usize, side: usize) -> bool {
        self.half_edge_across(t, side).is_constrained()
    }

    /// All sides, each once: pairs of vertices, with a triangle on the left.
    pub fn sides(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        self.sides_where(|_| true)
    }

    /// The sides that are input edges or pieces of them, each once: pairs of vertices, with a triangle on the left.
    pub fn constrained_sides(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        self.sides_where(HalfEdge::is_constrained)
    }

    /// The sides whose half-edge across is to be listed, each once.
    fn sides_where(&self, is_listed: fn(HalfEdge) -> bool) -> impl Iterator<Item = [usize; 2]> {
        (0..self.len()).flat_map(move |t| {
            let triangle = &self.triangles[t];
            (0..3).filter_map(move |side| {
                let twin = triangle.twin(side);
                let is_first = twin.is_border() || twin.triangle().index() > t;
                let ends = [mesh::next(side), mesh::prev(side)].map(|i| triangle.vertex(i));
                (is_first && is_listed(twin)).then(|| ends.map(|v| self.input_index(v)))
            })
        })
    }

    /// The vertices on the border of the convex hull, counter-clockwise, from the leftmost one (the upper one of
    /// several), with those inside a straight part. Empty if there is no triangle.
    pub fn hull(&self) -> impl ExactSizeIterator<Item = usize> + Clone + '_ {
        self.hull.iter().map(|&v| v as usize)
    }

    /// The lowest index of a point equal to point `v`: `v` itself unless it is a duplicate.
    pub fn representative(&self, v: usize) -> usize {
        let found = self
            .duplicates
            .binary_search_by_key(&v, |&(duplicate, _)| duplicate as usize);
        found.map_or(v, |at| self.duplicates[at].1 as usize)
    }

    /// The points that equal one of a lower index, each with its representative, by index.
    pub fn duplicates(&self) -> impl ExactSizeIterator<Item = [usize; 2]> + Clone + '_ {
        self.duplicates
            .iter()
            .map(|&(vertex, of)| [vertex as usize, of as usize])
    }

    /// The vertices along input edge `e` as representatives, from its first end to its second: two, more if vertices lie
    /// on the edge, one if its ends are equal. Neighbours in the chain form sides.
    pub fn edge_chain(&self, e: usize) -> impl ExactSizeIterator<Item = usize> + Clone + '_ {
        self.chains.chain(e).map(|v| v as usize)
    }

    /// How many edges were given. For refinement.
    #[doc(hidden)]
    pub fn edge_count(&self) -> usize {
        self.chains.len()
    }

    #[inline]
    pub(crate) fn input_index(&self, v: VertexId) -> usize {
        self.vertices[v.index()] as usize
    }

    #[inline]
    pub(crate) fn corners(&self, triangle: &Triangle) -> [u32; 3] {
        triangle.vertices().map(|v| self.vertices[v.index()])
    }

    #[inline]
    fn half_edge_across(&self, t: usize, side: usize) -> HalfEdge {
        assert!(side < 3, "a triangle has sides 0, 1 and 2");
        self.triangles[t].twin(narrow(side))
    }
}

impl PartialEq for Triangulation {
    fn eq(&self, other: &Self) -> bool {
        let has_chain = |e| self.chains.chain(e).eq(other.chains.chain(e));
        self.len() == other.len()
            && self.chains.len() == other.chains.len()
            && self.duplicates == other.duplicates
            && (0..self.chains.len()).all(has_chain)
            && self.canonical_triangles() == other.canonical_triangles()
    }
}

impl Eq for Triangulation {}

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
#[cfg(feature = "parallel")]
use rayon::prelude::*;

use crate::ids::{VertexId, narrow};
use crate::mesh::{self, HalfEdge, Triangle};
use crate::triangulation::canonical::{CanonicalGroups, canonical};
use crate::triangulation::edge_chains::EdgeChains;

/// A constrained Delaunay triangulation: plain indices, no coordinates.
///
/// Triangles are numbered `0..len()`, in the order in which the sweep left them. As a *set* they are the same for every
/// front, scalar and heuristic setting and, up to the numbers of the points, for every order of the input. Compare
/// results by [`canonical_triangles`](Triangulation::canonical_triangles). The vertices of a triangle run
/// counter-clockwise; side `i` lies opposite vertex `i`. Of equal input points only the one with the lowest index,
/// their [`representative`](Triangulation::representative), occurs in triangles, hull and chains. Methods panic if
/// there is no triangle `t`, side `side` (0, 1 or 2) or edge `e`.
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
        self.corners(&self.triangles[t])
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
        self.triangles.iter().map(|triangle| self.corners(triangle))
    }

    /// The triangles in one order for all runs on the same input: each begins with its lowest vertex, and the list is
    /// sorted. With the feature `parallel` long lists are made on all threads of the current rayon pool.
    pub fn canonical_triangles(&self) -> Vec<[usize; 3]> {
        canonical(self.len(), |t| self.triangle(t))
    }

    /// The triangles of [`canonical_triangles`](Self::canonical_triangles), group by group.
    pub fn canonical_groups(&self) -> CanonicalGroups {
        CanonicalGroups::new(self.len(), |t| self.triangle(t))
    }

    /// The triangle across side `side` (0, 1 or 2) of triangle `t`, or `None` on the hull.
    #[inline]
    pub fn neighbor(&self, t: usize, side: usize) -> Option<usize> {
        let twin = self.twin(t, side);
        (!twin.is_border()).then(|| twin.triangle().index())
    }

    /// The triangles across the three sides of triangle `t`.
    #[inline]
    pub fn neighbors(&self, t: usize) -> [Option<usize>; 3] {
        [0, 1, 2].map(|side| self.neighbor(t, side))
    }

    /// Whether side `side` of triangle `t` is an input edge or a piece of one.
    #[inline]
    pub fn is_constrained(&self, t: usize, side: usize) -> bool {
        self.twin(t, side).is_constrained()
    }

    /// The sides that are input edges or pieces of them, each once: pairs of vertices, with the triangle on the left.
    pub fn constrained_sides(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        (0..self.len()).flat_map(|t| self.constrained_sides_of(t))
    }

    fn constrained_sides_of(&self, t: usize) -> impl Iterator<Item = [usize; 2]> + '_ {
        let triangle = &self.triangles[t];
        (0..3).filter_map(move |side| {
            let twin = triangle.twin(side);
            let is_listed = twin.is_border() || twin.triangle().index() > t;
            (twin.is_constrained() && is_listed).then(|| {
                [mesh::next(side), mesh::prev(side)].map(|i| self.input_index(triangle.vertex(i)))
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

    #[inline]
    pub(crate) fn input_index(&self, v: VertexId) -> usize {
        self.vertices[v.index()] as usize
    }

    #[inline]
    fn corners(&self, triangle: &Triangle) -> [usize; 3] {
        let [a, b, c] = triangle.vertices();
        [
            self.input_index(a),
            self.input_index(b),
            self.input_index(c),
        ]
    }

    #[inline]
    fn twin(&self, t: usize, side: usize) -> HalfEdge {
        assert!(side < 3, "a triangle has sides 0, 1 and 2");
        self.triangles[t].twin(narrow(side))
    }
}

#[cfg(feature = "parallel")]
impl Triangulation {
    /// All triangles, by number, on all threads of the current rayon pool.
    ///
    /// ```
    /// use rayon::prelude::*;
    ///
    /// let points: Vec<_> = (0..1000).map(|i| [i * i % 997, i]).collect();
    /// let result = sweep_cdt::triangulate(&points, &[])?;
    /// let area = |[a, b, c]: [usize; 3]| {
    ///     let [[ax, ay], [bx, by], [cx, cy]] = [points[a], points[b], points[c]];
    ///     i64::from((bx - ax) * (cy - ay) - (by - ay) * (cx - ax))
    /// };
    /// let one: i64 = result.triangles().map(area).sum();
    /// assert_eq!(result.par_triangles().map(area).sum::<i64>(), one);
    /// # Ok::<(), sweep_cdt::Error>(())
    /// ```
    pub fn par_triangles(&self) -> impl IndexedParallelIterator<Item = [usize; 3]> + Clone + '_ {
        self.triangles
            .par_iter()
            .map(|triangle| self.corners(triangle))
    }

    /// [`constrained_sides`](Triangulation::constrained_sides), on all threads of the current rayon pool.
    pub fn par_constrained_sides(&self) -> impl ParallelIterator<Item = [usize; 2]> + Clone + '_ {
        let numbers = (0..self.len()).into_par_iter();
        numbers.flat_map_iter(|t| self.constrained_sides_of(t))
    }
}

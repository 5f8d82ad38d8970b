//! Divide and conquer: the Delaunay triangulation of the points in O(n log n) whatever they are (Lee and Schachter
//! 1980; Guibas and Stolfi 1985), and then the edges one by one (Anglada 1997). The paper compares its sweep with both
//! (section 4). Here they are the net under the sweep, and an oracle of its results.
//!
//! The vertices in sweep order are cut into leaves of two or three. Neighbouring sub-triangulations are merged
//! ([`merge`]) until one is left. Mesh, predicates and rules are those of the sweep, so the result is the same. Outside
//! the hull of a sub-triangulation lie *ghosts* ([`ghosts`]). In the end the artificial triangles and the front take
//! their place ([`hand_over`]): then the state is that of a sweep whose hull is complete. The code of the edge event
//! inserts the edges in sweep order, so that of several crossings the same one is found. Cost of the edges: see
//! [`super::edge_event`] and [`super::waiting_edges`].
//!
//! Differs from Guibas and Stolfi: triangles with ghosts in place of a quad-edge structure (after Shewchuk 1996); a
//! loop with a stack in place of the recursion; ties follow the canonical rule; halves are divided by y.

#[cfg(any(feature = "comparison", feature = "parallel"))]
mod enclose;
mod ghosts;
mod hand_over;
mod merge;

use super::Sweep;
use super::delaunay::Delaunay;
use super::flip_limit::FlipLimit;
use super::waiting_edges::WaitingEdges;
use crate::error::Error;
use crate::ids::VertexId;
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use crate::observe::recorder::Phase;
use alloc::vec::Vec;

/// A sub-triangulation: vertices that follow each other in sweep order, with ghosts around them.
#[derive(Clone, Copy, Debug)]
pub(super) struct SubTriangulation {
    /// The ghost of the hull side that starts at the first vertex in sweep order.
    pub(super) first: HalfEdge,
    /// The ghost of the hull side that starts at the last vertex.
    pub(super) last: HalfEdge,
}

impl SubTriangulation {
    /// The sub-triangulation after the numbers of all triangles have grown by `triangles`.
    #[cfg(feature = "parallel")]
    pub(super) fn moved(self, triangles: u32) -> SubTriangulation {
        SubTriangulation {
            first: self.first.moved(triangles),
            last: self.last.moved(triangles),
        }
    }
}

/// How the gap between two sub-triangulations is closed ([`merge`]).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum MergeMode {
    /// Sides that must go are removed. No side may be constrained.
    Delete,
    /// All sides stay, and those that may be illegal now go on the flip stack.
    Stitch,
}

impl<P: Probe> Sweep<'_, P> {
    /// Triangulates without sweeping, and inserts each edge down to the first vertex on it; afterwards the hull is
    /// complete. What a sweep has made is forgotten.
    pub(super) fn divide_and_conquer(&mut self) -> Result<(), Error> {
        self.divide_and_conquer_points();
        self.insert_all()
    }

    /// Triangulates the points without sweeping, in the same way.
    pub(super) fn divide_and_conquer_points(&mut self) {
        self.delaunay.probe.begin(Phase::Sweeping);
        let n = self.delaunay.predicates.vertices.len();
        self.delaunay.probe.record(|r| r.stats.is_divided = true);
        self.delaunay.flip_limit = FlipLimit::new(n, None);
        self.chains.clear();
        self.waiting = WaitingEdges::new(&self.delaunay);
        self.lists.vertex_triangles.clear();
        self.front.begin(n);
        self.delaunay.mesh.clear();
        self.delaunay.mesh.reset_borders(n + 2);
        if n == 1 {
            self.first_triangle();
        } else {
            let whole = self.delaunay.triangulate();
            self.hand_over(whole.first);
        }
    }

    /// Inserts all edges in sweep order, each down to the first vertex on it; the hull is complete.
    pub(in crate::sweep) fn insert_all(&mut self) -> Result<(), Error> {
        if self.lists.edges.is_empty() {
            return Ok(());
        }
        let n = self.delaunay.predicates.vertices.len();
        let mut list = Vec::new();
        for v in (0..n).map(VertexId::at) {
            if !self.lists.edges.at(v).is_empty() {
                list.clear();
                list.extend_from_slice(self.lists.edges.at(v));
                let around = self.side_opposite(v);
                self.insert_edges(v, &mut list, around)?;
            }
        }
        Ok(())
    }
}

impl<P: Probe> Delaunay<'_, P> {
    /// Triangulates all vertices, at least two.
    fn triangulate(&mut self) -> SubTriangulation {
        let n = self.predicates.vertices.len();
        let mut parts: Vec<(u32, SubTriangulation)> = Vec::new();
        for leaf in 0..n / 2 {
            let from = 2 * leaf;
            // The last leaf has three vertices if their number is odd.
            let to = if from + 3 == n { n } else { from + 2 };
            let mut part = self.leaf(from, to);
            // Merge sub-triangulations of equal height, as in the addition of binary numbers.
            let mut height = 0;
            while let Some(&(other, before)) = parts.last()
                && other == height
            {
                parts.pop();
                part = self.merge(before, part, MergeMode::Delete);
                height += 1;
            }
            parts.push((height, part));
        }
        let mut whole = parts.pop().expect("there is a leaf").1;
        while let Some((_, before)) = parts.pop() {
            whole = self.merge(before, whole, MergeMode::Delete);
        }
        whole
    }
}

//! Divide and conquer: the Delaunay triangulation of the points in O(n log n) whatever they are (Lee and Schachter
//! 1980; Guibas and Stolfi 1985), and then the edges one by one (Anglada 1997). The paper compares its sweep with both
//! (section 4). Here they are the net under the sweep, and an oracle of its results.
//!
//! The vertices in sweep order are cut into leaves of two or three. Neighbouring sub-triangulations are merged
//! ([`merge`]) until one is left. Mesh, predicates and rules are those of the sweep, so the result is the same. Outside
//! the hull of a sub-triangulation lie *ghosts* ([`ghosts`]). In the end the artificial triangles and the front take
//! their place ([`hand_over`]): then the state is that of a sweep whose hull is complete. The code of the edge event
//! inserts the edges in sweep order, so that of several crossings the same one is found. Cost of the edges: see
//! [`super::edge_event`] and [`super::pending_edges`].
//!
//! A sweep that is abandoned leaves its lower vertices triangulated. If there are no edges, ghosts enclose them as a
//! sub-triangulation ([`enclose`]). With edges all begins anew: no constrained side may go.
//!
//! Differs from Guibas and Stolfi: triangles with ghosts in place of a quad-edge structure (after Shewchuk 1996); a
//! loop with a stack in place of the recursion; ties follow the canonical rule; halves are divided by y.

mod enclose;
mod ghosts;
mod hand_over;
mod merge;

use super::Sweep;
use super::deferred_edges::DeferredEdges;
use super::delaunay::Delaunay;
use super::flip_limit::FlipLimit;
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
    /// complete. The first `swept` vertices keep their triangles, whose hull is complete. If there are any, two other
    /// vertices or more follow, and there are no edges.
    pub(super) fn divide_and_conquer(&mut self, swept: usize) -> Result<(), Error> {
        self.divide_and_conquer_points(swept);
        self.insert_all()
    }

    /// Triangulates the points without sweeping, in the same way.
    pub(super) fn divide_and_conquer_points(&mut self, swept: usize) {
        self.delaunay.probe.begin(Phase::Sweeping);
        let n = self.delaunay.predicates.vertices.len();
        self.delaunay.probe.record(|r| r.stats.is_divided = true);
        self.delaunay.flip_limit = FlipLimit::new(n, false);
        self.chains.clear();
        self.pending.clear();
        self.deferred = DeferredEdges::new(&self.delaunay);
        self.vertex_triangles.clear();
        let lower =
            (swept > 0).then(|| self.enclose(swept, self.delaunay.predicates.artificial.left));
        self.front.begin(n);
        if lower.is_none() {
            self.delaunay.mesh.clear();
        }
        self.delaunay.mesh.reset_borders(n + 2);
        if n == 1 {
            self.first_triangle();
        } else {
            let mut whole = self.delaunay.triangulate(swept);
            if let Some(lower) = lower {
                whole = self.delaunay.merge(lower, whole, MergeMode::Delete);
            }
            self.hand_over(whole.first);
        }
    }

    /// Inserts all edges in sweep order, each down to the first vertex on it; the hull is complete.
    pub(in crate::sweep) fn insert_all(&mut self) -> Result<(), Error> {
        if self.edges.is_empty() {
            return Ok(());
        }
        let n = self.delaunay.predicates.vertices.len();
        let mut list = Vec::new();
        for v in (0..n).map(VertexId::at) {
            if !self.edges.at(v).is_empty() {
                list.clear();
                list.extend_from_slice(self.edges.at(v));
                let around = self.side_opposite(v);
                self.insert_edges(v, &mut list, around)?;
            }
        }
        Ok(())
    }
}

impl<P: Probe> Delaunay<'_, P> {
    /// Triangulates all vertices from rank `first` on, of which there are at least two.
    fn triangulate(&mut self, first: usize) -> SubTriangulation {
        let n = self.predicates.vertices.len();
        let mut parts: Vec<(u32, SubTriangulation)> = Vec::new();
        for leaf in 0..(n - first) / 2 {
            let from = first + 2 * leaf;
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

#[cfg(test)]
mod tests {
    use super::super::initialization::{begin, initialize};
    use super::super::scratch::Scratch;
    use crate::front::{HashTable, Search};
    use crate::ids::VertexId;
    use crate::settings::{Algorithm, Heuristics, Settings, Ties};
    use crate::triangulation::Triangulation;
    use crate::verify::verify;

    const SETTINGS: Settings<'_> = Settings {
        algorithm: Algorithm::Sweep,
        heuristics: Heuristics::FAST,
        progress: None,
        ties: Ties::Leftmost,
    };

    /// The triangulation after a sweep that is abandoned after `swept` vertices.
    fn after(swept: usize, points: &[[f64; 2]]) -> Triangulation {
        let mut scratch = Scratch::default();
        let mut front = HashTable::default();
        let front = Search::with(&mut front);
        let chains = initialize(points, &[], &mut scratch).expect("valid points");
        let Scratch { held, mut lent, .. } = scratch;
        let mut sweep = begin(&points, chains, SETTINGS, front, (), held, &mut lent);
        for v in (1..swept).map(VertexId::at) {
            sweep.point_event(v);
        }
        if swept > 0 {
            sweep.complete_hull();
        }
        sweep.divide_and_conquer(swept).expect("no edges");
        sweep.finalize()
    }

    fn check(points: &[[f64; 2]]) {
        let whole = after(0, points);
        for swept in 2..=points.len() - 2 {
            let result = after(swept, points);
            let triangles = result.canonical_triangles();
            assert_eq!(triangles, whole.canonical_triangles(), "{swept} swept");
            assert!(
                result.hull().eq(whole.hull()),
                "another hull, {swept} swept"
            );
            let report = verify(points, &[], &triangles).expect("a triangulation");
            assert!(report.is_canonical(), "{swept} swept");
        }
    }

    #[test]
    fn goes_on_after_any_vertex() {
        let lattice = |i: u32| [i % 5, i / 5].map(f64::from);
        let inputs: [&dyn Fn(u32) -> [f64; 2]; 6] = [
            &lattice,
            &|i| [f64::from(i), 0.0],
            &|i| [0.0, f64::from(i)],
            &|i| [f64::from(i), f64::from(2 * i)],
            &|i| [f64::from(i * i % 23), f64::from(i * 7 % 25)],
            // A row, and a point above it.
            &|i| [f64::from(i), f64::from(i / 24)],
        ];
        for input in inputs {
            let points: Vec<_> = (0..25).map(input).collect();
            check(&points);
        }
    }
}

//! The inside of a polygon, where that alone is asked for: what is outside is neither filled nor legalized.
//!
//! The method is the sweep of Hertel and Mehlhorn (1983) in the order of section 3.3, for edges that are [`rings`]. The sweep
//! line crosses an even number of edges. Between them are *intervals*, outside and inside by turns ([`status`]), and
//! each interval inside has a *chain* of vertices, above which nothing is triangulated yet ([`chains`]):
//!
//! | edges of `v` above it | where | what happens |
//! |---|---|---|
//! | two | outside | an interval begins, with a chain of one vertex |
//! | two | inside | a diagonal to the vertex of the chain that was swept last cuts interval and chain in two |
//! | one | | `v` is a new end of its chain |
//! | none | around an interval inside | the chain ends: `v` closes all of it |
//! | none | around an interval outside | two intervals and their chains become one |
//!
//! Then corners of the chain beside `v` are closed while they turn left, and the fan of these triangles around `v` is
//! legalized, as after a point event.
//!
//! Why it is right: no edges cross or touch where each vertex lies strictly between the edges on its left and right; the
//! triangles are inside, and are those of the whole triangulation ([proof](../../../docs/proofs/polygon.md)).
//!
//! Cost: O(n) after the sort, but for the flips and for the walks along the status, which are few on ordinary polygons.
//! Each has a budget that is linear in n; when it is spent, the sweep of all points begins anew.
//!
//! Differs from the paper, which fills the hull.

mod chains;
mod rings;
mod status;

use alloc::vec::Vec;
use core::cmp::Ordering::{Equal, Greater};
use core::mem::take;

use super::delaunay::Delaunay;
use super::initialization::LIMIT;
use super::predicates::SweepPredicates;
use super::state::Scratch;
use super::vertices::ApproxPoints;
use crate::ids::{TriangleId, VertexId, narrow};
use crate::scalar::{ExactPoints, Scalar};
use crate::settings::Settings;
use crate::triangulation::canonical::{CanonicalBuffers, canonical_into};
use crate::tuning::Tuning;
use chains::Chains;
use rings::Rings;
use status::{Crossed, END, Status};

/// Flips for each vertex before the sweep is given up.
const FLIPS: u64 = 16;

/// The memory that one polygon leaves for the next, beside the [`Scratch`] of all sweeps.
#[derive(Debug, Default)]
pub(crate) struct PolygonScratch {
    rings: Rings,
    status: Status,
    chains: Chains,
    canonical: CanonicalBuffers,
    /// The triangles inside, in canonical order.
    pub(crate) triangles: Vec<[usize; 3]>,
}

/// Lists the triangles inside, if the edges are rings that neither touch nor cross, and if, where they are `directed`, a
/// ring in another one runs the other way. Otherwise returns `false`: the sweep of all points has to find them.
pub(crate) fn triangulate_rings<S: Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    directed: bool,
    scratch: &mut Scratch,
    polygon: &mut PolygonScratch,
) -> bool {
    if points.len() > LIMIT || !polygon.rings.set(points.len(), edges, directed) {
        return false;
    }
    let Ok(approx) = ApproxPoints::new(points) else {
        return false;
    };
    let inputs = 0..narrow(points.len());
    scratch
        .arrays
        .vertices
        .set(&approx, inputs, &mut scratch.sort, &Tuning::REAL);
    drop(approx);
    scratch.arrays.vertices.duplicates.is_empty() && sweep(&points, directed, scratch, polygon)
}

/// Sweeps the vertices in `scratch`, of which none are duplicates. Compiled once, whatever the scalar.
#[inline(never)]
fn sweep(
    points: &dyn ExactPoints,
    directed: bool,
    Scratch {
        arrays, buffers, ..
    }: &mut Scratch,
    polygon: &mut PolygonScratch,
) -> bool {
    let (vertices, mut mesh) = (take(&mut arrays.vertices), take(&mut arrays.mesh));
    let n = vertices.len();
    polygon.rings.rank(&vertices);
    polygon.status.begin(n);
    polygon.chains.clear();
    mesh.begin(n, 0);
    let predicates = SweepPredicates::new(points, vertices);
    let mut sweep = PolygonSweep {
        delaunay: Delaunay::new(mesh, predicates, Settings::default(), (), buffers),
        rings: &polygon.rings,
        status: &mut polygon.status,
        chains: &mut polygon.chains,
        directed,
    };
    sweep.delaunay.flip_limit.grant(FLIPS * n as u64);
    let is_done = (0..n).all(|v| sweep.event(VertexId::at(v)).is_some());
    let delaunay = sweep.delaunay;
    if is_done {
        let triangle = |t| delaunay.mesh.get(TriangleId::at(t)).vertices();
        let inputs = |t| triangle(t).map(|v| delaunay.predicates.vertices.input_index(v));
        let (list, buffers) = (&mut polygon.triangles, &mut polygon.canonical);
        canonical_into(list, delaunay.mesh.len(), inputs, buffers);
    }
    (arrays.vertices, arrays.mesh) = (delaunay.predicates.vertices, delaunay.mesh);
    is_done
}

/// The state between two vertices.
struct PolygonSweep<'a> {
    delaunay: Delaunay<'a, ()>,
    rings: &'a Rings,
    status: &'a mut Status,
    chains: &'a mut Chains,
    directed: bool,
}

impl PolygonSweep<'_> {
    /// Sweeps a vertex; `None` if the sweep is given up.
    #[inline(always)]
    fn event(&mut self, v: VertexId) -> Option<()> {
        let approx = self.delaunay.predicates.approx(v);
        let neighbors = self.rings.neighbors(v);
        match self.status.ending(v) {
            [END, _] => self.two_edges_begin(v, approx, neighbors)?,
            [edge, END] => self.edge_leads_on(v, approx, edge, neighbors)?,
            pair => self.two_edges_end(v, approx, pair)?,
        }
        (!self.delaunay.flip_limit.is_spent()).then_some(())
    }

    #[inline(always)]
    fn edge_leads_on(
        &mut self,
        v: VertexId,
        approx: [f64; 2],
        edge: Crossed,
        [before, behind]: [VertexId; 2],
    ) -> Option<()> {
        let (status, delaunay) = (&mut *self.status, &mut self.delaunay);
        let beside = status.edge(edge).beside;
        if !status.is_between(beside, v, approx, delaunay) {
            return None;
        }
        status.lead_on(edge, [v, before.max(behind)]);
        if status.edge(edge).is_left_of_inside {
            let chain = &mut status.edge_mut(edge).chain;
            self.chains.extend::<0>(chain, v, approx, delaunay);
        } else {
            let chain = &mut status.edge_mut(beside[0]).chain;
            self.chains.extend::<1>(chain, v, approx, delaunay);
        }
        Some(())
    }

    fn two_edges_begin(
        &mut self,
        v: VertexId,
        approx: [f64; 2],
        [before, behind]: [VertexId; 2],
    ) -> Option<()> {
        let (status, delaunay) = (&mut *self.status, &mut self.delaunay);
        // The left one of the two, and whether it runs upwards.
        let (left, right, runs_up) = match delaunay.orient2d([v, before, behind]) {
            Equal => return None,
            Greater => (behind, before, true),
            _ => (before, behind, false),
        };
        let beside = status.find(v, approx, delaunay)?;
        let interval = *status.edge(beside);
        if interval.is_left_of_inside && self.directed && interval.runs_up == runs_up {
            return None;
        }
        let left = status.insert(beside, [v, left], runs_up);
        let right = status.insert(left, [v, right], !runs_up);
        if interval.is_left_of_inside {
            let [a, b] = self.chains.split(interval.chain, v, approx, delaunay);
            status.edge_mut(beside).chain = a;
            status.edge_mut(right).chain = b;
        } else {
            status.edge_mut(left).chain = self.chains.begin(v, &mut delaunay.mesh);
        }
        Some(())
    }

    fn two_edges_end(&mut self, v: VertexId, approx: [f64; 2], pair: [Crossed; 2]) -> Option<()> {
        let (status, delaunay) = (&mut *self.status, &mut self.delaunay);
        let [a, b] = pair.map(|edge| status.edge(edge).beside[1]);
        let [left, right] = if a == pair[1] {
            pair
        } else if b == pair[0] {
            [pair[1], pair[0]]
        } else {
            return None;
        };
        let outer = status.edge(left).beside[0];
        let beside = [outer, status.edge(right).beside[1]];
        if !status.is_between(beside, v, approx, delaunay) {
            return None;
        }
        status.remove([left, right]);
        if status.edge(left).is_left_of_inside {
            let mut chain = status.edge(left).chain;
            self.chains.extend::<0>(&mut chain, v, approx, delaunay);
            return self.chains.is_single_side(&chain).then_some(());
        }
        let chains = [outer, right].map(|edge| status.edge(edge).chain);
        let merged = self.chains.merge(chains, v, approx, delaunay);
        status.edge_mut(outer).chain = merged;
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::{PolygonScratch, triangulate_rings};
    use crate::sweep::Scratch;

    /// How many triangles the rings with these corners have; `None` if the sweep gives them up.
    fn count(rings: &[&[[i64; 2]]], directed: bool) -> Option<usize> {
        let mut edges = Vec::new();
        for ring in rings {
            let first = edges.len();
            edges.extend((0..ring.len()).map(|i| [first + i, first + (i + 1) % ring.len()]));
        }
        let (mut scratch, mut polygon) = (Scratch::kept(), PolygonScratch::default());
        let is_done = triangulate_rings(
            &rings.concat(),
            &edges,
            directed,
            &mut scratch,
            &mut polygon,
        );
        is_done.then_some(polygon.triangles.len())
    }

    const OUTER: &[[i64; 2]] = &[[0, 0], [9, 0], [9, 9], [0, 9]];
    const INNER: &[[i64; 2]] = &[[3, 3], [6, 3], [6, 6], [3, 6]];
    const REVERSED: &[[i64; 2]] = &[[3, 6], [6, 6], [6, 3], [3, 3]];

    #[test]
    fn rings_that_neither_touch_nor_cross_are_done() {
        assert_eq!(count(&[], false), Some(0));
        assert_eq!(count(&[OUTER], true), Some(2));
        assert_eq!(count(&[OUTER, INNER], false), Some(8));
        assert_eq!(count(&[OUTER, REVERSED], true), Some(8));
        // Corners that are none, and three teeth up and down.
        assert_eq!(
            count(
                &[&[[0, 0], [1, 0], [2, 0], [2, 2], [1, 2], [0, 2], [0, 1]]],
                false
            ),
            Some(5)
        );
        let teeth = [
            [0, 0],
            [1, 5],
            [2, 1],
            [3, 6],
            [4, 1],
            [5, 5],
            [6, 0],
            [4, -5],
            [3, -1],
            [2, -5],
        ];
        assert_eq!(count(&[&teeth], true), Some(8));
    }

    #[test]
    fn all_others_are_given_up() {
        let given_up: [(&str, &[&[[i64; 2]]]); 9] = [
            ("edges cross", &[&[[0, 0], [2, 2], [2, 0], [0, 2]]]),
            (
                "they cross twice",
                &[&[[0, 0], [4, 0], [4, 9], [0, 9]], &[[3, 4], [7, 3], [7, 5]]],
            ),
            ("a vertex on an edge", &[OUTER, &[[9, 4], [8, 5], [8, 3]]]),
            ("the same from below", &[OUTER, &[[4, 0], [5, 2], [3, 2]]]),
            ("a repeated point", &[OUTER, &[[0, 0], [1, 2], [2, 1]]]),
            ("an edge twice", &[&[[0, 0], [1, 1]]]),
            ("edges that overlap", &[&[[0, 0], [0, 4], [0, 2], [3, 1]]]),
            ("an edge of no length", &[OUTER, &[[4, 4]]]),
            ("a line", &[&[[0, 0], [2, 0], [1, 0]]]),
        ];
        for (what, rings) in given_up {
            assert_eq!(count(rings, false), None, "{what}");
        }
        assert_eq!(
            count(&[OUTER, INNER], true),
            None,
            "the hole is wound twice"
        );
    }

    /// Triangles side by side, which begin in an order that jumps between them.
    #[test]
    fn long_walks_are_given_up() {
        let side_by_side = |n: i64, step: i64| {
            let triangle = |i| {
                [
                    [3 * i, i * step % n],
                    [3 * i + 1, n + i],
                    [3 * i - 1, n + i],
                ]
            };
            let triangles: Vec<[[i64; 2]; 3]> = (0..n).map(triangle).collect();
            let rings: Vec<&[[i64; 2]]> = triangles.iter().map(|triangle| &triangle[..]).collect();
            count(&rings, true)
        };
        assert_eq!(side_by_side(50, 19), Some(50));
        assert_eq!(side_by_side(500, 199), None);
    }
}

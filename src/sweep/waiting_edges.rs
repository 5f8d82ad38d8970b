//! Waiting edges, which are inserted when the hull is complete: *rests* behind a vertex, and edges that pierce many
//! triangles.
//!
//! An edge event (section 3.4.2) inserts an edge down to the first vertex on it. The rest begins at this vertex. All
//! rests that begin at one vertex are inserted together, sorted by angle, so that one turn around the vertex finds them.
//! The last vertex in sweep order comes first, because a rest may leave another one, further down.
//!
//! Edge events insert edges in the order of their upper ends, which can be as bad as any: each of n slanted lines side by
//! side (a hatch) can pierce the whole fan that the line before has left behind. So an edge may pierce a few triangles,
//! and all edges together a few more for each vertex ([`crate::Tuning`]). An edge that comes to its limit is *deferred*:
//! its pockets are filled, and nothing is removed. Deferred edges are inserted in random order, part by part from both
//! ends.
//!
//! Why it is right: there is only one triangulation (the canonical rule), in whichever order the parts come. Where edges
//! cross, the pair that the paper's order meets first is named ([`super::first_crossing`]). With
//! [`Algorithm::Paper`](crate::Algorithm::Paper) no edge is deferred.
//!
//! Cost: O(d + k log k) for k rests at a vertex with d triangles. All k deferred edges pierce O(n log^2 k) triangles,
//! expected, whatever they are (figures and proof: docs/proofs/waiting-edges.md). The random numbers are fixed, so one who
//! knows them can make an input that is slow. Differs from the paper: it inserts each edge whole, at its upper end.

use alloc::collections::BinaryHeap;
use alloc::vec::Vec;
use core::mem::take;

use super::Sweep;
use super::contradiction::inexact_scalar;
use super::delaunay::Delaunay;
use super::traversal::{CrossedSide, Traversal};
use crate::error::Error;
use crate::ids::VertexId;
use crate::observe::probe::Probe;
use crate::random::Random;

/// A deferred edge, or a rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct WaitingEdge {
    /// The upper end, or the vertex on the edge where the rest begins.
    pub(super) from: VertexId,
    pub(super) edge: u32,
    pub(super) lower: VertexId,
}

/// The edges that wait for the hull to be complete.
#[derive(Debug)]
pub(super) struct WaitingEdges {
    /// The rest that begins last in sweep order comes first.
    rests: BinaryHeap<WaitingEdge>,
    deferred: Vec<WaitingEdge>,
    any_deferred: bool,
    /// The triangles that each part may pierce.
    few: usize,
    /// The triangles that edges may still pierce beyond a few each.
    allowance: u64,
}

impl WaitingEdges {
    /// No edges yet; the vertices of these triangles give the allowance.
    pub(super) fn new<P: Probe>(delaunay: &Delaunay<'_, P>) -> WaitingEdges {
        let vertices = delaunay.predicates.vertices.len() as u64;
        WaitingEdges {
            rests: BinaryHeap::new(),
            deferred: Vec::new(),
            any_deferred: false,
            few: delaunay.tuning.pierced_by_part,
            allowance: if delaunay.is_paper {
                u64::MAX
            } else {
                delaunay.tuning.pierced_for_vertex * vertices
            },
        }
    }

    pub(super) fn push_rest(&mut self, rest: WaitingEdge) {
        self.rests.push(rest);
    }

    pub(super) fn defer(&mut self, edge: WaitingEdge) {
        self.deferred.push(edge);
        self.any_deferred = true;
    }

    /// Whether any edge has been deferred since the points were triangulated.
    pub(super) fn any_deferred(&self) -> bool {
        self.any_deferred
    }

    /// How many of all `triangles` the next part may pierce.
    #[inline(always)]
    pub(super) fn most(&self, triangles: usize) -> usize {
        let allowed = usize::try_from(self.allowance).unwrap_or(usize::MAX);
        triangles.min(allowed.saturating_add(self.few))
    }

    /// Takes triangles that a part has pierced from the allowance.
    #[inline(always)]
    pub(super) fn spend(&mut self, pierced: usize) {
        let beyond = pierced.saturating_sub(self.few) as u64;
        self.allowance = self.allowance.saturating_sub(beyond);
    }

    /// From now on edges may pierce as many triangles as there are.
    pub(super) fn allow_all(&mut self) {
        self.allowance = u64::MAX;
    }
}

impl<P: Probe> Sweep<'_, P> {
    /// Inserts all waiting edges; the hull is complete.
    pub(super) fn insert_waiting(&mut self) -> Result<(), Error> {
        let mut list = Vec::new();
        while let Some(&WaitingEdge { from, .. }) = self.waiting.rests.peek() {
            list.clear();
            while let Some(rest) = self.waiting.rests.peek().copied()
                && rest.from == from
            {
                list.push((rest.lower, rest.edge));
                self.waiting.rests.pop();
            }
            list.reverse();
            let around = self.side_opposite(from);
            self.insert_edges(from, &mut list, around)?;
        }

        let mut deferred = take(&mut self.waiting.deferred);
        self.waiting.allow_all();
        Random::new().shuffle(&mut deferred);
        let mut passed = Vec::new();
        for edge in deferred {
            self.insert_from_both_ends(edge, &mut passed)?;
        }
        Ok(())
    }

    /// Inserts all parts of an edge from both of its ends. `passed` is a buffer.
    fn insert_from_both_ends(
        &mut self,
        WaitingEdge { from, lower, edge }: WaitingEdge,
        passed: &mut Vec<VertexId>,
    ) -> Result<(), Error> {
        passed.clear();
        let mut open = [from, lower];
        while open[0] != open[1] {
            let ends = self.insert_at_one_end(open);
            let ends = ends.map_err(|crossed| self.crossing(edge, crossed))?;
            if ends[0] != ends[1] {
                if ends[0] != open[0] {
                    self.note_passed(edge, ends[0])?;
                } else {
                    passed.push(ends[1]);
                }
            }
            open = ends;
        }
        while let Some(v) = passed.pop() {
            self.note_passed(edge, v)?;
        }
        Ok(())
    }

    /// An edge is in but for its stretch between two vertices, `open`, the upper one first. Inserts the part at one end of
    /// the stretch, and returns the stretch that remains.
    pub(super) fn insert_at_one_end(
        &mut self,
        open: [VertexId; 2],
    ) -> Result<[VertexId; 2], CrossedSide> {
        let ([from, to], mut around) = self.nearer_departure(open);
        let Traversal::Part(part) = self.traverse(from, to, &mut around)? else {
            inexact_scalar();
        };
        self.insert_part(from, part);
        let is_upper = from == open[0];
        let [upper, lower] = if is_upper {
            [part.end, to]
        } else {
            [to, part.end]
        };
        if upper < lower {
            inexact_scalar();
        }
        Ok([upper, lower])
    }

    /// Inserts an edge down to the first vertex on it, which is returned; the hull is complete, and nothing is deferred.
    pub(super) fn insert_first_part(
        &mut self,
        upper: VertexId,
        lower: VertexId,
    ) -> Result<VertexId, CrossedSide> {
        let ([from, to], mut around) = self.nearer_departure([upper, lower]);
        if from == lower {
            // What is met from below says nothing about the first part, unless that is all of the edge.
            if let Ok(Traversal::Part(part)) = self.traverse(from, to, &mut around)
                && part.end == upper
            {
                self.insert_part(from, part);
                return Ok(lower);
            }
            around = self.side_opposite(upper);
        }
        let end = self.insert_edge(upper, lower, &mut around)?;
        Ok(end.unwrap_or_else(|| inexact_scalar()))
    }
}

//! Deferred edges: those that pierce many triangles are inserted when the hull is complete, in random order.
//!
//! The edge event (section 3.4.2) inserts edges in the order of their upper ends. That order can be as bad as any: each
//! of n slanted lines side by side (a hatch) can pierce the whole fan that the line before has left behind, n^2
//! triangles together.
//!
//! ```text
//!      \   \   \   \          Each line leaves the triangles on its right to the next one. These lead from
//!       \   \   \   \         its lower end to the upper ends of many lines, so the next line pierces
//!        \   \   \   \        them all, and leaves as many again. In random order a line finds lines near
//!         \   \   \   \       it on both sides, between which there are only few triangles to pierce.
//! ```
//!
//! So an edge may pierce a few triangles, and all edges together a few more for each vertex ([`crate::Tuning`]). Ordinary edges
//! stay below. An edge that comes to its limit is put off: its pockets are filled, and nothing is removed.
//!
//! Why it is right: the triangulation is the only one (the canonical rule), so the order of the edges is free. Where
//! edges cross, the pair that the paper's order meets first is named ([`super::first_crossing`]). With
//! [`Algorithm::Paper`](crate::Algorithm::Paper) no edge is deferred.
//!
//! Cost. When i of k deferred edges are in, chosen at random, no side of the triangulation crosses more than
//! O((k / i) log k) of the others, with high probability: a segment that crosses more than that is crossed by one of the
//! i (an epsilon net of segments, Agarwal, Arge and Yi 2005; Shewchuk and Brown 2015). There are O(n) sides, so the next
//! edge, one of the k - i others at random, pierces O(n (k / i) log k / (k - i)) triangles, expected: O(n log^2 k)
//! for all of them, whatever the edges are. To find the first triangle, both ends of an edge are turned around
//! ([`Sweep::nearer_departure`]): O(n log k) expected for edges without vertices inside, because the smaller of the two
//! degrees, summed over the edges of a plane graph, is O(n) on any triangulation of its vertices. An edge with vertices
//! inside is inserted part by part from both ends; it can turn around a vertex inside it once more.
//!
//! The random numbers are fixed: *expected* speaks of the order drawn, not of the input, and one who knows the numbers can
//! make an input that is slow. Differs from the paper: the paper inserts each edge at its upper end.

use alloc::vec::Vec;
use core::mem::take;

use super::Sweep;
use super::delaunay::{Delaunay, Random};
use super::flip_limit::inexact_scalar;
use super::pending_edges::PendingEdge;
use super::traversal::CrossedSide;
use crate::error::Error;
use crate::ids::VertexId;
use crate::observe::probe::Probe;

/// The edges that wait for the hull to be complete because they pierce many triangles.
#[derive(Debug)]
pub(super) struct DeferredEdges {
    list: Vec<PendingEdge>,
    were_any: bool,
    /// The triangles that each part may pierce.
    few: usize,
    /// The triangles that edges may still pierce beyond a few each.
    allowance: u64,
}

impl DeferredEdges {
    /// No edges yet; the vertices of these triangles give the allowance.
    pub(super) fn new<P: Probe>(delaunay: &Delaunay<'_, P>) -> DeferredEdges {
        let vertices = delaunay.predicates.vertices.len() as u64;
        DeferredEdges {
            list: Vec::new(),
            were_any: false,
            few: delaunay.tuning.pierced_by_part,
            allowance: if delaunay.is_paper {
                u64::MAX
            } else {
                delaunay.tuning.pierced_for_vertex * vertices
            },
        }
    }

    pub(super) fn push(&mut self, edge: PendingEdge) {
        self.list.push(edge);
        self.were_any = true;
    }

    /// Whether any edge has been deferred since the points were triangulated.
    pub(super) fn were_any(&self) -> bool {
        self.were_any
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
    /// Inserts all deferred edges in random order; the hull is complete.
    pub(super) fn insert_deferred(&mut self) -> Result<(), Error> {
        let mut edges = take(&mut self.deferred.list);
        self.deferred.allow_all();
        Random::new().shuffle(&mut edges);
        let mut passed = Vec::new();
        for edge in edges {
            self.insert_from_both_ends(edge, &mut passed)?;
        }
        Ok(())
    }

    /// Inserts all parts of an edge from both of its ends. `passed` is a buffer.
    fn insert_from_both_ends(
        &mut self,
        PendingEdge { from, lower, edge }: PendingEdge,
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

    /// Inserts the part at one end of what is still open of an edge, upper end first. Returns what is open then.
    pub(super) fn insert_at_one_end(
        &mut self,
        open: [VertexId; 2],
    ) -> Result<[VertexId; 2], CrossedSide> {
        let ([from, to], mut around) = self.nearer_departure(open);
        let part = self.traverse(from, to, &mut around)?;
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
            if let Ok(part) = self.traverse(from, to, &mut around)
                && part.end == upper
            {
                self.insert_part(from, part);
                return Ok(lower);
            }
            around = self.side_opposite(upper);
        }
        self.insert_edge(upper, lower, &mut around)
    }
}

#[cfg(test)]
mod tests {
    use super::Random;
    use crate::settings::Algorithm;
    use crate::triangulator::Triangulator;
    use crate::tuning::Tuning;
    use crate::verify::verify;
    use crate::{Error, Triangulation};

    type Points = Vec<[f64; 2]>;

    /// Points on a lattice of few places, so that edges overlap and pass through vertices, and edges between them.
    fn on_few_places(random: &mut Random, size: usize) -> (Points, Vec<[usize; 2]>) {
        let points = 4 + random.below(if size > 35 { 200 } else { 30 });
        let place = |random: &mut Random| random.below(size) as f64;
        let list = (0..points)
            .map(|_| [place(random), place(random)])
            .collect();
        let edges = 1 + random.below(6);
        let ends = (0..edges).map(|_| [random.below(points), random.below(points)]);
        (list, ends.collect())
    }

    /// Many edges that cross nothing: then they hang in the pseudo-polygons of each other.
    fn without_crossings(random: &mut Random, size: usize) -> (Points, Vec<[usize; 2]>) {
        let (points, _) = on_few_places(random, size);
        let turn = |a: usize, b: usize, c: usize| {
            let [[ax, ay], [bx, by], [cx, cy]] = [a, b, c].map(|v| points[v]);
            // Exact: the coordinates are small whole numbers.
            let turn = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
            if turn > 0.0 {
                1
            } else if turn < 0.0 {
                -1
            } else {
                0
            }
        };
        let cross = |[a, b]: [usize; 2], [c, d]: [usize; 2]| {
            turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0
        };
        let mut edges: Vec<[usize; 2]> = Vec::new();
        for _ in 0..40 {
            let edge = [random.below(points.len()), random.below(points.len())];
            if !edges.iter().any(|&other| cross(edge, other)) {
                edges.push(edge);
            }
        }
        (points, edges)
    }

    fn assert_same(
        here: &Result<Triangulation, Error>,
        plain: &Result<Triangulation, Error>,
        input: &(Points, Vec<[usize; 2]>),
    ) {
        match (here, plain) {
            (Ok(here), Ok(plain)) => {
                assert_eq!(
                    here.canonical_triangles(),
                    plain.canonical_triangles(),
                    "{input:?}"
                );
                for edge in 0..input.1.len() {
                    assert!(
                        here.edge_chain(edge).eq(plain.edge_chain(edge)),
                        "{edge} of {input:?}"
                    );
                }
                let triangles = here.canonical_triangles();
                let report = verify(&input.0, &input.1, &triangles).expect("a triangulation");
                assert!(report.is_canonical(), "{input:?}");
            }
            (Err(here), Err(plain)) => assert_eq!(here, plain, "{input:?}"),
            _ => panic!("{here:?}, where the plain order gives {plain:?}: {input:?}"),
        }
    }

    #[test]
    fn deferred_edges_give_the_result_of_the_plain_order() {
        let random = &mut Random::new();
        let (mut valid, mut wrong) = (0, 0);
        for _ in 0..20_000 {
            let size = 3 + random.below(40);
            let input = if random.below(2) == 0 {
                on_few_places(random, size)
            } else {
                without_crossings(random, size)
            };
            let (points, edges) = &input;
            let plain = Triangulator::new().algorithm(Algorithm::Paper);
            let plain = plain.triangulate(points, edges);
            *(if plain.is_ok() {
                &mut valid
            } else {
                &mut wrong
            }) += 1;
            for algorithm in [Algorithm::Auto, Algorithm::DivideAndConquer] {
                let here = Triangulator::new()
                    .algorithm(algorithm)
                    .tuning(Tuning::SMALL)
                    .triangulate(points, edges);
                assert_same(&here, &plain, &input);
            }
        }
        assert!(
            valid > 3000 && wrong > 3000,
            "{valid} valid and {wrong} wrong"
        );
    }
}

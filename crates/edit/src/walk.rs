//! The way along an edge, from vertex to vertex: a side that lies on it, or the triangles that it pierces (figure 12).
//! Cost: the triangles at each vertex on the edge, and those that are pierced.
//!
//! A part that pierces one side alone takes its place at once, without a sweep, where the edge comes alone: four vertices with
//! an edge along one diagonal have one triangulation, so there is nothing to choose.

use sweep_cdt::scalar::{Scalar, orient2d};

use crate::mesh::{NONE, next, prev, side_of};
use crate::region::Piece;
use crate::triangulation::DynamicTriangulation;

/// The next part of an edge.
pub(crate) enum Step {
    /// A side with the vertex at one end, and the other end.
    Side(u32, u32),
    /// The edge leaves the triangle at the vertex through this side, from right to left.
    Pierces(u32),
}

impl<S: Scalar + Clone> DynamicTriangulation<S> {
    /// How an edge leaves vertex `v` on its way to vertex `end`.
    pub(crate) fn step(&self, v: u32, end: u32) -> Step {
        let [from, to] = [v, end].map(|v| self.points.place(v));
        let is_ahead = |w: u32| self.points.order(v, w) == self.points.order(v, end);
        for corner in self.mesh.star(v) {
            let [p, q] = self.mesh.ends(corner);
            let [to_p, to_q] = [p, q].map(|w| orient2d(from, to, self.points.place(w)));
            if to_p.is_eq() && is_ahead(p) {
                return Step::Side(prev(corner), p);
            } else if to_q.is_eq() && is_ahead(q) {
                return Step::Side(next(corner), q);
            } else if to_p.is_lt() && to_q.is_gt() {
                return Step::Pierces(corner);
            }
        }
        unreachable!("the hull is convex and holds the edge")
    }

    /// The sides along an edge that is in the triangulation.
    pub(crate) fn sides_along(&self, [mut v, end]: [u32; 2]) -> Vec<(u32, u32)> {
        let mut sides = Vec::new();
        while v != end {
            let Step::Side(side, w) = self.step(v, end) else {
                unreachable!("an edge is a chain of sides")
            };
            sides.push((side, w));
            v = w;
        }
        sides
    }

    /// Adds what a new edge pierces to the region; where that is another edge, the sweep names both. Returns its parts,
    /// with the sides of those that are sides. Of an edge that comes alone parts that pierce one side alone take its place.
    pub(crate) fn pierce(
        &mut self,
        [mut v, end]: [u32; 2],
        edge: usize,
        is_alone: bool,
    ) -> Vec<(Piece, Option<u32>)> {
        let mut pieces = Vec::new();
        while v != end {
            let (w, side) = match self.step(v, end) {
                Step::Side(side, w) => (w, Some(side)),
                Step::Pierces(side) if is_alone && self.is_only_side(side, end) => {
                    let apex = self.mesh.apex(self.mesh.twin(side));
                    (apex, Some(self.exchange(side)))
                }
                Step::Pierces(side) => (self.pierce_from(v, end, side), None),
            };
            let ends = [v, w];
            let covers = 1;
            let edge = Some(edge);
            pieces.push((Piece { ends, covers, edge }, side));
            v = w;
        }
        pieces
    }

    /// Whether an edge to vertex `end` that pierces this side from the corner opposite comes to a vertex next, and no edge
    /// covers the side.
    fn is_only_side(&self, side: u32, end: u32) -> bool {
        let opposite = self.mesh.apex(self.mesh.twin(side));
        let [a, b, c] = [self.mesh.apex(side), end, opposite].map(|v| self.points.place(v));
        self.mesh.covers(side) == 0 && (opposite == end || orient2d(a, b, c).is_eq())
    }

    /// Puts the side between the corners opposite a side in its place, and returns it.
    fn exchange(&mut self, side: u32) -> u32 {
        let across = self.mesh.twin(side);
        let [p, q] = self.mesh.ends(side);
        let [v, w] = [side, across].map(|side| self.mesh.apex(side));
        let border = [prev(side), next(across), prev(across), next(side)];
        let border = border.map(|side| [self.mesh.twin(side), self.mesh.covers(side)]);
        for side in [side, across] {
            self.mesh.kill(side / 3);
        }
        let [a, b] = [[v, p, w], [w, q, v]].map(|triangle| self.mesh.add(triangle));
        let sides = [side_of(a, 2), side_of(a, 0), side_of(b, 2), side_of(b, 0)];
        for (side, [across, covers]) in sides.into_iter().zip(border) {
            self.mesh.begin(side, across, covers);
            if across != NONE {
                self.mesh.set_twin(across, side);
            }
        }
        let [here, there] = [a, b].map(|t| side_of(t, 1));
        self.mesh.begin(here, there, 0);
        self.mesh.begin(there, here, 0);
        for (vertex, corner) in [(v, sides[1]), (p, here), (w, sides[0]), (q, there)] {
            self.mesh.set_at(vertex, corner);
        }
        self.last = a;
        self.swept.extend([a, b]);
        let edges = vec![[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]];
        self.sweeps.push((vec![v, p, w, q], edges));
        there
    }

    /// Follows an edge from vertex `v` through a side, to the next vertex on it.
    fn pierce_from(&mut self, v: u32, end: u32, mut side: u32) -> u32 {
        self.region.add(side / 3);
        loop {
            let across = self.mesh.twin(side);
            debug_assert!(across != NONE, "the hull holds the edge");
            self.region.add(across / 3);
            let apex = self.mesh.apex(across);
            let [a, b, c] = [v, end, apex].map(|v| self.points.place(v));
            side = match orient2d(a, b, c) {
                sign if sign.is_eq() => return apex,
                // The side across goes from left to right; the apex takes the place of the end on its own side.
                sign if sign.is_gt() => next(across),
                _ => prev(across),
            };
        }
    }

    /// The edge of the lowest number that covers a part.
    pub(crate) fn edge_over(&self, piece: Piece) -> usize {
        let covers = |ends: [u32; 2]| {
            let [a, b] = ends.map(|point| self.points.vertex(point as usize).expect("an end"));
            piece.ends.into_iter().all(|v| self.is_on([a, b], v))
        };
        let numbered = self.edges.iter().enumerate();
        let mut over = numbered.filter(|&(_, edge)| edge.is_some_and(covers));
        let found = piece.edge.or_else(|| Some(over.next()?.0));
        found.expect("an edge covers the part")
    }

    /// Whether a vertex lies on an edge, ends included.
    fn is_on(&self, [a, b]: [u32; 2], v: u32) -> bool {
        let between = || self.points.order(a, v) == self.points.order(v, b);
        let [p, q, r] = [a, b, v].map(|v| self.points.place(v));
        v == a || v == b || between() && orient2d(p, q, r).is_eq()
    }
}

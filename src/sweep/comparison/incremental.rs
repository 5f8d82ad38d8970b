//! Randomized incremental insertion, the paper's M-INC: jump and walk (Mücke, Saias and Zhu 1996), then Lawson's flips.
//!
//! The triangulation begins with the first two vertices in sweep order and the first one off their line. Ghosts
//! surround it ([`super::super::divide_and_conquer`]), so a vertex outside the hull is inserted like one within.
//!
//! ```text
//!    jump: of some triangles drawn at random,       insertion:      a                  a
//!    the one nearest to p is the start.                           / | \              / | \
//!    walk: across a side that has p strictly                     /  |  \     ->     /  p  \
//!    on its other side, until there is none,                    / p |   \          / /  \  \
//!    or until a ghost is reached.                              b----------c       b----------c
//! ```
//!
//! Why the walk ends: lifted to the paraboloid, and lowered where four points lie on one circle
//! ([`super::super::predicates`]), the triangulation is a convex surface. Crossing a side, the walk enters a triangle
//! whose plane lies higher above the new vertex than that of the triangle left. So none is visited twice.
//!
//! Why the insertion is right: the triangle found becomes three. All other sides were legal, so only those opposite the
//! new vertex can be illegal, and [`Delaunay::legalize_fan`] flips them. A vertex on a side makes a triangle without
//! area there. The vertex lies inside the circle beyond that side, so the side is flipped. On the hull the triangle
//! found is the ghost, and the triangle without area lies on the inner side. A ghost is flipped where its hull side has
//! the vertex strictly outside, by the rule for a side with an artificial end.
//!
//! Cost: expected O(n^(4/3)) for n points spread evenly: O(n^(1/3)) draws and steps for each, and a constant number of
//! flips for any points; at worst O(n) steps each. Differs from the three: triangles are drawn in place of vertices.

use alloc::vec::Vec;
use core::cmp::Ordering::{Equal, Less};

use super::super::Sweep;
use super::super::contradiction::inexact_scalar;
use super::super::delaunay::Delaunay;
use crate::error::Error;
use crate::ids::{TriangleId, VertexId};
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use crate::random::Random;
use crate::trace::Why;

impl<P: Probe> Sweep<'_, P> {
    /// Inserts points, then edges, and completes the hull. Returns false if all vertices lie on one line.
    pub(in crate::sweep) fn insert_at_random(&mut self) -> Result<bool, Error> {
        let n = self.delaunay.predicates.vertices.len();
        let Some(off_line) = self.begin_off_line() else {
            return Ok(false);
        };
        self.clear();
        self.delaunay.triangle_of_first(off_line);
        let random = &mut Random::new();
        let mut order: Vec<VertexId> = (2..n)
            .map(VertexId::at)
            .filter(|&v| v != off_line)
            .collect();
        random.shuffle(&mut order);
        let mut draws = 1;
        for (inserted, &p) in (3..).zip(&order) {
            while (draws + 1_usize).pow(3) <= inserted {
                draws += 1;
            }
            let start = self.delaunay.nearest_of(draws, p, random);
            let found = self.delaunay.walk(start, p);
            self.delaunay.insert(p, found);
        }
        let start = self.delaunay.lowest_ghost();
        self.finish_from_ghosts(start)
    }
}

impl<P: Probe> Delaunay<'_, P> {
    /// Makes the triangle of the first two vertices and the first one off their line, with ghosts around it.
    fn triangle_of_first(&mut self, off_line: VertexId) {
        let [a, b] = [0, 1].map(VertexId::at);
        let corners = if self.orient2d([a, b, off_line]) == Less {
            [a, off_line, b]
        } else {
            [a, b, off_line]
        };
        self.triangle(corners);
    }

    /// Of `draws` triangles drawn at random, the one whose first vertex is nearest to `p`, in plain floating point.
    fn nearest_of(&self, draws: usize, p: VertexId, random: &mut Random) -> TriangleId {
        let [px, py] = self.predicates.approx(p);
        let mut nearest = (f64::INFINITY, TriangleId::new(0));
        for _ in 0..draws {
            let t = TriangleId::at(random.below(self.mesh.len()));
            let [x, y] = self.predicates.approx(self.mesh.get(t).vertex(0));
            // NaN for the vertex of the ghosts.
            let square = (x - px) * (x - px) + (y - py) * (y - py);
            if square < nearest.0 {
                nearest = (square, t);
            }
        }
        nearest.1
    }

    /// The triangle with `p` in it or on its border, or the ghost of a hull side with `p` on it or strictly outside.
    fn walk(&mut self, start: TriangleId, p: VertexId) -> TriangleId {
        // The side crossed last, as a side of the triangle entered. At first there is none.
        let inner = self.hull_side(start).map(|side| self.mesh.twin(side));
        let mut entered = inner.unwrap_or(HalfEdge::new(start, 0));
        let mut tested = 0;
        // No triangle is visited twice.
        for steps in 0..=self.mesh.len() {
            let mut on = None;
            let mut crossed = None;
            if !self.predicates.is_artificial(self.mesh.opposite(entered)) {
                let sides = [entered, entered.next(), entered.prev()];
                crossed = sides.into_iter().skip(tested).find(|&side| {
                    let [_, a, b] = self.mesh.around(side);
                    let turn = self.orient2d([a, b, p]);
                    if turn == Equal {
                        on = Some(side);
                    }
                    turn == Less
                });
            }
            let Some(crossed) = crossed else {
                self.probe.count(|c| c.front_steps += steps as u64);
                return on.map_or(entered, |side| self.mesh.twin(side)).triangle();
            };
            (entered, tested) = (self.mesh.twin(crossed), 1);
        }
        inexact_scalar()
    }

    /// The hull side of a ghost; `None` for any other triangle.
    fn hull_side(&self, t: TriangleId) -> Option<HalfEdge> {
        let mut sides = [0, 1, 2].map(|i| HalfEdge::new(t, i)).into_iter();
        sides.find(|&side| self.predicates.is_artificial(self.mesh.opposite(side)))
    }

    /// Splits triangle `t` at `p` into three, and legalizes them.
    fn insert(&mut self, p: VertexId, t: TriangleId) {
        let [a, b, c] = self.mesh.get(t).vertices();
        let [_, ca, ab] = [0, 1, 2].map(|i| HalfEdge::new(t, i));
        let [across_ca, across_ab] = [ca, ab].map(|side| self.mesh.twin(side));
        // Triangle t becomes p b c.
        self.mesh.set_opposite(HalfEdge::new(t, 0), p);
        let u = self.mesh.add([p, c, a], [across_ca, HalfEdge::NOTHING, ca]);
        let pa = HalfEdge::new(u, 1);
        let w = self.mesh.add([p, a, b], [across_ab, ab, pa]);
        for made in [t, u, w] {
            self.probe.record(|r| r.made(made, Why::Point));
        }
        let approx = self.predicates.approx(p);
        self.legalize_fan(w, approx, a);
    }

    /// The ghost of the hull side that starts at the lowest vertex.
    fn lowest_ghost(&self) -> HalfEdge {
        let ghosts = (0..self.mesh.len()).filter_map(|t| self.hull_side(TriangleId::at(t)));
        let mut at_lowest = ghosts.filter(|&ghost| self.ends(ghost)[0] == VertexId::new(0));
        at_lowest.next().unwrap_or_else(|| inexact_scalar())
    }
}

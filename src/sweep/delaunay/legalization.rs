//! Legalization (section 2, figures 2 and 3): sides that violate the empty circle property are swapped, and their
//! neighbours tested in turn, until none violates it.
//!
//! Why it is right: a side stays if it is a border or constrained, or if it passes the exact test
//! [`SweepPredicates::must_flip`](super::super::predicates::SweepPredicates::must_flip). A flip puts the four sides
//! around the flipped one on the flip stack. When the stack is empty, every free side is locally Delaunay, and then the
//! whole triangulation is constrained Delaunay (Lee and Lin 1986; Chew 1989). The flips end, because each one lowers
//! the lifted surface, ties included (canonical rule). An abandoned sweep drops its stack ([`super::super::flip_limit`]).
//!
//! Around a *new* vertex `p` only the *outer* sides of its triangles, those opposite `p`, can be illegal. A flip gives
//! `p` one more triangle, so one walk is enough; `p` is corner 0 of all, so none is looked for:
//!
//! ```text
//!            p                            p               The walk goes through the fan of triangles
//!          / | \                        /|\ \             around p, from left to right. The outer
//!        /   |   \                     / | \  \           side a-b is illegal: it is flipped to p-q.
//!      /     |     \         ->       /  |  \   \         Now a-q and q-b are outer sides. The walk
//!     a ---- b --- last              a   |   b - last     stays at a-q until that is legal, and then
//!      \    /                         \  |  /             goes on to q-b. It ends with the triangle
//!        \/                            \ | /              whose right end is `last`.
//!         q                              q
//! ```
//!
//! Cost: a test for each triangle of the fan and two for each flip; up to four for a flip elsewhere. A new vertex needs
//! a constant number of flips on average (section 2). Differs from the paper: loops, where the paper recurses.

use super::Delaunay;
use crate::ids::{TriangleId, VertexId};
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use crate::sweep::contradiction::inexact_scalar;
use crate::trace::{Event, Outcome};

impl<P: Probe> Delaunay<'_, P> {
    /// Legalizes the outer sides of the fan around a vertex with these `approx`, from triangle `t` to the one whose
    /// right end is `last`, which is returned. The vertex is corner 0 of all of them, before and after.
    #[inline(always)]
    pub(in crate::sweep) fn legalize_fan(
        &mut self,
        t: TriangleId,
        approx: [f64; 2],
        last: VertexId,
    ) -> TriangleId {
        let mut at = t;
        loop {
            while self.is_illegal_from(approx, HalfEdge::new(at, 0)) {
                self.flip_in_fan(at);
            }
            let record = self.mesh.get(at);
            if record.vertex(2) == last {
                return at;
            }
            // Cross the spoke on the right.
            at = record.twin(1).triangle();
            if at == t {
                // The walk has come round: the fan is closed, and `last` is not in it.
                inexact_scalar();
            }
        }
    }

    /// Legalizes one side, and then the sides that its flip puts on the flip stack.
    #[inline(always)]
    pub(in crate::sweep) fn legalize_side(&mut self, side: HalfEdge) {
        if self.is_illegal(side) {
            self.flip_and_stack(side);
            self.legalize();
        }
    }

    /// Tests the sides on the flip stack until none is left, or until the budget of flips is spent.
    pub(in crate::sweep) fn legalize(&mut self) {
        while let Some(suspect) = self.flip_stack.pop() {
            if self.flip_limit.is_spent() {
                self.flip_stack.clear();
                break;
            }
            if self.is_illegal(suspect) {
                self.flip_and_stack(suspect);
            }
        }
    }

    #[inline(always)]
    fn flip_and_stack(&mut self, side: HalfEdge) {
        let twin = self.flip(side);
        let around = [side, side.prev(), twin, twin.prev()];
        self.flip_stack.extend(around);
    }

    /// Swaps a side; returns its twin of before.
    #[inline(always)]
    fn flip(&mut self, side: HalfEdge) -> HalfEdge {
        self.report_flip(side);
        let twin = self.mesh.flip(side);
        let [p, _, q] = self.mesh.around(side);
        self.count_flip([side, twin], [p, q]);
        twin
    }

    /// Swaps side 0 of a triangle in a fan around its corner 0.
    #[inline(always)]
    pub(super) fn flip_in_fan(&mut self, t: TriangleId) {
        let side = HalfEdge::new(t, 0);
        self.report_flip(side);
        let (twin, ends) = self.mesh.flip_in_fan(t);
        self.count_flip([side, twin], ends);
    }

    /// Swaps side 2 of a triangle in a fan around its corner 0, which loses the triangle on the left. Returns that.
    pub(super) fn flip_spoke(&mut self, t: TriangleId) -> TriangleId {
        self.flip(HalfEdge::new(t, 2)).triangle()
    }

    #[inline(always)]
    fn report_flip(&mut self, side: HalfEdge) {
        if self.is_observed() {
            let ([p, a, b], q) = self.quadrilateral(side);
            self.report(|name| Event::Flip {
                side: [a, b].map(name),
                new_side: [p, q].map(name),
            });
        }
    }

    /// Counts a flip of two half-edges, which made a side between `p` and `q`.
    #[inline(always)]
    fn count_flip(&mut self, sides: [HalfEdge; 2], [p, q]: [VertexId; 2]) {
        self.probe.count(|c| c.flips += 1);
        self.probe.record(|r| r.flipped(sides));
        self.flip_limit.spend();
        if p == q {
            // In a plane the two triangles of a side have different vertices opposite.
            inexact_scalar();
        }
    }

    /// Whether a side may and must be flipped.
    #[inline(always)]
    pub(super) fn is_illegal(&mut self, side: HalfEdge) -> bool {
        let approx = self.predicates.approx(self.mesh.opposite(side));
        self.is_illegal_from(approx, side)
    }

    /// Whether a side may and must be flipped, where `approx` belongs to the vertex opposite.
    #[inline(always)]
    pub(super) fn is_illegal_from(&mut self, approx: [f64; 2], side: HalfEdge) -> bool {
        let (record, i) = (self.mesh.get(side.triangle()), side.corner());
        let twin = record.twin(i);
        if twin.cannot_flip() {
            if !twin.is_border() {
                self.report_test(side, Outcome::Fixed);
            }
            return false;
        }
        let vertices = record.vertices_from(i);
        let q = self.mesh.opposite(twin);
        let is_illegal = self
            .predicates
            .must_flip(vertices, approx, q, &mut self.probe);
        let outcome = if is_illegal {
            Outcome::Illegal
        } else {
            Outcome::Legal
        };
        self.report_test(side, outcome);
        is_illegal
    }

    #[inline(always)]
    fn report_test(&mut self, side: HalfEdge, outcome: Outcome) {
        // Asked first: the empty call alone would cost instructions.
        if P::RECORDS {
            self.probe.count(|c| c.legalization_tests += 1);
        }
        if self.is_observed() {
            let ([p, a, b], q) = self.quadrilateral(side);
            self.report(|name| Event::Test {
                side: [a, b].map(name),
                opposite: [p, q].map(name),
                outcome,
            });
        }
    }

    /// The triangle of a side, from the vertex opposite on, and the vertex across the side.
    #[inline(always)]
    fn quadrilateral(&self, side: HalfEdge) -> ([VertexId; 3], VertexId) {
        let twin = self.mesh.twin(side);
        (self.mesh.around(side), self.mesh.opposite(twin))
    }
}

//! Legalization (section 2, figures 2 and 3): sides that violate the empty circle property are swapped,
//! and their neighbours tested in turn, until none violates it.
//!
//! Why it is right: a side is left alone if it is open, fixed, or passes the exact test of
//! [`Signs::must_flip`](super::signs::Signs::must_flip); a flipped one puts its four neighbours under
//! suspicion. When no suspect is left, every side is locally Delaunay, hence the whole constrained
//! Delaunay (Lee and Lin 1986; Chew 1989). It ends, since each flip lowers the lifted surface, ties
//! included (canonical rule).
//!
//! Two forms of the same. Around a *new* vertex `p` only the side opposite `p` of each triangle of its
//! fan can be illegal, and a flip hands the fan another triangle: the fan is walked once.
//!
//! ```text
//!               p                      The walk goes from triangle to triangle around p,
//!             / | \                    from the left end of the fan to `last`. An illegal
//!           /  |   \                   outer side a-b is flipped to p-q; then a-q and q-b
//!         /  t |  ...\                 are outer sides, and the walk stays at a-q until it
//!        a --- b ----- last            is legal.
//!         \   /
//!           q
//! ```
//!
//! Everywhere else a list of suspects is worked off.
//!
//! Differs from the paper: iterative, where the paper recurses.

use super::fabric::Fabric;
use crate::ids::{TriangleId, VertexId};
use crate::mesh::{Side, next, prev};
use crate::probe::Probe;
use crate::scalar::Scalar;
use crate::trace::{Event, Outcome};

impl<S: Scalar, P: Probe> Fabric<'_, S, P> {
    /// Legalizes the outer sides of the fan of corner 0 of triangle `t`, from there on to the triangle
    /// whose right end is `last`. Returns the outer side of that triangle.
    #[inline(always)]
    pub(super) fn legalize_fan(&mut self, t: TriangleId, last: VertexId) -> Side {
        let mut outer = Side::new(t, 0);
        loop {
            while self.is_illegal(outer) {
                self.flip(outer);
            }
            let (record, i) = (self.mesh.get(outer.triangle()), outer.corner());
            if record.vertex(prev(i)) == last {
                return outer;
            }
            // Across the spoke to the right; there the corner after the one opposite is that of p.
            outer = record.across(next(i)).next();
        }
    }

    /// Legalizes one side, and whatever that entails.
    #[inline(always)]
    pub(super) fn legalize_side(&mut self, side: Side) {
        if self.is_illegal(side) {
            self.flip_and_suspect(side);
            self.legalize();
        }
    }

    /// Works off the suspects.
    pub(super) fn legalize(&mut self) {
        while let Some(suspect) = self.suspects.pop() {
            if self.is_illegal(suspect) {
                self.flip_and_suspect(suspect);
            }
        }
    }

    /// Swaps a side, and suspects the four sides around it.
    fn flip_and_suspect(&mut self, side: Side) {
        let across = self.flip(side);
        let around = [side, side.prev(), across, across.prev()];
        self.suspects.extend(around);
    }

    /// Swaps a side; returns the one that lay across it.
    #[inline(always)]
    fn flip(&mut self, side: Side) -> Side {
        if P::EVENTS {
            let ([p, a, b], q) = self.quadrilateral(side);
            self.report(|name| Event::Flip {
                side: [a, b].map(name),
                new_side: [p, q].map(name),
            });
        }
        self.probe.count(|c| c.flips += 1);
        self.mesh.flip(side)
    }

    /// Whether a side may and must be flipped.
    #[inline(always)]
    fn is_illegal(&mut self, side: Side) -> bool {
        let (record, i) = (self.mesh.get(side.triangle()), side.corner());
        let across = record.across(i);
        if across.is_blocked() {
            if !across.is_open() {
                self.report_test(side, Outcome::Fixed);
            }
            return false;
        }
        let vertices = [i, next(i), prev(i)].map(|corner| record.vertex(corner));
        let q = self.mesh.opposite(across);
        let is_illegal = self.signs.must_flip(vertices, q, &mut self.probe);
        let outcome = if is_illegal {
            Outcome::Illegal
        } else {
            Outcome::Legal
        };
        self.report_test(side, outcome);
        is_illegal
    }

    #[inline(always)]
    fn report_test(&mut self, side: Side, outcome: Outcome) {
        if P::EVENTS {
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
    fn quadrilateral(&self, side: Side) -> ([VertexId; 3], VertexId) {
        let across = self.mesh.across(side);
        (self.mesh.around(side), self.mesh.opposite(across))
    }
}

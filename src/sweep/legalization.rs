//! Legalization (section 2, figures 2 and 3): edges that violate the empty circle property are
//! swapped, and their neighbours tested in turn, until none violates it.
//!
//! Why it is right: a side is left alone if it is open, fixed, or passes the exact test of
//! [`Predicates::must_flip`](crate::predicates::Predicates::must_flip); a flipped one puts its four
//! neighbours under suspicion. When no suspect is left, every side is locally Delaunay, hence the whole
//! constrained Delaunay (Lee and Lin 1986; Chew 1989). It ends, since each flip lowers the lifted
//! surface, ties included (canonical rule).
//!
//! Two forms of the same. Around a *new* vertex `p` only the side opposite `p` of each triangle of its
//! fan can be illegal, and a flip hands the fan another triangle: the fan is walked once from left to
//! right. Everywhere else a list of suspects is worked off.
//!
//! Differs from the paper: iterative, where the paper recurses.

use super::Sweep;
use crate::Scalar;
use crate::front::FrontSearch;
use crate::mesh::{Link, TriangleId, VertexId, next, prev};
use crate::probe::Probe;
use crate::trace::{Event, Outcome};

impl<S: Scalar, F: FrontSearch, P: Probe> Sweep<'_, S, F, P> {
    /// Legalizes the sides opposite corner `i` of triangle `t`, in the fan of that corner's vertex up
    /// to the triangle whose right end is `last`. Returns that triangle as a link to its outer side.
    #[inline(always)]
    pub(super) fn legalize_fan(&mut self, mut t: TriangleId, last: VertexId) -> Link {
        let mut i = 0;
        loop {
            while self.is_illegal(t, i) {
                self.flip(t, i);
            }
            let record = self.mesh.get(t);
            if record.vertex(prev(i)) == last {
                return Link::new(t, i);
            }
            let spoke = record.link(next(i));
            t = spoke.triangle();
            i = next(spoke.corner());
        }
    }

    /// Legalizes the one side that `link` leads to, and whatever that entails.
    #[inline(always)]
    pub(super) fn legalize_side(&mut self, link: Link) {
        if self.is_illegal(link.triangle(), link.corner()) {
            self.flip_and_suspect(link);
            self.legalize();
        }
    }

    /// Works off the suspects.
    pub(super) fn legalize(&mut self) {
        while let Some(suspect) = self.suspects.pop() {
            if self.is_illegal(suspect.triangle(), suspect.corner()) {
                self.flip_and_suspect(suspect);
            }
        }
    }

    /// Swaps the side that `link` leads to, and suspects the four sides around it.
    fn flip_and_suspect(&mut self, link: Link) {
        let (t, i) = (link.triangle(), link.corner());
        let across = self.flip(t, i);
        let (u, j) = (across.triangle(), across.corner());
        self.suspects.extend([
            Link::new(t, i),
            Link::new(t, prev(i)),
            Link::new(u, j),
            Link::new(u, prev(j)),
        ]);
    }

    /// Swaps the side opposite corner `i` of triangle `t`; returns the link across it that was.
    #[inline(always)]
    fn flip(&mut self, t: TriangleId, i: u32) -> Link {
        let ([p, a, b], q) = self.quadrilateral(t, i);
        self.tell(|name| Event::Flip {
            side: [a, b].map(name),
            new_side: [p, q].map(name),
        });
        self.predicates.probe.count(|c| c.flips += 1);
        self.mesh.flip(t, i)
    }

    /// Whether the side opposite corner `i` of triangle `t` may and must be flipped.
    #[inline(always)]
    fn is_illegal(&mut self, t: TriangleId, i: u32) -> bool {
        let across = self.mesh.get(t).link(i);
        if across.is_blocked() {
            if !across.is_open() {
                self.tell_test(t, i, Outcome::Fixed);
            }
            return false;
        }
        let ([p, a, b], q) = self.quadrilateral(t, i);
        let is_illegal = self.predicates.must_flip(p, a, b, q);
        self.tell_test(
            t,
            i,
            if is_illegal {
                Outcome::Illegal
            } else {
                Outcome::Legal
            },
        );
        is_illegal
    }

    #[inline(always)]
    fn tell_test(&mut self, t: TriangleId, i: u32, outcome: Outcome) {
        if P::EVENTS {
            let ([p, a, b], q) = self.quadrilateral(t, i);
            let (side, opposite) = ([a, b], [p, q]);
            self.tell(|name| Event::Test {
                side: side.map(name),
                opposite: opposite.map(name),
                outcome,
            });
        }
    }

    /// The vertices of triangle `t` from corner `i` on, and the one across the side opposite to it.
    #[inline(always)]
    fn quadrilateral(&self, t: TriangleId, i: u32) -> ([VertexId; 3], VertexId) {
        let record = self.mesh.get(t);
        let vertices = [i, next(i), prev(i)].map(|corner| record.vertex(corner));
        (vertices, self.mesh.opposite(record.link(i)))
    }
}

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

impl<S: Scalar, F: FrontSearch, P: Probe> Sweep<'_, S, F, P> {
    /// Legalizes the sides opposite corner `i` of triangle `t`, in the fan of that corner's vertex up
    /// to the triangle whose right end is `last`. Returns that triangle as a link to its outer side.
    #[inline(always)]
    pub(super) fn legalize_fan(&mut self, mut t: TriangleId, last: VertexId) -> Link {
        let mut i = 0;
        loop {
            while self.is_illegal(t, i) {
                self.mesh.flip(t, i);
                self.predicates.probe.count(|c| c.flips += 1);
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
            self.suspects.push(link);
            self.legalize();
        }
    }

    /// Works off the suspects.
    pub(super) fn legalize(&mut self) {
        while let Some(suspect) = self.suspects.pop() {
            let (t, i) = (suspect.triangle(), suspect.corner());
            if self.is_illegal(t, i) {
                let across = self.mesh.flip(t, i);
                self.predicates.probe.count(|c| c.flips += 1);
                let (u, j) = (across.triangle(), across.corner());
                self.suspects.extend([
                    Link::new(t, i),
                    Link::new(t, prev(i)),
                    Link::new(u, j),
                    Link::new(u, prev(j)),
                ]);
            }
        }
    }

    /// Whether the side opposite corner `i` of triangle `t` may and must be flipped.
    #[inline(always)]
    fn is_illegal(&mut self, t: TriangleId, i: u32) -> bool {
        let record = self.mesh.get(t);
        let across = record.link(i);
        if across.is_blocked() {
            return false;
        }
        let (p, a, b) = (
            record.vertex(i),
            record.vertex(next(i)),
            record.vertex(prev(i)),
        );
        let q = self.mesh.opposite(across);
        self.predicates.must_flip(p, a, b, q)
    }
}

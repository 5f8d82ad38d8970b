//! The merge of two sub-triangulations (Guibas and Stolfi 1985, section 5).
//!
//! A line separates the two. The figure turns it upright: the lower one, L, is on the left, the upper one, R, on the right.
//!
//! ```text
//!      l2 . . . . . r2      The *base* l-r starts as the side of the common hull below both. It climbs:
//!      |\   right  /|       the next triangle is l, r, l2 or l, r, r2, where l2 and r2 are the
//!      | \   gap  / |       neighbours of l and r on the hulls that face the gap. The one is made whose
//!      |  \      /  |       circle does not contain the other vertex. Before that, sides l-l2 whose
//!   L  |   l----r   |  R    triangle in L contains r in its circle are removed; likewise in R.
//!      |  /      \  |       When neither l2 nor r2 lies above the base, it is the side of the common hull
//!                           above both.
//! ```
//!
//! Why it is right: both tests ask whether a side of a quadrilateral must be flipped
//! ([`SweepPredicates::must_flip`](super::super::predicates::SweepPredicates::must_flip)), so the canonical rule decides
//! ties. By that rule no four points lie on one circle, so the proof of 1985 holds. In triangles: to remove a hull side is
//! to flip it, between its triangle and its ghost. To make a triangle is to replace the third vertex of a ghost.
//!
//! Where sides may be constrained, none is removed, and the gap is *stitched*. If r2 lies in the triangle l, r, l2, it
//! lies in its circle, and the other triangle is made; likewise l2. So the triangles fill the gap without overlap. All
//! their sides go on the flip stack, and legalization does the rest ([`Delaunay::legalize`]).
//!
//! Cost: O(k) for k vertices in both: each step removes a triangle or moves the base, which only climbs.

use core::cmp::Ordering::{Greater, Less};

use super::super::contradiction::inexact_scalar;
use super::super::delaunay::Delaunay;
use super::{MergeMode, SubTriangulation};
use crate::ids::VertexId;
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;

/// The gap between two sub-triangulations while it is being closed.
struct Gap {
    /// The ends of the base, in the left and in the right sub-triangulation.
    l: VertexId,
    r: VertexId,
    /// The base as a side of the triangle below it.
    base: HalfEdge,
    /// The ghosts at the gap, of the hull sides from `l` and to `r`. Their sides at `l` and `r` border on nothing.
    left: HalfEdge,
    right: HalfEdge,
    mode: MergeMode,
    /// How many steps the merge may still take.
    steps: usize,
}

impl<P: Probe> Delaunay<'_, P> {
    /// Merges two sub-triangulations; vertices of `upper` come after those of `lower` in sweep order.
    pub(in crate::sweep) fn merge(
        &mut self,
        lower: SubTriangulation,
        upper: SubTriangulation,
        mode: MergeMode,
    ) -> SubTriangulation {
        let [first, _] = self.ends(lower.first);
        let [last, _] = self.ends(upper.last);
        let [before, after] = self.tangent(lower, upper);
        let ([_, l], [r, _]) = (self.ends(before), self.ends(after));
        let (left, right) = (self.after(before), self.before(after));

        let bottom = self.add_ghost(l, r);
        self.join_ghosts(before, bottom);
        self.join_ghosts(bottom, after);
        let mut gap = Gap {
            l,
            r,
            base: bottom,
            left,
            right,
            mode,
            // A merge takes fewer steps than there are triangles, ghosts included.
            steps: 2 * self.mesh.len(),
        };
        self.mesh.detach(left.next());
        self.mesh.detach(right.prev());
        while self.climb(&mut gap) {}
        let top = self.add_ghost(gap.r, gap.l);
        self.join_ghosts(gap.right, top);
        self.join_ghosts(top, gap.left);
        self.mesh.connect(top, gap.base);

        SubTriangulation {
            first: if l == first { bottom } else { lower.first },
            last: if gap.r == last { top } else { upper.last },
        }
    }

    /// The ghosts beside the first base: of the hull sides that end at its left end and start at its right end.
    fn tangent(&mut self, lower: SubTriangulation, upper: SubTriangulation) -> [HalfEdge; 2] {
        // The last vertex on the left sees the first on the right. Both ends go down while a neighbour is lower.
        let (mut before, mut after) = (self.before(lower.last), upper.first);
        for _ in 0..2 * self.mesh.len() {
            let ([l2, l], [r, r2]) = (self.ends(before), self.ends(after));
            if self.orient2d([l, r, r2]) == Less {
                after = self.after(after);
            } else if self.orient2d([l, r, l2]) == Less {
                before = self.before(before);
            } else {
                return [before, after];
            }
        }
        inexact_scalar()
    }

    /// Makes the triangle above the base, and moves the base up to its other side. Returns whether there was one.
    fn climb(&mut self, gap: &mut Gap) -> bool {
        let l2 = self.left_candidate(gap);
        let r2 = self.right_candidate(gap);
        let is_right = match (l2, r2) {
            (None, None) => return false,
            (Some(_), None) => false,
            (None, Some(_)) => true,
            (Some(l2), Some(r2)) => self.must_flip([gap.l, gap.r, l2], r2),
        };
        let outer = if is_right { gap.right } else { gap.left };
        self.probe.record(|r| r.merged(outer.triangle()));
        if gap.mode == MergeMode::Stitch {
            self.stack([outer, gap.base]);
        }
        if is_right {
            let next = self.before(gap.right);
            self.mesh.set_opposite(gap.right, gap.l);
            self.mesh.connect(gap.right.prev(), gap.base);
            gap.base = gap.right.next();
            gap.r = self.mesh.around(gap.right)[2];
            gap.right = next;
            self.mesh.detach(next.prev());
        } else {
            let next = self.after(gap.left);
            self.mesh.set_opposite(gap.left, gap.r);
            self.mesh.connect(gap.left.next(), gap.base);
            gap.base = gap.left.prev();
            gap.l = self.mesh.around(gap.left)[1];
            gap.left = next;
            self.mesh.detach(next.next());
        }
        gap.step();
        true
    }

    /// The neighbour of `l` above the base, after the sides that must go have been removed.
    fn left_candidate(&mut self, gap: &mut Gap) -> Option<VertexId> {
        let [_, mut l2] = self.ends(gap.left);
        if self.orient2d([gap.l, gap.r, l2]) != Greater {
            return None;
        }
        while gap.mode == MergeMode::Delete
            && let Some(behind) = self.behind(gap.left)
            && self.must_flip([gap.r, l2, gap.l], behind)
        {
            // The ghost of l-l2 becomes that of behind-l2; the other triangle becomes the ghost of l-behind.
            gap.left = self.mesh.flip(gap.left).prev();
            l2 = behind;
            gap.step();
        }
        Some(l2)
    }

    /// The neighbour of `r` above the base, after the sides that must go have been removed.
    fn right_candidate(&mut self, gap: &mut Gap) -> Option<VertexId> {
        let [mut r2, _] = self.ends(gap.right);
        if self.orient2d([gap.l, gap.r, r2]) != Greater {
            return None;
        }
        while gap.mode == MergeMode::Delete
            && let Some(behind) = self.behind(gap.right)
            && self.must_flip([gap.l, gap.r, r2], behind)
        {
            // The ghost keeps the end at r.
            self.mesh.flip(gap.right);
            r2 = behind;
            gap.step();
        }
        Some(r2)
    }

    /// The vertex behind a hull side, if a triangle is there and no ghost.
    fn behind(&self, ghost: HalfEdge) -> Option<VertexId> {
        let v = self.mesh.opposite(self.mesh.twin(ghost));
        (!self.predicates.is_artificial(v)).then_some(v)
    }

    fn must_flip(&mut self, triangle: [VertexId; 3], q: VertexId) -> bool {
        let approx = self.predicates.approx(triangle[0]);
        self.predicates
            .must_flip(triangle, approx, q, &mut self.probe)
    }
}

impl Gap {
    fn step(&mut self) {
        if self.steps == 0 {
            inexact_scalar();
        }
        self.steps -= 1;
    }
}

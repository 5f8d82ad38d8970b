//! The point event (section 3.4.1): the new vertex joins the front.
//!
//! Its vertical projection falls on a segment of the front, strictly inside (middle case, figure 7) or
//! on the left end of it (left case, figure 8). The segment and the vertex make a triangle; the left
//! case makes a second one, since two vertices above one another cannot both stay on the front. Then
//! the heuristics add triangles where the front would be steep (figures 9 and 10).
//!
//! Why it is right: the vertex comes after all others in sweep order, so it lies strictly above the
//! segment under it, and no test of orientation is needed. Beyond the first triangle every further one
//! closes a corner of the front that turns left by exact sign; it lies above the front, where nothing
//! is. Its outer side is legalized in the fan of the new vertex as if the spoke beside it were fixed,
//! then the spoke.
//!
//! Cost: a search, a few walk steps, and a constant number of triangles and flips on average.
//!
//! Differs from the paper: the left case is the middle case and one forced corner; angles are compared
//! by dot products; [`Corners::Wide`] goes a little beyond pi/2; a basin is filled as far up as its rim
//! beside the new vertex, to the upper hull of that stretch.

use std::cmp::Ordering::{Equal, Greater, Less};

use super::Sweep;
use crate::Scalar;
use crate::front::{Front, FrontSearch};
use crate::heuristics::Corners;
use crate::mesh::{Link, VertexId, next};
use crate::probe::Probe;
use crate::trace::{Event, PointCase, Why};

/// Square of the cosine of 110 degrees.
const WIDE: f64 = 0.117;
/// A basin is searched for at most this many nodes either way, so that the search stays O(1).
const BASIN_REACH: usize = 32;

impl<S: Scalar, F: FrontSearch, P: Probe> Sweep<'_, S, F, P> {
    /// Adds vertex `p`, the next one in sweep order.
    pub(super) fn point_event(&mut self, p: VertexId) {
        let left = self.segment_under(p);
        let right = self.front.next(left);
        let above = self.predicates.compare_x(left, p) == Equal;

        self.tell(|name| Event::Point {
            vertex: name(p),
            case: if above {
                PointCase::Left
            } else {
                PointCase::Middle
            },
            segment: [left, right].map(name),
        });
        let below = self.mesh.open(left);
        let links = [below, Link::open(p), Link::open(left)];
        let t = self.make([p, left, right], links, Why::Point);
        self.put_on_front(p, left);
        self.legalize_fan(t, right);
        if above {
            self.predicates.probe.count(|c| c.left_cases += 1);
            self.close_left(p, Why::Point);
        }
        if self.heuristics.corners != Corners::Off {
            self.fill_beside(p);
        }
        if self.heuristics.basins {
            self.fill_basins(p);
        }
    }

    /// The left end of the front segment under the projection of `p`: the last node whose x is at most
    /// that of `p`. The search structure says where to start.
    #[inline(always)]
    fn segment_under(&mut self, p: VertexId) -> VertexId {
        let x = self.predicates.near(p)[0];
        let start = self.search.locate(x, &self.front);
        assert!(
            self.front.contains(start),
            "the search structure named a node off the front"
        );
        let mut at = start.vertex();
        while self.predicates.compare_x(at, p) == Greater {
            at = self.front.prev(at);
            self.predicates.probe.count(|c| c.front_steps += 1);
        }
        loop {
            let right = self.front.next(at);
            if self.predicates.compare_x(right, p) == Greater {
                return at;
            }
            at = right;
            self.predicates.probe.count(|c| c.front_steps += 1);
        }
    }

    /// Heuristic (i), figure 9: closes the corners right and left of `p` while they are narrow.
    #[inline(always)]
    fn fill_beside(&mut self, p: VertexId) {
        let mut may_be_obtuse = self.heuristics.corners == Corners::Wide;
        loop {
            let corner = self.front.next(p);
            let far = self.front.next(corner);
            if !self.is_narrow(p, corner, far, &mut may_be_obtuse)
                || self.predicates.orient2d(p, corner, far) != Greater
            {
                break;
            }
            self.close_right(p);
            self.predicates.probe.count(|c| c.narrow_corners += 1);
        }
        let mut may_be_obtuse = self.heuristics.corners == Corners::Wide;
        loop {
            let corner = self.front.prev(p);
            let far = self.front.prev(corner);
            if !self.is_narrow(p, corner, far, &mut may_be_obtuse)
                || self.predicates.orient2d(p, corner, far) != Less
            {
                break;
            }
            self.close_left(p, Why::NarrowCorner);
            self.predicates.probe.count(|c| c.narrow_corners += 1);
        }
    }

    /// Whether the angle at `corner` between `p` and `far` is small, by plain floating point: below
    /// pi/2, or once below 110 degrees. Never if one of them is artificial.
    #[inline(always)]
    fn is_narrow(
        &self,
        p: VertexId,
        corner: VertexId,
        far: VertexId,
        may_be_obtuse: &mut bool,
    ) -> bool {
        // Beyond an artificial corner there is no node, whose number is larger still.
        if far >= self.predicates.left {
            return false;
        }
        let [[px, py], [cx, cy], [fx, fy]] = [p, corner, far].map(|v| self.predicates.near(v));
        let (ax, ay, bx, by) = (px - cx, py - cy, fx - cx, fy - cy);
        let dot = ax * bx + ay * by;
        if dot > 0.0 {
            return true;
        }
        // Only once: beside a long straight stretch each new vertex would else close many corners that
        // the next one opens again.
        std::mem::take(may_be_obtuse)
            && dot * dot < WIDE * (ax * ax + ay * ay) * (bx * bx + by * by)
    }

    /// Covers the node right of `p`: triangle of `p`, that node and the one after.
    #[inline(always)]
    fn close_right(&mut self, p: VertexId) {
        let corner = self.front.next(p);
        let far = self.front.next(corner);
        let (outer, spoke) = (self.mesh.open(corner), self.mesh.open(p));
        let t = self.make(
            [p, corner, far],
            [outer, Link::open(p), spoke],
            Why::NarrowCorner,
        );
        self.take_off_front(corner);
        self.legalize_fan(t, far);
        self.legalize_side(Link::new(t, 2));
    }

    /// Covers the node left of `p`: triangle of `p`, the node before that one, and it.
    #[inline(always)]
    fn close_left(&mut self, p: VertexId, why: Why) {
        let corner = self.front.prev(p);
        let far = self.front.prev(corner);
        let (outer, spoke) = (self.mesh.open(far), self.mesh.open(corner));
        let t = self.make([p, far, corner], [outer, spoke, Link::open(far)], why);
        self.take_off_front(corner);
        let rightmost = self.legalize_fan(t, corner);
        self.legalize_side(Link::new(rightmost.triangle(), next(rightmost.corner())));
    }

    /// Heuristic (ii), figure 10: fills the basins that begin right and left of `p`.
    #[inline(always)]
    fn fill_basins(&mut self, p: VertexId) {
        if self.falls_away(p, Front::next) {
            self.fill_basin(p, Front::next);
        }
        if self.falls_away(p, Front::prev) {
            self.fill_basin(p, Front::prev);
        }
    }

    /// Whether the front falls from `p` over the next two nodes by more than 45 degrees: an angle of
    /// more than 3pi/4 with the vertical. False if one of them is artificial.
    #[inline(always)]
    fn falls_away(&self, p: VertexId, step: fn(&Front, VertexId) -> VertexId) -> bool {
        let first = step(&self.front, p);
        if first >= self.predicates.left {
            return false;
        }
        let [[px, py], [x, y]] = [p, step(&self.front, first)].map(|v| self.predicates.near(v));
        py - y > (px - x).abs()
    }

    /// Fills a basin: from its rim, the node beside `p`, down to the bottom and up again, not above the
    /// rim.
    fn fill_basin(&mut self, p: VertexId, step: fn(&Front, VertexId) -> VertexId) {
        let height = |sweep: &Self, v: VertexId| sweep.predicates.near(v)[1];
        let rim = step(&self.front, p);
        let top = height(self, rim);
        let (mut at, mut y) = (rim, top);
        for falling in [true, false] {
            for _ in 0..BASIN_REACH {
                let beyond = step(&self.front, at);
                let next_y = height(self, beyond);
                let goes_on = if falling {
                    next_y < y
                } else {
                    next_y > y && next_y <= top
                };
                // False for an artificial node, whose height is no number.
                if !goes_on {
                    break;
                }
                (at, y) = (beyond, next_y);
            }
        }
        let (from, to) = if self.predicates.compare_x(p, at) == Less {
            (rim, at)
        } else {
            (at, rim)
        };
        let added = self.fill_front(from, to, Why::Basin);
        self.predicates.probe.count(|c| c.basin_triangles += added);
    }
}

//! The point event (section 3.4.1): the new vertex joins the front.
//!
//! The vertical projection `P_Q` of the vertex falls on a segment of the front: strictly inside (middle case, figure 7)
//! or on the left end (left case, figure 8). The segment and the vertex make a triangle. The left case makes a second
//! one, since of two vertices one above the other only one is on the front. Then come the heuristics
//! ([`super::narrow_corners`], [`super::basins`]).
//!
//! ```text
//!   middle case:     p                left case:     p           In both cases: triangle p, left, right.
//!                  / : \                          / | \
//!                /   :   \                      /   |   \       In the left case the corner left of p
//!   ... --- left ---P_Q--- right ---   ... - far    |    right   is then closed: triangle p, far, left.
//!                                               \   |   /
//!                                                left = P_Q
//! ```
//!
//! Why it is right: the vertex comes after all others in sweep order, so it lies strictly above the segment under it,
//! and no test of orientation is needed. Cost: a search, a few walk steps, and a constant number of triangles and flips
//! on average. Differs from the paper: the left case is the middle case, and then one corner closed.

use core::cmp::Ordering::{Equal, Greater};
use core::hint::select_unpredictable;

use super::narrow_corners::Obtuse;
use super::{NewVertex, Sweep};
use crate::front::Direction;
use crate::ids::{BorderId, VertexId};
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use crate::settings::Corners;
use crate::trace::{Event, PointCase, Why};

impl<P: Probe> Sweep<'_, P> {
    /// Adds vertex `v`, the next one in sweep order.
    pub(super) fn point_event(&mut self, v: VertexId) {
        let p = self.new_vertex(v);
        let (left, is_above) = self.segment_under(p);
        self.add_above(p, left, is_above);
        self.apply_heuristics(p);
    }

    /// Joins `p` to the front on the segment that starts at `left`; `is_above` if `p` is straight above `left`.
    #[inline(always)]
    pub(super) fn add_above(&mut self, p: NewVertex, left: VertexId, is_above: bool) {
        let right = self.front.next(left);

        self.delaunay.report(|name| Event::Point {
            vertex: name(p.id),
            case: if is_above {
                PointCase::Left
            } else {
                PointCase::Middle
            },
            segment: [left, right].map(name),
        });
        // The triangle on the segment: its other two sides are the new segments of the front.
        let segment = BorderId::segment(left);
        let twin = [
            self.delaunay.mesh.border_twin(segment),
            HalfEdge::border(BorderId::segment(p.id)),
            HalfEdge::border(segment),
        ];
        let t = self
            .delaunay
            .add_triangle([p.id, left, right], twin, Why::Point);
        self.put_on_front(p, left);
        self.delaunay.legalize_fan(t, p.approx, right);

        // The second triangle of the left case.
        if is_above {
            self.delaunay.probe.count(|c| c.left_cases += 1);
            let far = self.front.prev(left);
            self.close_corner(p, Direction::Left, [left, far], Why::Point);
        }
    }

    /// Covers the node `corner` beside `p` by a triangle of `p`, `corner`, and the node after it, `far`.
    #[inline(always)]
    pub(super) fn close_corner(
        &mut self,
        p: NewVertex,
        direction: Direction,
        [corner, far]: [VertexId; 2],
        why: Why,
    ) {
        // Segments bear the number of their left end. The outer one runs from `corner` to `far`, the spoke from `p` to
        // `corner`; the new segment runs from `p` to `far`.
        let below = |v| self.delaunay.mesh.border_twin(BorderId::segment(v));
        let border = |v| HalfEdge::border(BorderId::segment(v));
        let (vertices, twin) = match direction {
            Direction::Right => (
                [p.id, corner, far],
                [below(corner), border(p.id), below(p.id)],
            ),
            Direction::Left => (
                [p.id, far, corner],
                [below(far), below(corner), border(far)],
            ),
        };
        let t = self.delaunay.add_triangle(vertices, twin, why);
        self.take_off_front(corner);
        let rightmost = self.delaunay.legalize_fan(t, p.approx, vertices[2]);
        let spoke = match direction {
            Direction::Right => HalfEdge::new(t, 2),
            Direction::Left => HalfEdge::new(rightmost, 1),
        };
        self.delaunay.legalize_side(spoke);
    }

    /// Adds the triangles of the heuristics beside `p`, the node of the front swept last.
    #[inline(always)]
    pub(super) fn apply_heuristics(&mut self, p: NewVertex) {
        let heuristics = self.heuristics();
        match heuristics.corners {
            Corners::Off => {}
            Corners::RightAngle | Corners::Wide => {
                self.close_narrow_corners(p, Obtuse::of(heuristics.corners));
            }
            #[cfg(feature = "comparison")]
            Corners::OneUpTo(_) | Corners::AllUpTo(_) => {
                self.close_corners_to_compare(p, heuristics.corners);
            }
        }
        if heuristics.basins {
            self.fill_basins(p.id);
        }
    }

    /// The segment under the projection of `p`, by its left end: the last node whose x is at most that of `p`, and
    /// whether the two x are equal. The search structure says where to start.
    #[inline(always)]
    pub(super) fn segment_under(&mut self, p: NewVertex) -> (VertexId, bool) {
        let predicates = &self.delaunay.predicates;
        let start = self.search.locate(p.approx[0], &self.front);
        assert!(
            self.front.contains(start),
            "the search structure named a node off the front"
        );
        // Whether the first step goes left is as good as random, so it is taken without a branch.
        let start = start.vertex();
        let is_beyond = predicates.approx(start)[0] > p.approx[0];
        let mut at = select_unpredictable(is_beyond, self.front.prev(start), start);
        let mut steps = usize::from(is_beyond);
        let mut order = predicates.compare_x_approx(at, p.id, p.approx);
        while order == Greater {
            at = self.front.prev(at);
            order = predicates.compare_x_approx(at, p.id, p.approx);
            steps += 1;
        }
        loop {
            let right = self.front.next(at);
            let beyond = predicates.compare_x_approx(right, p.id, p.approx);
            if beyond == Greater {
                break;
            }
            (at, order) = (right, beyond);
            steps += 1;
        }
        self.delaunay.probe.count(|c| {
            c.front_steps += steps as u64;
            c.point_events += 1;
        });
        if steps > self.delaunay.tuning.long_walk {
            self.delaunay.flip_limit.spend_steps(steps);
        }
        (at, order == Equal)
    }
}

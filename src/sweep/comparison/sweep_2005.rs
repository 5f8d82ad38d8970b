//! The sweep of Žalik (2005), without the artificial points P-1 and P-2 (section 3.1, figure 4): all triangles are
//! real, and the lower hull is kept beside the advancing front. A point event whose projection falls on the front is
//! that of the sweep. Beyond an end of the front, or above it, come the cases that P-1 and P-2 are there to avoid:
//!
//! ```text
//!    inner --- end . . . . p       inner . . . . . p     On the left the sides end-u1 and u1-u2 are seen from
//!               |    .  . .            \    .  ' .       p and make triangles with it. On the right none is
//!               |  .  . .               \.' .  '         seen, and the corner at `end` is closed. Then p is
//!               u1  . .                  end             the end of the front, and a new side of the hull
//!              /  . .                   /                leads to it: u2-p or end-p. At the left end of the
//!            u2 .                      u1                front all is mirrored.
//! ```
//!
//! Why it is right: the hull is convex and `p` is not in it, so the sides that have `p` strictly outside follow each
//! other from `end` down. With `p` they make triangles. If there is none, `p` lies above the line of the last side or
//! on it, and the front at `end` lies above that line. So the corner between `inner`, `end` and `p` turns strictly
//! inward, and is closed. After either case every side of front and hull has a triangle.
//!
//! The first triangle: Žalik distinguishes six cases. Here the vertices up to the first one off the line of the first
//! two are swept with P-1 and P-2, the front is filled to its hull, and then the artificial triangles go. They come
//! back when the points are triangulated, because the edges and the result are made with them.
//!
//! Cost: that of the sweep. A point event beyond an end costs one orientation test more than the hull sides that it
//! sees; all together they are no more than the vertices.

use alloc::vec::Vec;
use core::cmp::Ordering::Less;

use super::super::{NewVertex, Sweep};
use crate::error::Error;
use crate::front::Direction;
use crate::ids::{BorderId, VertexId};
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use crate::trace::Why;

#[derive(Clone, Copy, Debug)]
struct HullSide {
    lower: VertexId,
    upper: VertexId,
    /// The border half-edge that the side's triangle borders on.
    border: BorderId,
}

/// The lower hull left and right of the lowest vertex; the last sides end at the ends of the front.
#[derive(Debug, Default)]
struct LowerHull {
    left: Vec<HullSide>,
    right: Vec<HullSide>,
}

impl LowerHull {
    fn beside(&mut self, direction: Direction) -> &mut Vec<HullSide> {
        match direction {
            Direction::Left => &mut self.left,
            Direction::Right => &mut self.right,
        }
    }
}

impl<P: Probe> Sweep<'_, P> {
    /// Sweeps the points, and then inserts the edges; afterwards the hull is complete. Returns false if all vertices
    /// lie on one line.
    pub(in crate::sweep) fn sweep_without_artificial(&mut self) -> Result<bool, Error> {
        let n = self.delaunay.predicates.vertices.len();
        let Some(off_line) = self.begin_off_line() else {
            return Ok(false);
        };
        let first = off_line.index() + 1;
        for v in (1..first).map(VertexId::at) {
            self.point_event(v);
        }
        self.fill_front(
            self.end(Direction::Left),
            self.end(Direction::Right),
            Why::Hull,
        );
        let artificial = self.delaunay.predicates.artificial;
        let mut hull = self.take_lower_hull();
        for v in (first..n).map(VertexId::at) {
            let p = self.new_vertex(v);
            let (left, is_above) = self.segment_under(p);
            if left == artificial.left || is_above && left == self.end(Direction::Left) {
                self.beside_front(p, Direction::Left, &mut hull);
            } else if self.front.next(left) == artificial.right {
                self.beside_front(p, Direction::Right, &mut hull);
            } else {
                self.add_above(p, left, is_above);
            }
            self.apply_heuristics(p);
        }
        self.complete_hull();
        self.enclose_lower_hull(&hull);
        self.insert_all()?;
        Ok(true)
    }

    /// The last real node of the front in a direction.
    fn end(&self, direction: Direction) -> VertexId {
        let artificial = self.delaunay.predicates.artificial;
        match direction {
            Direction::Left => self.front.next(artificial.left),
            Direction::Right => self.front.prev(artificial.right),
        }
    }

    /// Removes the artificial triangles; returns the lower hull of the vertices swept.
    fn take_lower_hull(&mut self) -> LowerHull {
        let mut hull = LowerHull::default();
        for ghost in self.lower_ghosts() {
            let [a, b] = self.delaunay.ends(ghost);
            let mesh = &mut self.delaunay.mesh;
            let border = mesh.add_border();
            mesh.connect(mesh.twin(ghost), HalfEdge::border(border));
            mesh.retire(ghost.triangle());
            let direction = if b < a {
                Direction::Left
            } else {
                Direction::Right
            };
            let [lower, upper] = [a.min(b), a.max(b)];
            hull.beside(direction).push(HullSide {
                lower,
                upper,
                border,
            });
        }
        // The ghosts run down on the left.
        hull.left.reverse();
        hull
    }

    /// Adds `p`, which lies beyond the end of the front or above it.
    fn beside_front(&mut self, p: NewVertex, direction: Direction, hull: &mut LowerHull) {
        let sides = hull.beside(direction);
        let end = self.end(direction);
        let border = self.delaunay.mesh.add_border();
        // A segment of the front bears the number of its left end.
        let (before, segment) = match direction {
            Direction::Left => (self.delaunay.predicates.artificial.left, p.id),
            Direction::Right => (end, end),
        };
        self.put_on_front(p, before);
        let mut spoke = HalfEdge::border(BorderId::segment(segment));
        let mut lower = end;
        while let Some(&side) = sides.last()
            && self.sees(p.id, direction, side)
        {
            sides.pop();
            lower = side.lower;
            let [behind, new] = [
                self.delaunay.mesh.border_twin(side.border),
                HalfEdge::border(border),
            ];
            let (vertices, twin) = match direction {
                Direction::Left => ([p.id, lower, side.upper], [behind, spoke, new]),
                Direction::Right => ([p.id, side.upper, lower], [behind, new, spoke]),
            };
            let t = self.delaunay.add_triangle(vertices, twin, Why::Point);
            self.delaunay.legalize_fan(t, p.approx, vertices[2]);
            spoke = self.delaunay.mesh.border_twin(border);
        }
        if lower == end {
            self.close_end(p, direction, end, border);
        }
        sides.push(HullSide {
            lower,
            upper: p.id,
            border,
        });
    }

    /// Whether `p` lies strictly outside a side of the hull.
    fn sees(&mut self, p: VertexId, direction: Direction, side: HullSide) -> bool {
        let [from, to] = match direction {
            Direction::Left => [side.upper, side.lower],
            Direction::Right => [side.lower, side.upper],
        };
        self.delaunay.orient2d([from, to, p]) == Less
    }

    /// Closes the corner at `end`, the front's former end, now below it; the triangle borders on `border`.
    fn close_end(&mut self, p: NewVertex, direction: Direction, end: VertexId, border: BorderId) {
        let inner = match direction {
            Direction::Left => self.front.next(end),
            Direction::Right => self.front.prev(end),
        };
        let below = |v| self.delaunay.mesh.border_twin(BorderId::segment(v));
        let segment = |v| HalfEdge::border(BorderId::segment(v));
        let (vertices, twin) = match direction {
            Direction::Left => (
                [p.id, end, inner],
                [below(end), segment(p.id), HalfEdge::border(border)],
            ),
            Direction::Right => (
                [p.id, inner, end],
                [below(inner), HalfEdge::border(border), segment(inner)],
            ),
        };
        let t = self.delaunay.add_triangle(vertices, twin, Why::Point);
        self.take_off_front(end);
        self.delaunay.legalize_fan(t, p.approx, vertices[2]);
    }

    /// Puts artificial triangles below the lower hull.
    fn enclose_lower_hull(&mut self, hull: &LowerHull) {
        // Counter-clockwise: down on the left, up on the right.
        let left = hull
            .left
            .iter()
            .rev()
            .map(|side| (side.upper, side.lower, side.border));
        let right = hull
            .right
            .iter()
            .map(|side| (side.lower, side.upper, side.border));
        let delaunay = &mut self.delaunay;
        let mut ghosts = |sides: &mut dyn Iterator<Item = (VertexId, VertexId, BorderId)>| {
            let mut ghosts: Vec<HalfEdge> = Vec::new();
            for (a, b, border) in sides {
                let ghost = delaunay.add_ghost(a, b);
                delaunay
                    .mesh
                    .connect(ghost, delaunay.mesh.border_twin(border));
                if let Some(&before) = ghosts.last() {
                    delaunay.join_ghosts(before, ghost);
                }
                ghosts.push(ghost);
            }
            ghosts
        };
        let [left, right] = [ghosts(&mut { left }), ghosts(&mut { right })];
        let last = self.end(Direction::Right);
        self.close_lower_hull(&left, &right, VertexId::new(0), last);
    }
}

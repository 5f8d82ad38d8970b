//! The sweep of Žalik (2005), without the artificial points P-1 and P-2 (section 3.1, figure 4): all triangles are
//! real, and the lower hull is kept beside the advancing front.
//!
//! A point event whose projection falls on the front is that of the sweep. Beyond an end of the front, or above
//! it, come the cases that P-1 and P-2 are there to avoid:
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
//! Why it is right: the hull is convex and `p` is not in it, so the sides that `p` has strictly outside
//! follow each other from `end` down. With `p` they make triangles. If there is none, `p` lies above the line of
//! the last side or on it, and the front at `end` lies above that line. So the corner between `inner`, `end` and
//! `p` turns strictly inward, and it is closed. After either case every side of front and hull has a triangle.
//!
//! The first triangle: Žalik distinguishes six cases. Here the vertices up to the first one off the line of the
//! first two are swept with P-1 and P-2. The front is filled to its hull, and then the artificial triangles go.
//! They come back when the points are triangulated, because the edges and the result are made with them.
//!
//! Cost: that of the sweep. A point event beyond an end costs one orientation test more than the hull sides that
//! it sees; all together they are no more than the vertices.

use std::cmp::Ordering::Less;

use super::super::state::{NewVertex, Sweep};
use crate::error::Error;
use crate::front::Way;
use crate::ids::{OpenId, VertexId};
use crate::mesh::Side;
use crate::probe::Probe;
use crate::scalar::Scalar;
use crate::trace::Why;

/// A side of the lower hull.
#[derive(Clone, Copy, Debug)]
struct HullSide {
    lower: VertexId,
    upper: VertexId,
    /// What its triangle borders on.
    open: OpenId,
}

/// The lower hull left and right of the lowest vertex; the last sides end at the ends of the front.
#[derive(Debug, Default)]
struct LowerHull {
    left: Vec<HullSide>,
    right: Vec<HullSide>,
}

impl LowerHull {
    fn beside(&mut self, way: Way) -> &mut Vec<HullSide> {
        match way {
            Way::Left => &mut self.left,
            Way::Right => &mut self.right,
        }
    }
}

impl<S: Scalar, P: Probe> Sweep<'_, S, P> {
    /// Sweeps the points, and then inserts the edges; afterwards the hull is complete. Returns how many vertices
    /// lie within it: all, or none if they all lie on one line.
    pub(in crate::sweep) fn sweep_without_artificial(&mut self) -> Result<usize, Error> {
        let n = self.fabric.signs.vertices.len();
        let Some(off_line) = self.begin_off_line() else {
            return Ok(0);
        };
        let first = off_line.index() + 1;
        for v in (1..first).map(VertexId::at) {
            self.point_event(v);
        }
        self.fill_front(self.end(Way::Left), self.end(Way::Right), Why::Hull);
        let artificial = self.fabric.signs.artificial;
        let mut hull = self.take_lower_hull();
        for v in (first..n).map(VertexId::at) {
            let p = self.new_vertex(v);
            let (left, is_above) = self.segment_under(p);
            if left == artificial.left || is_above && left == self.end(Way::Left) {
                self.beside_front(p, Way::Left, &mut hull);
            } else if self.front.next(left) == artificial.right {
                self.beside_front(p, Way::Right, &mut hull);
            } else {
                self.add_above(p, left, is_above);
            }
            self.apply_heuristics(p);
        }
        self.complete_hull();
        self.enclose_lower_hull(&hull);
        self.insert_all()?;
        Ok(n)
    }

    /// The last real node of the front.
    fn end(&self, way: Way) -> VertexId {
        let artificial = self.fabric.signs.artificial;
        match way {
            Way::Left => self.front.next(artificial.left),
            Way::Right => self.front.prev(artificial.right),
        }
    }

    /// The lower hull of what has been swept, once the artificial triangles are removed.
    fn take_lower_hull(&mut self) -> LowerHull {
        let mut hull = LowerHull::default();
        for ghost in self.lower_ghosts() {
            let [a, b] = self.fabric.ends(ghost);
            let mesh = &mut self.fabric.mesh;
            let open = mesh.add_open();
            mesh.connect(mesh.across(ghost), Side::open(open));
            mesh.retire(ghost.triangle());
            let way = if b < a { Way::Left } else { Way::Right };
            let [lower, upper] = [a.min(b), a.max(b)];
            hull.beside(way).push(HullSide { lower, upper, open });
        }
        // The ghosts run down on the left.
        hull.left.reverse();
        hull
    }

    /// Adds `p`, which lies beyond the end of the front or above it.
    fn beside_front(&mut self, p: NewVertex, way: Way, hull: &mut LowerHull) {
        let sides = hull.beside(way);
        let end = self.end(way);
        let open = self.fabric.mesh.add_open();
        // Segments of the front bear the number of their left end.
        let (before, segment) = match way {
            Way::Left => (self.fabric.signs.artificial.left, p.id),
            Way::Right => (end, end),
        };
        self.put_on_front(p, before);
        let mut spoke = Side::open(OpenId::segment(segment));
        let mut lower = end;
        while let Some(&side) = sides.last()
            && self.sees(p.id, way, side)
        {
            sides.pop();
            lower = side.lower;
            let [behind, new] = [self.fabric.mesh.below(side.open), Side::open(open)];
            let (vertices, across) = match way {
                Way::Left => ([p.id, lower, side.upper], [behind, spoke, new]),
                Way::Right => ([p.id, side.upper, lower], [behind, new, spoke]),
            };
            let t = self.fabric.make(vertices, across, Why::Point);
            self.fabric.legalize_fan(t, p.near, vertices[2]);
            spoke = self.fabric.mesh.below(open);
        }
        if lower == end {
            self.close_end(p, way, end, open);
        }
        sides.push(HullSide {
            lower,
            upper: p.id,
            open,
        });
    }

    /// Whether `p` has a side of the hull strictly outside.
    fn sees(&mut self, p: VertexId, way: Way, side: HullSide) -> bool {
        let [from, to] = match way {
            Way::Left => [side.upper, side.lower],
            Way::Right => [side.lower, side.upper],
        };
        self.fabric.orient2d([from, to, p]) == Less
    }

    /// Closes the corner at `end`, which was the end of the front and is now below it; the triangle borders on
    /// `open`.
    fn close_end(&mut self, p: NewVertex, way: Way, end: VertexId, open: OpenId) {
        let inner = match way {
            Way::Left => self.front.next(end),
            Way::Right => self.front.prev(end),
        };
        let below = |v| self.fabric.mesh.below(OpenId::segment(v));
        let segment = |v| Side::open(OpenId::segment(v));
        let (vertices, across) = match way {
            Way::Left => (
                [p.id, end, inner],
                [below(end), segment(p.id), Side::open(open)],
            ),
            Way::Right => (
                [p.id, inner, end],
                [below(inner), Side::open(open), segment(inner)],
            ),
        };
        let t = self.fabric.make(vertices, across, Why::Point);
        self.take_off_front(end);
        self.fabric.legalize_fan(t, p.near, vertices[2]);
    }

    /// Artificial triangles below the lower hull.
    fn enclose_lower_hull(&mut self, hull: &LowerHull) {
        // Counter-clockwise: down on the left, up on the right.
        let left = hull
            .left
            .iter()
            .rev()
            .map(|side| (side.upper, side.lower, side.open));
        let right = hull
            .right
            .iter()
            .map(|side| (side.lower, side.upper, side.open));
        let fabric = &mut self.fabric;
        let mut ghosts = |sides: &mut dyn Iterator<Item = (VertexId, VertexId, OpenId)>| {
            let mut ghosts: Vec<Side> = Vec::new();
            for (a, b, open) in sides {
                let ghost = fabric.add_ghost(a, b);
                fabric.mesh.connect(ghost, fabric.mesh.below(open));
                if let Some(&before) = ghosts.last() {
                    fabric.join_ghosts(before, ghost);
                }
                ghosts.push(ghost);
            }
            ghosts
        };
        let [left, right] = [ghosts(&mut { left }), ghosts(&mut { right })];
        let last = self.end(Way::Right);
        self.close_lower_hull(&left, &right, VertexId::new(0), last);
    }
}

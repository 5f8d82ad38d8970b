//! The triangles that edges will pierce once they have ended.
//!
//! An edge that has begun and not ended is no edge of the window yet: it may meet others at vertices to come. Inserting
//! it later takes out the triangles that it pierces and no others. So these wait, whatever their circles: a corridor
//! from the vertex where the edge is now, up to the front.
//!
//! ```text
//!                . the upper end, to come
//!     ----------/------------  the sweep line
//!      \  /\   / /\  /
//!       \/__\_/_/__\/
//!        \   /  \  /           the corridor: each triangle that the edge pierces
//!         \ / \  \/
//!          *   the vertex where the edge is
//! ```
//!
//! A vertex that lies on the edge ends the corridor of one piece and begins the next. The piece below it is an edge of
//! the next window: no vertex to come lies on it. The triangles on both sides of a piece wait for that too, since a final
//! triangle tells which of its sides are edges.
//!
//! An edge of a band may begin below its floor. A corridor then leads down from the lowest vertex on the edge too, or up
//! from the side of the hull by which the edge comes in, where no vertex is known to lie on it.
//!
//! Cost: a step for each triangle that is pierced, or lies around a vertex on the edge. Many edges might take the steps of
//! others again. So where the steps of a window exceed [`STEPS`] a triangle, all that is alive waits, with the hull.

use std::cmp::Ordering;

use super::swept::{Stars, Swept};
use super::window::sweep_order;
use sweep_cdt::scalar::{Scalar, orient2d};

/// So many steps the edges of a window may take, for each triangle of the window.
const STEPS: usize = 8;

/// An edge, or its part in one direction, that goes on beyond what is known.
pub(super) struct Path<'a, S> {
    pub(super) edge: u64,
    /// Two points of the line, in the direction of the walk.
    pub(super) line: [&'a [S; 2]; 2],
    /// The last vertex that is known to lie on it; without one, both points of the line lie beyond the hull.
    pub(super) start: Option<usize>,
}

/// What the paths of edges do to the triangulation of a window.
#[derive(Default)]
pub(super) struct Corridors {
    /// The triangles that are pierced, or lie along a piece; some of them more than once. `None`: all, since these would
    /// be too many steps.
    pub(super) held: Option<Vec<usize>>,
    /// The pieces between vertices that lie on an edge, and the edge.
    pub(super) pieces: Vec<([usize; 2], u64)>,
    /// For each path the last vertex on it; before that the first one, if none was known.
    pub(super) reached: Vec<[Option<usize>; 2]>,
}

/// Where a walk along an edge goes on.
enum Next {
    /// From a vertex on the edge.
    Vertex(usize),
    /// Beyond the hull.
    End,
}

/// Follows all paths.
pub(super) fn corridors<S: Scalar>(
    points: &[[S; 2]],
    swept: &Swept<'_>,
    paths: &[Path<'_, S>],
) -> Corridors {
    let mut found = Corridors {
        held: Some(Vec::new()),
        ..Corridors::default()
    };
    if paths.is_empty() {
        return found;
    }
    let stars = swept.stars();
    let has_entries = paths.iter().any(|path| path.start.is_none());
    let hull = if has_entries {
        swept.hull()
    } else {
        Vec::new()
    };
    let mut steps = STEPS * swept.len();
    let mut held = Vec::new();
    for path in paths {
        let mut walk = Walk {
            points,
            swept,
            stars: &stars,
            line: path.line,
            held: &mut held,
            steps: &mut steps,
        };
        let mut next = path.start.map_or_else(|| walk.enter(&hull), Next::Vertex);
        let (mut first, mut last) = (None, None);
        while let Next::Vertex(v) = next {
            match last {
                Some(at) => found.pieces.push(([at, v], path.edge)),
                None => first = Some(v),
            }
            last = Some(v);
            next = walk.step(v);
        }
        let first = first.filter(|_| path.start.is_none());
        found.reached.push([first, last]);
    }
    found.held = (steps > 0).then_some(held);
    found
}

struct Walk<'a, S> {
    points: &'a [[S; 2]],
    swept: &'a Swept<'a>,
    stars: &'a Stars<'a>,
    line: [&'a [S; 2]; 2],
    held: &'a mut Vec<usize>,
    /// How many steps are left.
    steps: &'a mut usize,
}

impl<S: Scalar> Walk<'_, S> {
    /// Takes a step, if one is left.
    fn can_step(&mut self) -> bool {
        *self.steps = self.steps.saturating_sub(1);
        *self.steps > 0
    }

    /// On which side of the line a vertex lies.
    fn turn(&self, v: usize) -> Ordering {
        orient2d(self.line[0], self.line[1], &self.points[v])
    }

    /// Whether the walk meets the vertex `u` before `v`, both on its line.
    fn is_ahead(&self, v: usize, u: usize) -> bool {
        let [from, to] = self.line;
        sweep_order(&self.points[u], &self.points[v]) == sweep_order(from, to)
    }

    /// From beyond the hull to the first vertex.
    fn enter(&mut self, hull: &[(usize, usize)]) -> Next {
        let mut first: Option<usize> = None;
        for &(triangle, side) in hull {
            if !self.can_step() {
                return Next::End;
            }
            let corners = self.swept.triangle(triangle);
            let [left, right] = [1, 2].map(|i| corners[(side + i) % 3]);
            match (self.turn(left), self.turn(right)) {
                (Ordering::Greater, Ordering::Less) => {
                    return self.pierce(triangle, (side + 2) % 3);
                }
                (Ordering::Equal, _) if first.is_none_or(|v| self.is_ahead(v, left)) => {
                    first = Some(left);
                }
                _ => {}
            }
        }
        first.map_or(Next::End, Next::Vertex)
    }

    /// From a vertex on the edge to the next one.
    fn step(&mut self, at: usize) -> Next {
        let mut along = None;
        for (triangle, corner) in self.stars.star(at) {
            if !self.can_step() {
                return Next::End;
            }
            let corners = self.swept.triangle(triangle);
            let [p, q] = [1, 2].map(|i| corners[(corner + i) % 3]);
            let is_on = |v: usize| self.turn(v).is_eq() && self.is_ahead(v, at);
            if let Some(v) = [p, q].into_iter().find(|&v| is_on(v)) {
                self.held.push(triangle);
                along = Some(v);
            } else if self.turn(p).is_lt() && self.turn(q).is_gt() {
                self.held.push(triangle);
                let beyond = self.across(triangle, corner);
                return beyond.map_or(Next::End, |(next, right)| self.pierce(next, right));
            }
        }
        along.map_or(Next::End, Next::Vertex)
    }

    /// The triangle across a side by which the edge leaves, and in it the corner that is the side's right end.
    fn across(&self, t: usize, side: usize) -> Option<(usize, usize)> {
        let next = self.swept.neighbor(t, side)?;
        let right = self.swept.triangle(t)[(side + 1) % 3];
        let corners = self.swept.triangle(next);
        let right = corners.iter().position(|&v| v == right);
        Some((next, right.unwrap_or(0)))
    }

    /// Through a triangle, by the side with this right end, and the triangles beyond, to the next vertex.
    fn pierce(&mut self, first: usize, of_right: usize) -> Next {
        let (mut t, mut right) = (first, of_right);
        loop {
            self.held.push(t);
            if !self.can_step() {
                return Next::End;
            }
            // Counter-clockwise come the right end, the apex, the left end.
            let apex = (right + 1) % 3;
            let corner = self.swept.triangle(t)[apex];
            let side = match self.turn(corner) {
                Ordering::Equal => return Next::Vertex(corner),
                // The apex is left: the edge leaves between it and the right end, opposite the left end.
                Ordering::Greater => (apex + 1) % 3,
                Ordering::Less => right,
            };
            match self.across(t, side) {
                Some(beyond) => (t, right) = beyond,
                None => return Next::End,
            }
        }
    }
}

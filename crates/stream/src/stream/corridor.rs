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
//! Cost: a step for each triangle that is pierced, or lies around a vertex on the edge. Many edges that begin at one
//! vertex, or pierce the same triangles, would take these steps again and again. So where the steps of a window exceed
//! [`STEPS`] a triangle, all that is alive waits, with the sides of the hull.

use super::swept::{Stars, Swept};
use super::window::{Pending, Window, sweep_order};
use sweep_cdt::scalar::{Scalar, orient2d};

/// So many steps the edges of a window may take, for each triangle of the window.
const STEPS: usize = 8;

/// What the pending edges of a window do to its triangulation.
#[derive(Default)]
pub(super) struct Corridors {
    /// The triangles that are pierced, or lie along a piece; some of them more than once. `None`: all, since these would
    /// be too many steps.
    pub(super) held: Option<Vec<usize>>,
    /// The pieces between vertices that lie on an edge, and the edge.
    pub(super) pieces: Vec<([usize; 2], u64)>,
    /// The last vertex on each edge, in the order of [`Window::pending`].
    pub(super) reached: Vec<usize>,
}

/// Where a walk along an edge goes on.
enum Next {
    /// From a vertex on the edge.
    Vertex(usize),
    /// Beyond the hull.
    End,
}

/// Follows all pending edges.
pub(super) fn corridors<S: Scalar + Clone>(window: &Window<S>, swept: &Swept<'_>) -> Corridors {
    let mut found = Corridors {
        held: Some(Vec::new()),
        ..Corridors::default()
    };
    let mut edges = window.pending().peekable();
    if edges.peek().is_none() {
        return found;
    }
    let stars = swept.stars();
    let mut steps = STEPS * swept.len();
    let mut held = Vec::new();
    for (end, Pending { from, edge }) in edges {
        let mut walk = Walk {
            window,
            swept,
            stars: &stars,
            end,
            held: &mut held,
            steps: &mut steps,
        };
        let mut at = from;
        while let Next::Vertex(v) = walk.step(at) {
            found.pieces.push(([at, v], edge));
            at = v;
        }
        found.reached.push(at);
    }
    found.held = (steps > 0).then_some(held);
    found
}

struct Walk<'a, S> {
    window: &'a Window<S>,
    swept: &'a Swept<'a>,
    stars: &'a Stars<'a>,
    /// The upper end.
    end: &'a [S; 2],
    held: &'a mut Vec<usize>,
    /// How many steps are left.
    steps: &'a mut usize,
}

impl<S: Scalar + Clone> Walk<'_, S> {
    /// Takes a step, if one is left.
    fn can_step(&mut self) -> bool {
        *self.steps = self.steps.saturating_sub(1);
        *self.steps > 0
    }

    /// From a vertex on the edge to the next one.
    fn step(&mut self, at: usize) -> Next {
        let points = &self.window.points;
        let from = &points[at];
        let turn = |v: usize| orient2d(from, self.end, &points[v]);
        let mut along = None;
        for (triangle, corner) in self.stars.star(at) {
            if !self.can_step() {
                return Next::End;
            }
            let corners = self.swept.triangle(triangle);
            let [p, q] = [1, 2].map(|i| corners[(corner + i) % 3]);
            let is_ahead = |v: usize| turn(v).is_eq() && sweep_order(from, &points[v]).is_lt();
            if let Some(v) = [p, q].into_iter().find(|&v| is_ahead(v)) {
                self.held.push(triangle);
                along = Some(v);
            } else if turn(p).is_lt() && turn(q).is_gt() {
                return self.pierce(at, triangle, corner);
            }
        }
        along.map_or(Next::End, Next::Vertex)
    }

    /// From a vertex on the edge through a triangle, and the triangles beyond, to the next vertex.
    fn pierce(&mut self, at: usize, first: usize, opposite: usize) -> Next {
        let points = &self.window.points;
        let (mut t, mut side) = (first, opposite);
        loop {
            self.held.push(t);
            if !self.can_step() {
                return Next::End;
            }
            let Some(next) = self.swept.neighbor(t, side) else {
                return Next::End;
            };
            let corners = self.swept.triangle(t);
            let right = corners[(side + 1) % 3];
            let beyond = self.swept.triangle(next);
            // The side seen from beyond begins at its left end.
            let of_right = beyond.iter().position(|&v| v == right).unwrap_or(0);
            let apex = (of_right + 1) % 3;
            match orient2d(&points[at], self.end, &points[beyond[apex]]) {
                std::cmp::Ordering::Equal => {
                    self.held.push(next);
                    return Next::Vertex(beyond[apex]);
                }
                // The apex is left: the edge leaves between it and the right end, opposite the left end.
                std::cmp::Ordering::Greater => side = (apex + 1) % 3,
                std::cmp::Ordering::Less => side = of_right,
            }
            t = next;
        }
    }
}

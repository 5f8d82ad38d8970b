//! Traversal of an edge (section 3.4.2, figures 11 to 14): the triangles it pierces, and where it runs above the front.
//!
//! From a vertex the edge leaves into one of the triangles around it (figure 11) or, if the vertex is on the front,
//! into the gap above the front. It passes from triangle to triangle; it may leave through a front segment, run above
//! the front, and enter the triangles again. A *part* of the edge ends at the first vertex on it.
//!
//! ```text
//!    upper --.__                            A mixed edge event (figure 14). The dots are the edge, the
//!      ` .      `-- a                       lines are the front; triangles lie below the front. The
//!          ` .       \                      edge pierces triangles below the front from upper to a.
//!              ` .    \           d         It leaves them across the segment a-b. The traversal then
//!                  ` . \  gap    / \        follows the front, which runs below the edge from b to c.
//!                      `\.      /   \       The segment c-d rises above the edge: the edge enters the
//!                        \ ` . /     \      triangles again and ends at lower. The front from a to d
//!                         b   /` .    \     is a pocket, which is filled before the edge is inserted.
//!                          `-c     ` . lower
//! ```
//!
//! Why it is right: every step is decided by the exact side of one vertex. The front is x-monotone and the lower end
//! lies on it or under it, so a walk below the edge comes to a vertex on or above the edge. Artificial triangles lie
//! outside the convex hull and are never pierced. If a constrained side is in the way, two input edges cross.
//!
//! Cost: the degree of the first vertex, and one test for each triangle pierced or node passed. Differs from the paper:
//! the traversal changes nothing. The edge event fills the pockets found and traverses the edge again.

use alloc::vec::Vec;
use core::cmp::Ordering::{Equal, Greater, Less};

use super::Sweep;
use super::contradiction::inexact_scalar;
use crate::front::Direction;
use crate::ids::{BorderId, TriangleId, VertexId};
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use crate::trace::Event;

/// A part of an edge: to the first vertex on it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    /// The vertex where the part ends.
    pub(super) end: VertexId,
    /// A half-edge opposite the vertex where the part starts.
    pub(super) start: HalfEdge,
    /// The side that the part is already, if any; otherwise it pierces triangles or pockets.
    pub(super) present: Option<HalfEdge>,
}

/// What a traversal has found.
#[derive(Clone, Copy, Debug)]
pub(super) enum Traversal {
    Part(Part),
    /// The edge pierces more triangles than it may.
    TooMany,
}

/// Both vertices of a constrained side that the edge would cross.
pub(super) type CrossedSide = [VertexId; 2];

/// The triangles, sides and pockets in the way of a part.
#[derive(Debug, Default)]
pub(super) struct Traversed {
    /// The pierced triangles, from the upper end down.
    pub(super) pierced: Vec<TriangleId>,
    /// The pierced triangles' sides on the border of the left pseudo-polygon, from the upper end down.
    pub(super) left: Vec<HalfEdge>,
    /// The sides on the border of the pseudo-polygon right of the part.
    pub(super) right: Vec<HalfEdge>,
    /// For each pocket under the part its first and last node, left one first.
    pub(super) pockets: Vec<[VertexId; 2]>,
    /// The sides that edges with one upper end are already, so that nothing is in their way.
    pub(super) present: Vec<HalfEdge>,
    /// The most triangles that the part may pierce.
    most: usize,
}

impl Traversed {
    pub(super) fn begin_part(&mut self, most: usize) {
        self.most = most;
        self.pierced.clear();
        self.left.clear();
        self.right.clear();
    }
}

/// How an edge leaves a vertex.
#[derive(Clone, Copy, Debug)]
pub(super) enum Departure {
    Along(Part),
    /// Into a triangle, across its side opposite the vertex.
    Into(HalfEdge),
    Above,
}

/// How far a traversal has come.
enum Place {
    /// Entering a triangle across this side of it.
    HalfEdge(HalfEdge),
    /// Above the front, after crossing the segment between these nodes; both are the start of a part that begins there.
    Front([VertexId; 2]),
    /// At the vertex that ends the part.
    End(VertexId),
    TooMany,
}

impl<P: Probe> Sweep<'_, P> {
    /// Follows the edge from `from` towards `to` to the next vertex on it: down, or up if the hull is complete. `around`,
    /// a side opposite `from`, moves to where the edge leaves.
    pub(super) fn traverse(
        &mut self,
        from: VertexId,
        to: VertexId,
        around: &mut HalfEdge,
    ) -> Result<Traversal, CrossedSide> {
        let most = self.waiting.most(self.delaunay.mesh.len());
        self.traversed.begin_part(most);
        let mut place = match self.departure([from, to], *around) {
            Departure::Along(part) => {
                *around = part.start;
                return Ok(Traversal::Part(part));
            }
            Departure::Into(side) => {
                *around = side;
                self.enter(side)?
            }
            Departure::Above => Place::Front([from, from]),
        };
        let start = *around;
        loop {
            place = match place {
                Place::HalfEdge(side) => self.pass_triangle([from, to], side)?,
                Place::Front(ends) => self.pass_front([from, to], ends)?,
                Place::End(end) => {
                    return Ok(Traversal::Part(Part {
                        end,
                        start,
                        present: None,
                    }));
                }
                Place::TooMany => return Ok(Traversal::TooMany),
            }
        }
    }

    /// The side opposite `v`, a node of the front, of the leftmost triangle there.
    pub(super) fn leftmost(&self, v: VertexId) -> HalfEdge {
        let segment = BorderId::segment(self.front.prev(v));
        self.delaunay.mesh.border_twin(segment).next()
    }

    /// The end of an edge from which a turn over triangles comes sooner to where the edge leaves. Returns that end, the
    /// other one, and the side opposite that end of the triangle into which, or along which, the edge leaves. The hull
    /// is complete.
    ///
    /// Both turns begin anew with twice as many triangles until one comes there. So many edges at one vertex do not turn
    /// around it each time: in a plane graph the smaller degrees of the ends of all edges sum to O(n).
    pub(super) fn nearer_departure(&mut self, ends: [VertexId; 2]) -> ([VertexId; 2], HalfEdge) {
        let around = ends.map(|v| self.side_opposite(v));
        let mut most = self.delaunay.tuning.first_turn;
        loop {
            for ([from, to], around) in [(ends, around[0]), ([ends[1], ends[0]], around[1])] {
                match self.depart([from, to], around, most) {
                    Some(Departure::Along(Part { start: side, .. }) | Departure::Into(side)) => {
                        return ([from, to], side);
                    }
                    Some(Departure::Above) => inexact_scalar(),
                    None => {}
                }
            }
            if most > self.delaunay.mesh.len() {
                inexact_scalar();
            }
            most *= 2;
        }
    }

    /// Turns counter-clockwise around `from` to where the edge leaves towards `to` (figure 11).
    #[inline(always)]
    pub(super) fn departure(&mut self, ends: [VertexId; 2], around: HalfEdge) -> Departure {
        // No vertex has more triangles around it than there are.
        let most = self.delaunay.mesh.len();
        match self.depart(ends, around, most) {
            Some(departure) => departure,
            None => inexact_scalar(),
        }
    }

    /// Turns around `from` to where the edge leaves, over `most` triangles at most.
    #[inline(always)]
    fn depart(
        &mut self,
        [from, to]: [VertexId; 2],
        around: HalfEdge,
        most: usize,
    ) -> Option<Departure> {
        let mut at = around;
        // The side of the edge that `a` is on, if the triangle before has tested it.
        let mut known = None;
        for _ in 0..most {
            let [_, a, b] = self.delaunay.mesh.around(at);
            let mut sides = [Equal; 2];
            // For `a` and for `b`: the side between `from` and it.
            let spokes = [(a, at.prev()), (b, at.next())];
            for (i, (v, spoke)) in spokes.into_iter().enumerate() {
                sides[i] = match known.take() {
                    Some(side) => side,
                    None => self.delaunay.side([from, to], v),
                };
                // A vertex on the line lies on the edge, or behind `from`.
                if sides[i] == Equal && (v < from) == (to < from) {
                    return Some(Departure::Along(Part {
                        end: v,
                        start: at,
                        present: Some(spoke),
                    }));
                }
            }
            if sides == [Less, Greater] {
                return Some(Departure::Into(at));
            }
            // On to the next triangle; at the right end of the front, on from the left.
            let twin = self.delaunay.mesh.twin(at.next());
            (at, known) = if twin.is_border() {
                (self.leftmost(from), None)
            } else {
                (twin.next(), Some(sides[1]))
            };
            if at == around {
                return Some(Departure::Above);
            }
        }
        None
    }

    /// Pierces the first triangle, across its side opposite the vertex where the part starts.
    fn enter(&mut self, side: HalfEdge) -> Result<Place, CrossedSide> {
        self.traversed.pierced.push(side.triangle());
        self.traversed.right.push(side.prev());
        self.traversed.left.push(side.next());
        self.leave(side)
    }

    fn leave(&mut self, side: HalfEdge) -> Result<Place, CrossedSide> {
        let twin = self.delaunay.mesh.twin(side);
        if twin.is_constrained() {
            let [_, a, b] = self.delaunay.mesh.around(side);
            Err([a, b])
        } else if twin.is_border() {
            let left = twin.border_id().left_end();
            Ok(Place::Front([left, self.front.next(left)]))
        } else {
            Ok(Place::HalfEdge(twin))
        }
    }

    /// Passes one triangle, entered across its side `entry`.
    fn pass_triangle(
        &mut self,
        part: [VertexId; 2],
        entry: HalfEdge,
    ) -> Result<Place, CrossedSide> {
        let v = self.delaunay.mesh.opposite(entry);
        let side = self.delaunay.side(part, v);
        if self.traversed.pierced.len() == self.traversed.most {
            if self.traversed.most == self.delaunay.mesh.len() {
                inexact_scalar();
            }
            return Ok(Place::TooMany);
        }
        // The edge leaves across one of the other two sides; the third borders on a pseudo-polygon. At the end both do.
        self.traversed.pierced.push(entry.triangle());
        if side != Less {
            self.traversed.left.push(entry.prev());
        }
        if side != Greater {
            self.traversed.right.push(entry.next());
        }
        match side {
            Equal => Ok(Place::End(v)),
            Greater => self.leave(entry.next()),
            Less => self.leave(entry.prev()),
        }
    }

    /// Follows the front below the edge, from where the edge left it to where it meets it again.
    fn pass_front(
        &mut self,
        part: [VertexId; 2],
        segment: [VertexId; 2],
    ) -> Result<Place, CrossedSide> {
        self.delaunay.report(|name| Event::Switch {
            to_front: true,
            segment: segment.map(name),
        });
        // Of the ends of a crossed segment the first one on the way is above the edge, the other below.
        let [left, right] = segment;
        let (direction, node, below) = match self.delaunay.predicates.compare_x(part[0], part[1]) {
            Less => (Direction::Right, left, Less),
            _ => (Direction::Left, right, Greater),
        };
        let in_order = |first, second| match direction {
            Direction::Right => [first, second],
            Direction::Left => [second, first],
        };
        let mut last;
        let mut at = self.front.neighbor(node, direction);
        let side = loop {
            last = at;
            at = self.front.neighbor(at, direction);
            assert!(
                !self.delaunay.predicates.is_artificial(at),
                "the front passes over the lower end"
            );
            let side = self.delaunay.side(part, at);
            if side != below {
                break side;
            }
        };
        self.traversed.pockets.push(in_order(node, at));
        if side == Equal {
            return Ok(Place::End(at));
        }

        // The front rises above the edge: the edge enters the triangles across this segment.
        let crossed = in_order(last, at);
        self.delaunay.report(|name| Event::Switch {
            to_front: false,
            segment: crossed.map(name),
        });
        let entry = self
            .delaunay
            .mesh
            .border_twin(BorderId::segment(crossed[0]));
        if entry.is_constrained() {
            Err([last, at])
        } else {
            Ok(Place::HalfEdge(entry))
        }
    }
}

//! Traversal along an edge (section 3.4.2, figures 11 to 14): which triangles it pierces, and where it
//! runs above the front.
//!
//! From a vertex the edge leaves into one of the triangles around it (figure 11) or, where the vertex
//! is on the front, into the gap above. Then it passes from triangle to triangle, out through a front
//! segment, along the front, and back in, until it meets a vertex: its lower end or one that lies on
//! it. That is one *part* of the edge; the next one starts at that vertex.
//!
//! ```text
//!              upper end                 A mixed edge event (figure 14): the edge pierces triangles
//!             /|\                        down to a, leaves them across the front segment a-b,
//!            / | \      b . . . pocket   follows the front below it from b to c, and pierces
//!           /__|__\    /  ` . . . . d    triangles again from the segment c-d on. The front
//!          a . . . `. /        ` . /     between a and d is a pocket, to be filled first.
//!                    b           c
//! ```
//!
//! Why it is right: every step is decided by the exact side of one vertex. The front is x-monotone and
//! the lower end lies on it or under it, so a walk below the edge comes to a vertex on or above it.
//! Artificial triangles lie outside the convex hull and are never pierced. A fixed edge in the way
//! means that the input edges cross.
//!
//! Cost: the degree of the first vertex, and one test a pierced triangle or node passed.
//!
//! Differs from the paper: it only looks. The pockets that it finds under the edge are filled first,
//! so that then the edge runs through triangles alone.

use std::cmp::Ordering::{Equal, Greater, Less};

use super::obstacles::{Crossed, Part};
use super::state::Sweep;
use crate::front::{FrontSearch, Way};
use crate::ids::{OpenId, VertexId};
use crate::mesh::Side;
use crate::probe::Probe;
use crate::scalar::Scalar;
use crate::trace::Event;

/// How an edge leaves a vertex.
enum Departure {
    /// Along a side that is there already.
    Along(Part),
    /// Into a triangle, across this side of it, opposite the vertex.
    Into(Side),
    /// Above the front.
    Above,
}

/// Where a part is on its way.
enum Place {
    /// Entering a triangle across this side of it.
    Side(Side),
    /// Above the front, out across the segment between these nodes or away from the one twice named.
    Front([VertexId; 2]),
    /// At the vertex that ends it; a side opposite to that.
    End(VertexId, Side),
}

impl<S: Scalar, F: FrontSearch, P: Probe> Sweep<'_, S, F, P> {
    /// Follows the edge from vertex `from` towards `to`, which is lower, to the next vertex on it.
    /// `around` is a side opposite `from`, of any triangle there.
    pub(super) fn traverse(
        &mut self,
        from: VertexId,
        to: VertexId,
        around: Side,
    ) -> Result<Part, Crossed> {
        self.obstacles.begin_part();
        let (start, mut place) = match self.depart(from, to, around) {
            Departure::Along(part) => return Ok(part),
            Departure::Into(side) => (side, self.enter(side)?),
            Departure::Above => (around, Place::Front([from, from])),
        };
        loop {
            place = match place {
                Place::Side(side) => self.pass_triangle([from, to], side)?,
                Place::Front(ends) => self.pass_front([from, to], ends)?,
                Place::End(end, onward) => {
                    return Ok(Part {
                        end,
                        start,
                        onward,
                        present: None,
                    });
                }
            }
        }
    }

    /// The side opposite `v`, which is on the front, of the leftmost triangle there.
    pub(super) fn leftmost(&self, v: VertexId) -> Side {
        let segment = OpenId::segment(self.front.prev(v));
        self.fabric.mesh.below(segment).next()
    }

    /// Turns counter-clockwise around `from` to where the edge leaves (figure 11).
    fn depart(&mut self, from: VertexId, to: VertexId, around: Side) -> Departure {
        let mut at = around;
        // On which side of the edge the first vertex of the triangle is, known from the one before.
        let mut known = None;
        loop {
            let [_, a, b] = self.fabric.mesh.around(at);
            let mut sides = [Equal; 2];
            // Sides from `from` to `a` and to `b`, and those opposite `a` and `b`.
            let spokes = [(a, at.prev(), at.next()), (b, at.next(), at.prev())];
            for (i, (v, spoke, onward)) in spokes.into_iter().enumerate() {
                sides[i] = match known.take() {
                    Some(side) => side,
                    None => self.fabric.side([from, to], v),
                };
                // A vertex on the line is ahead if it is lower, as the edge's end is.
                if sides[i] == Equal && v < from {
                    return Departure::Along(Part {
                        end: v,
                        start: at,
                        onward,
                        present: Some(spoke),
                    });
                }
            }
            if sides == [Less, Greater] {
                return Departure::Into(at);
            }
            let across = self.fabric.mesh.across(at.next());
            (at, known) = if across.is_open() {
                (self.leftmost(from), None)
            } else {
                (across.next(), Some(sides[1]))
            };
            if at == around {
                return Departure::Above;
            }
        }
    }

    /// Pierces the first triangle; `side` is the one opposite the vertex where the part starts.
    fn enter(&mut self, side: Side) -> Result<Place, Crossed> {
        self.obstacles.pierced.push(side.triangle());
        self.obstacles.right.push(side.prev());
        self.obstacles.left.push(side.next());
        self.leave(side)
    }

    /// Leaves a triangle across one of its sides.
    fn leave(&mut self, side: Side) -> Result<Place, Crossed> {
        let across = self.fabric.mesh.across(side);
        if across.is_fixed() {
            let [_, a, b] = self.fabric.mesh.around(side);
            Err([a, b])
        } else if across.is_open() {
            let left = across.open_id().left_end();
            Ok(Place::Front([left, self.front.next(left)]))
        } else {
            Ok(Place::Side(across))
        }
    }

    /// Passes one triangle, entered across its side `entry`.
    fn pass_triangle(&mut self, part: [VertexId; 2], entry: Side) -> Result<Place, Crossed> {
        let v = self.fabric.mesh.opposite(entry);
        let side = self.fabric.side(part, v);
        // The side beyond `v` is a border of the left or right pseudo-polygon; at the end of the part
        // there is one on either side.
        self.obstacles.pierced.push(entry.triangle());
        if side != Less {
            self.obstacles.left.push(entry.prev());
        }
        if side != Greater {
            self.obstacles.right.push(entry.next());
        }
        match side {
            Equal => Ok(Place::End(v, entry)),
            Greater => self.leave(entry.next()),
            Less => self.leave(entry.prev()),
        }
    }

    /// Follows the front below the edge, from where the edge left it to where it meets it again.
    fn pass_front(
        &mut self,
        part: [VertexId; 2],
        segment: [VertexId; 2],
    ) -> Result<Place, Crossed> {
        self.fabric.report(|name| Event::Switch {
            to_front: true,
            segment: segment.map(name),
        });
        // Of a segment's ends the first one on the way lies above the edge, the other one below.
        let [left, right] = segment;
        let (way, node, below) = match self.fabric.signs.compare_x(part[0], part[1]) {
            Less => (Way::Right, left, Less),
            _ => (Way::Left, right, Greater),
        };
        let in_order = |first, second| match way {
            Way::Right => [first, second],
            Way::Left => [second, first],
        };
        let mut last;
        let mut at = self.front.beside(node, way);
        let side = loop {
            last = at;
            at = self.front.beside(at, way);
            assert!(
                !self.fabric.signs.is_artificial(at),
                "the front passes over the lower end"
            );
            let side = self.fabric.side(part, at);
            if side != below {
                break side;
            }
        };
        self.obstacles.pockets.push(in_order(node, at));
        if side == Equal {
            return Ok(Place::End(at, self.leftmost(at)));
        }

        // The front rises above the edge: back into the triangles across this segment.
        let crossed = in_order(last, at);
        self.fabric.report(|name| Event::Switch {
            to_front: false,
            segment: crossed.map(name),
        });
        let entry = self.fabric.mesh.below(OpenId::segment(crossed[0]));
        if entry.is_fixed() {
            Err([last, at])
        } else {
            Ok(Place::Side(entry))
        }
    }
}

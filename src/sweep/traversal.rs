//! Traversal along an edge (section 3.4.2, figures 11 to 14): which triangles it pierces, and where it
//! runs above the front.
//!
//! From a vertex the edge leaves into one of the triangles around it (figure 11) or, where the vertex
//! is on the front, into the gap above. Then it passes from triangle to triangle, out through a front
//! segment, along the front, and back in, until it meets a vertex: its lower end or one that lies on
//! it. That is one *part* of the edge; the next one starts at that vertex.
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

use super::Sweep;
use crate::Scalar;
use crate::front::FrontSearch;
use crate::mesh::{Link, TriangleId, VertexId, next, prev};
use crate::probe::Probe;
use crate::trace::Event;

/// A triangle at one of its corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Spoke {
    pub(super) triangle: TriangleId,
    pub(super) corner: u32,
}

/// What one part of an edge runs into.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    /// The vertex where it ends.
    pub(super) end: VertexId,
    /// A triangle at the vertex where it starts.
    pub(super) start: Spoke,
    /// A triangle at the vertex where it ends.
    pub(super) onward: Spoke,
    /// The side that the part is, if it is there already; else triangles are pierced.
    pub(super) present: Option<Link>,
}

/// Both vertices of a fixed side that the edge would cross.
pub(super) type Crossed = [VertexId; 2];

/// A vertex beside the edge, and the pierced triangle's side from it to the next one.
pub(super) type Border = (VertexId, Link);

/// What the last part met.
#[derive(Debug, Default)]
pub(super) struct Traversal {
    pub(super) pierced: Vec<TriangleId>,
    /// The borders of the upper and lower pseudo-polygons, without the end of the part.
    pub(super) left: Vec<Border>,
    pub(super) right: Vec<Border>,
    /// The nodes between which the front runs below the edge, left one first; of all parts.
    pub(super) pockets: Vec<[VertexId; 2]>,
}

/// Where a part is on its way.
enum Place {
    /// Entering a triangle across a side.
    Side(Link),
    /// Above the front, out across the segment between these nodes or away from the one twice named.
    Front([VertexId; 2]),
    /// At the vertex that ends it.
    End(VertexId, Spoke),
}

impl<S: Scalar, F: FrontSearch, P: Probe> Sweep<'_, S, F, P> {
    /// Follows the edge from vertex `from` towards `to`, which is lower, to the next vertex on it.
    /// `around` is any triangle at `from`.
    pub(super) fn traverse(
        &mut self,
        from: VertexId,
        to: VertexId,
        around: Spoke,
    ) -> Result<Part, Crossed> {
        self.traversal.pierced.clear();
        self.traversal.left.clear();
        self.traversal.right.clear();
        let (start, mut place) = match self.first_triangle_pierced(from, to, around) {
            Departure::Along(part) => return Ok(part),
            Departure::Into(spoke) => (spoke, self.enter(from, spoke)?),
            Departure::Above => (around, Place::Front([from, from])),
        };
        loop {
            place = match place {
                Place::Side(link) => self.pass_triangle(from, to, link)?,
                Place::Front(ends) => self.pass_front(from, to, ends)?,
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

    /// The leftmost triangle at `v`, which is on the front.
    pub(super) fn leftmost(&self, v: VertexId) -> Spoke {
        let link = self.mesh.open(self.front.prev(v));
        Spoke {
            triangle: link.triangle(),
            corner: next(link.corner()),
        }
    }

    /// Turns counter-clockwise around `from` to where the edge leaves (figure 11).
    fn first_triangle_pierced(&mut self, from: VertexId, to: VertexId, around: Spoke) -> Departure {
        let mut spoke = around;
        let mut a_side = None;
        loop {
            let Spoke { triangle, corner } = spoke;
            let record = *self.mesh.get(triangle);
            let (a, b) = (record.vertex(next(corner)), record.vertex(prev(corner)));
            let side = match a_side {
                Some(side) => side,
                None => self.predicates.side(from, to, a),
            };
            // A vertex on the line is ahead if it is lower, as the edge's end is.
            if side == Equal && a < from {
                let present = Some(Link::new(triangle, prev(corner)));
                let onward = Spoke {
                    triangle,
                    corner: next(corner),
                };
                return Departure::Along(Part {
                    end: a,
                    start: spoke,
                    onward,
                    present,
                });
            }
            let b_side = self.predicates.side(from, to, b);
            if side == Less && b_side == Greater {
                return Departure::Into(spoke);
            }
            if b_side == Equal && b < from {
                let present = Some(Link::new(triangle, next(corner)));
                let onward = Spoke {
                    triangle,
                    corner: prev(corner),
                };
                return Departure::Along(Part {
                    end: b,
                    start: spoke,
                    onward,
                    present,
                });
            }
            let link = record.link(next(corner));
            (spoke, a_side) = if link.is_open() {
                (self.leftmost(from), None)
            } else {
                (
                    Spoke {
                        triangle: link.triangle(),
                        corner: next(link.corner()),
                    },
                    Some(b_side),
                )
            };
            if spoke == around {
                return Departure::Above;
            }
        }
    }

    /// Pierces the first triangle, which `spoke` names at vertex `from`.
    fn enter(&mut self, from: VertexId, spoke: Spoke) -> Result<Place, Crossed> {
        let Spoke {
            triangle: t,
            corner,
        } = spoke;
        let (right, left) = (next(corner), prev(corner));
        self.traversal.pierced.push(t);
        self.traversal.right.push((from, Link::new(t, left)));
        self.traversal.left.push((from, Link::new(t, right)));
        let record = self.mesh.get(t);
        let ends = [record.vertex(right), record.vertex(left)];
        self.traversal.right.push((ends[0], Link::OUTSIDE));
        self.traversal.left.push((ends[1], Link::OUTSIDE));
        self.leave(t, corner)
    }

    /// Leaves triangle `t` across the side opposite `corner`.
    fn leave(&mut self, t: TriangleId, corner: u32) -> Result<Place, Crossed> {
        let record = self.mesh.get(t);
        let link = record.link(corner);
        if link.is_fixed() {
            return Err([record.vertex(next(corner)), record.vertex(prev(corner))]);
        }
        if !link.is_open() {
            return Ok(Place::Side(link));
        }
        Ok(Place::Front([
            link.number(),
            self.front.next(link.number()),
        ]))
    }

    /// Passes one triangle, entered across the side that `link` leads to.
    fn pass_triangle(
        &mut self,
        from: VertexId,
        to: VertexId,
        link: Link,
    ) -> Result<Place, Crossed> {
        let (t, corner) = (link.triangle(), link.corner());
        let v = self.mesh.get(t).vertex(corner);
        let (left, right) = (next(corner), prev(corner));
        let traversal = &mut self.traversal;
        traversal.pierced.push(t);
        let side = self.predicates.side(from, to, v);
        if side != Less
            && let Some(border) = traversal.left.last_mut()
        {
            border.1 = Link::new(t, right);
        }
        if side != Greater
            && let Some(border) = traversal.right.last_mut()
        {
            border.1 = Link::new(t, left);
        }
        match side {
            Equal => Ok(Place::End(
                v,
                Spoke {
                    triangle: t,
                    corner,
                },
            )),
            Greater => {
                traversal.left.push((v, Link::OUTSIDE));
                self.leave(t, left)
            }
            Less => {
                traversal.right.push((v, Link::OUTSIDE));
                self.leave(t, right)
            }
        }
    }

    /// Follows the front below the edge, from where the edge left it to where it meets it again.
    fn pass_front(
        &mut self,
        from: VertexId,
        to: VertexId,
        [left, right]: [VertexId; 2],
    ) -> Result<Place, Crossed> {
        self.tell(|name| Event::Switch {
            to_front: true,
            segment: [left, right].map(name),
        });
        // Of a segment's ends the first one on the way lies above the edge, the other one below.
        let is_rightward = self.predicates.compare_x(from, to) == Less;
        let below = if is_rightward { Less } else { Greater };
        let node = if is_rightward { left } else { right };
        let mut last;
        let mut at = if is_rightward {
            self.front.next(node)
        } else {
            self.front.prev(node)
        };
        let side = loop {
            last = at;
            at = if is_rightward {
                self.front.next(at)
            } else {
                self.front.prev(at)
            };
            assert!(
                !self.predicates.is_artificial(at),
                "the front passes over the lower end"
            );
            let side = self.predicates.side(from, to, at);
            if side != below {
                break side;
            }
        };
        self.traversal
            .pockets
            .push(if is_rightward { [node, at] } else { [at, node] });
        if side == Equal {
            return Ok(Place::End(at, self.leftmost(at)));
        }
        let crossed = if is_rightward { [last, at] } else { [at, last] };
        self.tell(|name| Event::Switch {
            to_front: false,
            segment: crossed.map(name),
        });
        let link = self.mesh.open(crossed[0]);
        if link.is_fixed() {
            Err([last, at])
        } else {
            Ok(Place::Side(link))
        }
    }
}

/// How an edge leaves a vertex.
enum Departure {
    /// Along a side that is there already.
    Along(Part),
    /// Into the triangle named at the vertex.
    Into(Spoke),
    /// Above the front.
    Above,
}

//! A half-edge: a side of a triangle, as the triangle and the corner opposite in a single number.
//!
//! ```text
//!                   corner i                   HalfEdge i of triangle t is opposite corner i. It runs
//!                      /\                      counter-clockwise, from corner next(i) to prev(i).
//!                     /  \
//!       side.prev()  / t  \  side.next()       side.next() starts where this side ends, at corner
//!                   /      \                   prev(i); it is opposite corner next(i).
//!                  /________\
//!    corner next(i)   -->    corner prev(i)
//!                    side i
//! ```
//!
//! The twin of a half-edge is the `HalfEdge` of the neighbouring triangle. Two more bits mark the special cases.
//! *Constrained*: the side is a constrained edge, which is never flipped (section 3.4.2). *Border*: there is no
//! triangle, and the number is that of a border half-edge: a segment of the advancing front, or a side of an empty
//! polygon. So one comparison answers whether a side must stay ([`HalfEdge::cannot_flip`]).

use crate::ids::{BorderId, TriangleId};

/// A side of a triangle, or a border half-edge; see the figure above.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct HalfEdge(u32);

const CONSTRAINED: u32 = 1 << 31;
const BORDER: u32 = 1 << 30;

/// The corner after `i`, `(i + 1) % 3`: from a table of two bits for each `i`, since a division costs more. For the
/// unused 3 it is 0, so that the result needs no bounds check.
#[inline(always)]
pub(crate) const fn next(i: u32) -> u32 {
    (0b00_10_01 >> (2 * (i & 3))) & 3
}

/// The corner before `i`, `(i + 2) % 3`; see [`next`].
#[inline(always)]
pub(crate) const fn prev(i: u32) -> u32 {
    (0b01_00_10 >> (2 * (i & 3))) & 3
}

impl HalfEdge {
    /// The twin of a side that never gets a neighbour: the lower side of the first triangle.
    pub(crate) const NOTHING: HalfEdge = HalfEdge(u32::MAX);
    /// The twin of a border half-edge below which there is no triangle yet.
    pub(crate) const NO_TRIANGLE: HalfEdge = HalfEdge(u32::MAX - 1);
    /// In a result: the twin of a side on the convex hull.
    pub(crate) const HULL: HalfEdge = HalfEdge(BORDER);
    /// How many triangles can be numbered, and how many border half-edges.
    pub(crate) const LIMIT: usize = 1 << 28;

    /// The half-edge of `triangle` opposite its corner `corner`.
    #[inline(always)]
    pub(crate) fn new(triangle: TriangleId, corner: u32) -> HalfEdge {
        HalfEdge(triangle.number() << 2 | corner)
    }

    #[inline(always)]
    pub(crate) fn border(side: BorderId) -> HalfEdge {
        // The mask tells the compiler that the half-edge is neither constrained nor nothing.
        HalfEdge(BORDER | side.number() & (BORDER - 1))
    }

    #[inline(always)]
    pub(crate) fn triangle(self) -> TriangleId {
        TriangleId::new((self.0 & !CONSTRAINED) >> 2)
    }

    /// The corner (0, 1 or 2) opposite the half-edge.
    #[inline(always)]
    pub(crate) fn corner(self) -> u32 {
        self.0 & 3
    }

    #[inline(always)]
    pub(crate) fn next(self) -> HalfEdge {
        HalfEdge(self.0 & !(CONSTRAINED | 3) | next(self.corner()))
    }

    #[inline(always)]
    pub(crate) fn prev(self) -> HalfEdge {
        HalfEdge(self.0 & !(CONSTRAINED | 3) | prev(self.corner()))
    }

    #[inline(always)]
    pub(crate) fn is_border(self) -> bool {
        self.0 & BORDER != 0
    }

    #[inline(always)]
    pub(crate) fn is_constrained(self) -> bool {
        self.0 & CONSTRAINED != 0
    }

    /// Whether the side cannot be flipped: on the border, or constrained.
    #[inline(always)]
    pub(crate) fn cannot_flip(self) -> bool {
        self.0 >= BORDER
    }

    /// The half-edge when all triangles are numbered higher by `triangles`.
    #[cfg(feature = "parallel")]
    #[inline(always)]
    pub(crate) fn moved(self, triangles: u32) -> HalfEdge {
        if self.is_border() {
            self
        } else {
            HalfEdge(self.0 + (triangles << 2))
        }
    }

    #[inline(always)]
    pub(crate) fn border_id(self) -> BorderId {
        BorderId::new(self.0 & (BORDER - 1))
    }

    #[inline(always)]
    pub(crate) fn constrain(self) -> HalfEdge {
        HalfEdge(self.0 | CONSTRAINED)
    }

    /// The half-edge, constrained if `other` is.
    #[inline(always)]
    pub(crate) fn constrained_as(self, other: HalfEdge) -> HalfEdge {
        HalfEdge(self.0 | other.0 & CONSTRAINED)
    }

    #[inline(always)]
    pub(crate) fn unconstrained(self) -> HalfEdge {
        HalfEdge(self.0 & !CONSTRAINED)
    }
}

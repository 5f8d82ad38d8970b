//! A side of a triangle as a half-edge: a triangle and one of its corners, the one opposite, in a single
//! number.
//!
//! ```text
//!                   corner i                   Side i of triangle t is opposite corner i. It runs
//!                      /\                      counter-clockwise, from corner next(i) to prev(i).
//!                     /  \
//!       side.prev()  / t  \  side.next()       side.next() starts where this side ends, at corner
//!                   /      \                   prev(i); it is opposite corner next(i).
//!                  /________\
//!    corner next(i)   -->    corner prev(i)
//!                    side i
//! ```
//!
//! What lies across a side is a `Side` too: that of the neighbouring triangle. Two more bits mark the two
//! special cases. *Fixed*: it is a constrained edge, which is never flipped (section 3.4.2). *Open*:
//! there is no triangle across. Then the number is that of an open side: a segment of the advancing
//! front, or a side that borders on an empty polygon. So one comparison answers whether a side must stay
//! ([`Side::is_blocked`]).

use crate::ids::{OpenId, TriangleId};

/// A side of a triangle, or an open side; see the figure above.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Side(u32);

const FIXED: u32 = 1 << 31;
const OPEN: u32 = 1 << 30;

/// The corner after `i`, counter-clockwise: `(i + 1) % 3`, from a table of two bits for each `i`, since
/// a division costs more. For the unused 3 it is 0, so that the result needs no bounds check.
#[inline(always)]
pub(crate) const fn next(i: u32) -> u32 {
    (0b00_10_01 >> (2 * (i & 3))) & 3
}

/// The corner before `i`, counter-clockwise: `(i + 2) % 3`; see [`next`].
#[inline(always)]
pub(crate) const fn prev(i: u32) -> u32 {
    (0b01_00_10 >> (2 * (i & 3))) & 3
}

impl Side {
    /// Across a side that never gets a triangle: the lower side of the first triangle.
    pub(crate) const NOTHING: Side = Side(u32::MAX);
    /// In place of the triangle below an open side: there is none yet.
    pub(crate) const NO_TRIANGLE: Side = Side(u32::MAX - 1);
    /// In a result: across a side on the convex hull.
    pub(crate) const HULL: Side = Side(OPEN);
    /// How many triangles can be numbered; there are as many numbers for open sides.
    pub(crate) const LIMIT: usize = 1 << 28;

    /// The side of `triangle` opposite its corner `corner`.
    #[inline(always)]
    pub(crate) fn new(triangle: TriangleId, corner: u32) -> Side {
        Side(triangle.number() << 2 | corner)
    }

    #[inline(always)]
    pub(crate) fn open(side: OpenId) -> Side {
        // Masked, so that the compiler knows that it is neither fixed nor nothing.
        Side(OPEN | side.number() & (OPEN - 1))
    }

    #[inline(always)]
    pub(crate) fn triangle(self) -> TriangleId {
        TriangleId::new((self.0 & !FIXED) >> 2)
    }

    /// The corner (0, 1 or 2) opposite the side.
    #[inline(always)]
    pub(crate) fn corner(self) -> u32 {
        self.0 & 3
    }

    /// The next side of the same triangle, counter-clockwise.
    #[inline(always)]
    pub(crate) fn next(self) -> Side {
        Side(self.0 & !(FIXED | 3) | next(self.corner()))
    }

    /// The side of the same triangle before this one, counter-clockwise.
    #[inline(always)]
    pub(crate) fn prev(self) -> Side {
        Side(self.0 & !(FIXED | 3) | prev(self.corner()))
    }

    #[inline(always)]
    pub(crate) fn is_open(self) -> bool {
        self.0 & OPEN != 0
    }

    #[inline(always)]
    pub(crate) fn is_fixed(self) -> bool {
        self.0 & FIXED != 0
    }

    /// Open or fixed: the side cannot be flipped.
    #[inline(always)]
    pub(crate) fn is_blocked(self) -> bool {
        self.0 >= OPEN
    }

    /// The same side where all triangles are numbered higher by so much.
    #[cfg(feature = "parallel")]
    #[inline(always)]
    pub(crate) fn moved(self, triangles: u32) -> Side {
        if self.is_open() {
            self
        } else {
            Side(self.0 + (triangles << 2))
        }
    }

    /// Which open side.
    #[inline(always)]
    pub(crate) fn open_id(self) -> OpenId {
        OpenId::new(self.0 & (OPEN - 1))
    }

    #[inline(always)]
    pub(crate) fn fix(self) -> Side {
        Side(self.0 | FIXED)
    }

    /// This side, fixed if `other` is.
    #[inline(always)]
    pub(crate) fn fixed_as(self, other: Side) -> Side {
        Side(self.0 | other.0 & FIXED)
    }

    #[inline(always)]
    pub(crate) fn unfixed(self) -> Side {
        Side(self.0 & !FIXED)
    }
}

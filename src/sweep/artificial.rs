//! The artificial points P-1 and P-2 (section 3.3, figure 6).
//!
//! The paper puts them a factor alpha outside the data, and any finite place makes some hull edge wrong.
//! Here they are directions: P-1 is (-1, 0), P-2 is (+1, -epsilon), the two ends of a sweep line that
//! is tilted just enough to order equal y.
//!
//! ```text
//!            P0
//!           /  \              the first triangle: the lower hull of the swept vertices is where
//!         /      \            artificial triangles border on real ones
//!    P-1 <--------> P-2
//! ```
//!
//! They are vertices of ordinary triangles; tests with one of them are decided by rule:
//! - a side whose opposite vertex is artificial stays, since no circle reaches out so far;
//! - a side with an artificial end is flipped exactly if the three real vertices around it turn left
//!   strictly, for then its real end is not on the lower hull. So the lower hull is exact at every
//!   moment, and the walk of figure 15b and c happens on the way;
//! - an edge, which runs down from its upper end, has P-1 to its right and P-2 to its left.
//!
//! Their approximated coordinates are infinite and NaN, so that every filter fails on them and the hot
//! path need not know them.
//!
//! Differs from the paper: its P-1 and P-2 have coordinates, and P-2's are misprinted.

use std::cmp::Ordering;

use crate::ids::VertexId;

/// The two artificial points; their ranks follow that of the last vertex.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Artificial {
    /// P-1.
    pub(super) left: VertexId,
    /// P-2.
    pub(super) right: VertexId,
}

/// What stands for the approximated coordinates of P-1 and P-2.
pub(super) const APPROX: [[f64; 2]; 2] = [[f64::NEG_INFINITY, f64::NAN], [f64::INFINITY, f64::NAN]];

impl Artificial {
    /// The artificial points beside this many vertices.
    pub(super) fn beside(vertices: usize) -> Artificial {
        Artificial {
            left: VertexId::at(vertices),
            right: VertexId::at(vertices + 1),
        }
    }

    /// Whether `v` is one of them. True for every number above them too.
    #[inline(always)]
    pub(super) fn contains(self, v: VertexId) -> bool {
        v >= self.left
    }

    /// The order by x of two vertices of which one is artificial: P-1 before and P-2 after all.
    /// `Equal` if neither is.
    pub(super) fn compare_x(self, a: VertexId, b: VertexId) -> Ordering {
        let place = |v| i8::from(v == self.right) - i8::from(v == self.left);
        place(a).cmp(&place(b))
    }

    /// On which side of a downward ray artificial `v` is: the ray points below the tilted sweep line.
    pub(super) fn side_of_ray(self, v: VertexId) -> Ordering {
        if v == self.left {
            Ordering::Less
        } else {
            Ordering::Greater
        }
    }
}

//! The artificial points P-1 and P-2 (section 3.3, figure 6).
//!
//! The paper gives them coordinates outside the data, at a distance alpha. Whatever the finite position, some input
//! gets a wrong hull. Here the points are directions: P-1 is (-1, 0) and P-2 is (+1, -epsilon), the two ends of a sweep
//! line that is tilted just enough to order equal y.
//!
//! ```text
//!            v0                The first triangle, of the first vertex swept, P-1 and P-2. Later the
//!           /  \               artificial triangles lie below the real ones, and the sides between
//!         /      \             real and artificial triangles are the lower hull of the vertices
//!    P-1 <--------> P-2        swept so far.
//! ```
//!
//! P-1 and P-2 are vertices of ordinary triangles. Rules decide the tests with one of them:
//! - a side whose opposite vertex is artificial stays, since no circle reaches out so far;
//! - a side with an artificial end is flipped exactly if the three real vertices around it turn strictly left, for then
//!   its real end is not on the lower hull. So the lower hull is always exact, without the walk of figures 15b and c;
//! - an edge, which runs down from its upper end, has P-1 on its right and P-2 on its left.
//!
//! The approximations of P-1 and P-2 are infinite or NaN. So the filter never decides such a test, and its users need
//! no check. Differs from the paper: there P-1 and P-2 have coordinates (those of P-2 are misprinted).

use core::cmp::Ordering;

use crate::ids::VertexId;

/// The two artificial points; their ranks follow that of the last vertex.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Artificial {
    pub(super) left: VertexId,
    pub(super) right: VertexId,
}

/// The approximations of P-1 and P-2.
pub(super) const APPROX: [[f64; 2]; 2] = [[f64::NEG_INFINITY, f64::NAN], [f64::INFINITY, f64::NAN]];

impl Artificial {
    pub(super) fn beside(vertices: usize) -> Artificial {
        Artificial {
            left: VertexId::at(vertices),
            right: VertexId::at(vertices + 1),
        }
    }

    /// Whether `v` is artificial, or a number above the artificial points.
    #[inline(always)]
    pub(super) fn contains(self, v: VertexId) -> bool {
        v >= self.left
    }

    /// The order by x of two vertices, if one is artificial: P-1 before and P-2 after all. `Equal` if neither is.
    pub(super) fn compare_x(self, a: VertexId, b: VertexId) -> Ordering {
        let place = |v| i8::from(v == self.right) - i8::from(v == self.left);
        place(a).cmp(&place(b))
    }

    /// The side of a downward ray on which `v`, P-1 or P-2, lies: P-1 is on its right and P-2 on its left.
    pub(super) fn side_of_ray(self, v: VertexId) -> Ordering {
        if v == self.left {
            Ordering::Less
        } else {
            Ordering::Greater
        }
    }
}

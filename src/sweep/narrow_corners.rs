//! Heuristic (i) of the point event (section 3.4.1, figure 9): narrow corners of the front beside the
//! new vertex are closed by further triangles.
//!
//! ```text
//!      p                         p             To the right of p: the angle at `corner` between p
//!       \                         \` .         and `far` is below pi/2, and p, corner, far turn left.
//!        \     far       ->        \   far     Their triangle covers `corner`, which leaves the front.
//!         \   /                     \  /       The next corner to test is `far`. To the left of p all
//!         corner                   corner      is mirrored.
//! ```
//!
//! Why it is right: angles, in plain floating point, only choose which corners to try. A triangle is made
//! only where an exact sign says that the corner turns inward, and it lies above the front, where nothing
//! is. First the outer sides of the new triangle's fan are legalized, then the spoke from `p` to `corner`.
//!
//! Cost: a test of the angle and one of the turn for each corner closed, and one more of each on either
//! side of `p`.
//!
//! Differs from the paper: angles are compared by dot products; [`Corners::Wide`] goes a little beyond
//! pi/2, and two settings go further, to compare with.

use std::cmp::Ordering::{self, Greater, Less};

use super::state::{NewVertex, Sweep};
use crate::front::Way;
use crate::ids::{OpenId, VertexId};
use crate::mesh::Side;
use crate::probe::Probe;
use crate::scalar::Scalar;
use crate::settings::Corners;
use crate::trace::Why;

/// Square of the cosine of 110 degrees.
const WIDE: f64 = 0.117;

/// Which obtuse corners may be closed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Obtuse {
    /// Whether the next one may be, and those after it.
    may_be: bool,
    may_all_be: bool,
    /// The square of the cosine of the least angle that may not be.
    squared_cosine: f64,
}

impl Obtuse {
    /// Those of a setting.
    #[inline(always)]
    pub(super) fn of(corners: Corners) -> Obtuse {
        let one = |may_be, squared_cosine| Obtuse {
            may_be,
            may_all_be: false,
            squared_cosine,
        };
        match corners {
            Corners::Off | Corners::RightAngle => one(false, WIDE),
            Corners::Wide => one(true, WIDE),
            #[cfg(feature = "comparison")]
            Corners::OneUpTo(sixteenths) => one(true, f64::from(sixteenths) / 16.0),
            #[cfg(feature = "comparison")]
            Corners::AllUpTo(sixteenths) => Obtuse {
                may_all_be: true,
                ..one(true, f64::from(sixteenths) / 16.0)
            },
        }
    }
}

/// An angle at a corner, in plain floating point: its two arms and their dot product.
struct Angle {
    arms: [[f64; 2]; 2],
    dot: f64,
}

impl Angle {
    /// That at a corner between two ends.
    #[inline(always)]
    fn at([cx, cy]: [f64; 2], ends: [[f64; 2]; 2]) -> Angle {
        let arms = ends.map(|[x, y]| [x - cx, y - cy]);
        let [[ax, ay], [bx, by]] = arms;
        Angle {
            arms,
            dot: ax * bx + ay * by,
        }
    }

    /// Whether it is below pi/2.
    #[inline(always)]
    fn is_acute(&self) -> bool {
        self.dot > 0.0
    }

    /// Whether it is below the angle whose cosine has this square. Only for angles that are not acute.
    #[inline(always)]
    fn is_below(&self, squared_cosine: f64) -> bool {
        let [[ax, ay], [bx, by]] = self.arms;
        self.dot * self.dot < squared_cosine * (ax * ax + ay * ay) * (bx * bx + by * by)
    }
}

impl<S: Scalar, P: Probe> Sweep<'_, S, P> {
    /// Closes the corners right and left of `p` while they are narrow.
    #[inline(always)]
    pub(super) fn close_narrow_corners(&mut self, p: NewVertex, obtuse: Obtuse) {
        self.close_narrow(p, Way::Right, obtuse);
        self.close_narrow(p, Way::Left, obtuse);
    }

    /// The same for angles that are compared with the others. It is compiled apart, so that these are constants.
    #[cfg(feature = "comparison")]
    #[cold]
    #[inline(never)]
    pub(super) fn close_corners_to_compare(&mut self, p: NewVertex, corners: Corners) {
        self.close_narrow_corners(p, Obtuse::of(corners));
    }

    #[inline(always)]
    fn close_narrow(&mut self, p: NewVertex, way: Way, mut obtuse: Obtuse) {
        let mut corner = self.front.beside(p.id, way);
        let mut near_corner = self.fabric.signs.approx(corner);
        // One obtuse corner on either side. Otherwise each new vertex beside a long straight stretch
        // would close many corners that the next one opens again.
        loop {
            let far = self.front.beside(corner, way);
            // An artificial end has no corner; the number beyond an end counts as artificial too.
            if self.fabric.signs.is_artificial(far) {
                break;
            }
            let near_far = self.fabric.signs.approx(far);
            let angle = Angle::at(near_corner, [p.near, near_far]);
            if !angle.is_acute() {
                if !obtuse.may_be || !angle.is_below(obtuse.squared_cosine) {
                    break;
                }
                obtuse.may_be = obtuse.may_all_be;
            }
            // Seen from the corner, as the angle is.
            let (turn, doubles) = ([far, p.id, corner], [near_far, p.near, near_corner]);
            if self.fabric.orient2d_near(turn, doubles) != inward(way) {
                break;
            }
            self.close_corner(p, way, [corner, far], Why::NarrowCorner);
            (corner, near_corner) = (far, near_far);
        }
    }

    /// Covers the node `corner` beside `p`: a triangle of `p`, that node and the one after it, `far`.
    #[inline(always)]
    pub(super) fn close_corner(
        &mut self,
        p: NewVertex,
        way: Way,
        [corner, far]: [VertexId; 2],
        why: Why,
    ) {
        // Segments bear the number of their left end. The outer one runs from `corner` to `far`, the
        // spoke from `p` to `corner`; the new segment runs from `p` to `far`.
        let below = |v| self.fabric.mesh.below(OpenId::segment(v));
        let open = |v| Side::open(OpenId::segment(v));
        let (vertices, across) = match way {
            Way::Right => (
                [p.id, corner, far],
                [below(corner), open(p.id), below(p.id)],
            ),
            Way::Left => ([p.id, far, corner], [below(far), below(corner), open(far)]),
        };
        let t = self.fabric.make(vertices, across, why);
        self.take_off_front(corner);
        let rightmost = self.fabric.legalize_fan(t, p.near, vertices[2]);
        let spoke = match way {
            Way::Right => Side::new(t, 2),
            Way::Left => Side::new(rightmost, 1),
        };
        self.fabric.legalize_side(spoke);
    }
}

/// The turn at a corner that leaves room for a triangle above it.
#[inline(always)]
fn inward(way: Way) -> Ordering {
    match way {
        Way::Right => Greater,
        Way::Left => Less,
    }
}

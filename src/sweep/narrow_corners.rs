//! Heuristic (i) of the point event (section 3.4.1, figure 9): narrow corners beside the new vertex are closed.
//!
//! ```text
//!      p                         p             To the right of p: the angle at `corner` between p
//!       \                         \` .         and `far` is below pi/2, and p, corner, far turn left.
//!        \     far       ->        \   far     Their triangle covers `corner`, which leaves the front.
//!         \   /                     \  /       The next corner to test is `far`. To the left of p all
//!         corner                   corner      is mirrored.
//! ```
//!
//! Why it is right: angles, in plain floating point, only choose which corners to try. A triangle is made only where an
//! exact sign says that the corner turns inward, and it lies above the front, where nothing is. Cost: a test of the angle and one of
//! the turn for each corner closed, and one more of each on either side of `p`.
//!
//! Differs from the paper: angles are compared by dot products; [`Corners::Wide`] goes a little beyond pi/2, and two
//! settings go further, to compare with.

use core::cmp::Ordering::{self, Greater, Less};

use super::{NewVertex, Sweep};
use crate::front::Direction;
use crate::observe::probe::Probe;
use crate::settings::Corners;
use crate::trace::Why;

/// Square of the cosine of 110 degrees.
const WIDE: f64 = 0.117;

/// Which obtuse corners may be closed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Obtuse {
    /// Whether the next obtuse corner may be closed, and whether all later ones may.
    may_be: bool,
    may_all_be: bool,
    /// The square of the cosine of the least angle that is too wide.
    squared_cosine: f64,
}

impl Obtuse {
    /// The obtuse corners that a setting allows.
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

/// The angle at a corner, in plain floating point: its two arms and their dot product.
struct Angle {
    arms: [[f64; 2]; 2],
    dot: f64,
}

impl Angle {
    #[inline(always)]
    fn at([cx, cy]: [f64; 2], ends: [[f64; 2]; 2]) -> Angle {
        let arms = ends.map(|[x, y]| [x - cx, y - cy]);
        let [[ax, ay], [bx, by]] = arms;
        Angle {
            arms,
            dot: ax * bx + ay * by,
        }
    }

    #[inline(always)]
    fn is_acute(&self) -> bool {
        self.dot > 0.0
    }

    /// Whether an angle that is not acute is below the one whose squared cosine is given.
    #[inline(always)]
    fn is_below(&self, squared_cosine: f64) -> bool {
        let [[ax, ay], [bx, by]] = self.arms;
        self.dot * self.dot < squared_cosine * (ax * ax + ay * ay) * (bx * bx + by * by)
    }
}

impl<P: Probe> Sweep<'_, P> {
    /// Closes the corners right and left of `p` while they are narrow.
    #[inline(always)]
    pub(super) fn close_narrow_corners(&mut self, p: NewVertex, obtuse: Obtuse) {
        self.close_narrow(p, Direction::Right, obtuse);
        self.close_narrow(p, Direction::Left, obtuse);
    }

    /// Closes corners by a setting of comparisons. A function of its own, so that the usual settings are constants.
    #[cfg(feature = "comparison")]
    #[cold]
    #[inline(never)]
    pub(super) fn close_corners_to_compare(&mut self, p: NewVertex, corners: Corners) {
        self.close_narrow_corners(p, Obtuse::of(corners));
    }

    #[inline(always)]
    fn close_narrow(&mut self, p: NewVertex, direction: Direction, mut obtuse: Obtuse) {
        let mut corner = self.front.neighbor(p.id, direction);
        let mut approx_corner = self.delaunay.predicates.approx(corner);
        // One obtuse corner on either side. Otherwise each new vertex beside a long straight piece of the front would
        // close many corners that the next vertex opens again.
        loop {
            let far = self.front.neighbor(corner, direction);
            // An artificial end has no corner; the number beyond an end counts as artificial too.
            if self.delaunay.predicates.is_artificial(far) {
                break;
            }
            let approx_far = self.delaunay.predicates.approx(far);
            let angle = Angle::at(approx_corner, [p.approx, approx_far]);
            if !angle.is_acute() {
                if !obtuse.may_be || !angle.is_below(obtuse.squared_cosine) {
                    break;
                }
                obtuse.may_be = obtuse.may_all_be;
            }
            // Seen from the corner, as the angle is.
            let (turn, doubles) = ([far, p.id, corner], [approx_far, p.approx, approx_corner]);
            if self.delaunay.orient2d_approx(turn, doubles) != inward(direction) {
                break;
            }
            self.close_corner(p, direction, [corner, far], Why::NarrowCorner);
            (corner, approx_corner) = (far, approx_far);
        }
    }
}

/// The turn at a corner that leaves room for a triangle above it.
#[inline(always)]
fn inward(direction: Direction) -> Ordering {
    match direction {
        Direction::Right => Greater,
        Direction::Left => Less,
    }
}

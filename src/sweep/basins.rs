//! Heuristic (ii) of the point event (section 3.4.1, figure 10): basins are filled.
//!
//! ```text
//!    p                              .-     Beside p the front falls by more than 45 degrees over two
//!     \                          .-'       nodes, which is an angle of more than 3pi/4 with the upward
//!     rim . . . . . . . . . . .-'          vertical: a basin begins. Its `rim` is the node beside p. The
//!       \                   end            search walks down to the bottom, and up again to `end`, the
//!        x                .-'              last node that is not above the rim. The front from `rim`
//!         \            x-'                 to `end` is filled to its upper hull.
//!          bottom ---'
//! ```
//!
//! Why it is right: angles and heights, in plain floating point, only choose a stretch of the front. Exact
//! signs fill it to its upper hull ([`super::chain`]).
//!
//! Cost: the search passes at most [`BASIN_REACH`] nodes on its way down and as many on its way up: O(1).
//!
//! Differs from the paper: it does not say how far a basin is filled. Here it is the upper hull of the
//! stretch up to the height of the rim.

use super::state::Sweep;
use crate::front::Direction;
use crate::ids::VertexId;
use crate::probe::Probe;
use crate::scalar::Scalar;
use crate::trace::Why;

/// How many nodes the search for the bottom of a basin may pass, and again that for its other end.
const BASIN_REACH: usize = 32;

impl<S: Scalar, P: Probe> Sweep<'_, S, P> {
    /// Fills the basins that begin right and left of `p`.
    #[inline(always)]
    pub(super) fn fill_basins(&mut self, p: VertexId) {
        for direction in [Direction::Right, Direction::Left] {
            if self.falls_away(p, direction) {
                self.fill_basin(p, direction);
            }
        }
    }

    /// Whether the front falls from `p` over the next two nodes by more than 45 degrees. False if one
    /// of them is artificial.
    #[inline(always)]
    fn falls_away(&self, p: VertexId, direction: Direction) -> bool {
        let first = self.front.neighbor(p, direction);
        if self.delaunay.predicates.is_artificial(first) {
            return false;
        }
        let second = self.front.neighbor(first, direction);
        let [[px, py], [x, y]] = [p, second].map(|v| self.delaunay.predicates.approx(v));
        py - y > (px - x).abs()
    }

    /// Fills the basin that begins beside `p`.
    fn fill_basin(&mut self, p: VertexId, direction: Direction) {
        let rim = self.front.neighbor(p, direction);
        let top = self.height(rim);
        // Down to the bottom, then up again.
        let (mut at, mut y) = (rim, top);
        for is_falling in [true, false] {
            for _ in 0..BASIN_REACH {
                let beyond = self.front.neighbor(at, direction);
                let next_y = self.height(beyond);
                let goes_on = if is_falling {
                    next_y < y
                } else {
                    next_y > y && next_y <= top
                };
                // False for an artificial node, whose height is no number.
                if !goes_on {
                    break;
                }
                (at, y) = (beyond, next_y);
            }
        }
        let [from, to] = match direction {
            Direction::Right => [rim, at],
            Direction::Left => [at, rim],
        };
        self.fill_front(from, to, Why::Basin);
    }

    fn height(&self, v: VertexId) -> f64 {
        self.delaunay.predicates.approx(v)[1]
    }
}

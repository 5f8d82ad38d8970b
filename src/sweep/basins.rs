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
//! Why it is right: angles and heights, in plain floating point, only choose two nodes of the front. Exact signs fill
//! the front between them up to its upper hull ([`Delaunay::fill`](super::delaunay::Delaunay::fill)). Cost: the search
//! passes at most [`BASIN_REACH`] nodes on its way down and as many on its way up: O(1).

use super::Sweep;
use crate::front::Direction;
use crate::ids::VertexId;
use crate::observe::probe::Probe;
use crate::trace::Why;
use crate::tuning::BASIN_REACH;

impl<P: Probe> Sweep<'_, P> {
    #[inline(always)]
    pub(super) fn fill_basins(&mut self, p: VertexId) {
        for direction in [Direction::Right, Direction::Left] {
            if self.falls_away(p, direction) {
                self.fill_basin(p, direction);
            }
        }
    }

    /// Whether the front falls from `p` over the next two nodes by more than 45 degrees. False if one is artificial.
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

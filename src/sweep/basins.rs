//! Heuristic (ii) of the point event (section 3.4.1, figure 10): basins are filled.
//!
//! ```text
//!    p                          A basin begins beside p where the front falls from p by more than 45
//!     \                         degrees over two nodes: an angle of more than 3pi/4 with the
//!      rim            at        vertical. It is filled from its rim, the node beside p, down to the
//!        \         /            bottom and up again to the last node not above the rim.
//!         \   ___/
//!          bottom
//! ```
//!
//! Why it is right: angles and heights steer, in plain floating point; the stretch of the front is
//! filled to its upper hull by exact signs ([`super::chain`]).
//!
//! Cost: a basin is searched for at most [`BASIN_REACH`] nodes either way, so the search is O(1).
//!
//! Differs from the paper: a basin is filled as far up as its rim, to the upper hull of that stretch.

use super::state::Sweep;
use crate::front::{FrontSearch, Way};
use crate::ids::VertexId;
use crate::probe::Probe;
use crate::scalar::Scalar;
use crate::trace::Why;

/// How many nodes the search for the bottom of a basin, and that for its other end, may pass.
const BASIN_REACH: usize = 32;

impl<S: Scalar, F: FrontSearch, P: Probe> Sweep<'_, S, F, P> {
    /// Fills the basins that begin right and left of `p`.
    #[inline(always)]
    pub(super) fn fill_basins(&mut self, p: VertexId) {
        for way in [Way::Right, Way::Left] {
            if self.falls_away(p, way) {
                self.fill_basin(p, way);
            }
        }
    }

    /// Whether the front falls from `p` over the next two nodes by more than 45 degrees. False if one
    /// of them is artificial.
    #[inline(always)]
    fn falls_away(&self, p: VertexId, way: Way) -> bool {
        let first = self.front.beside(p, way);
        if self.fabric.signs.is_artificial(first) {
            return false;
        }
        let second = self.front.beside(first, way);
        let [[px, py], [x, y]] = [p, second].map(|v| self.fabric.signs.approx(v));
        py - y > (px - x).abs()
    }

    /// Fills the basin that begins beside `p`.
    fn fill_basin(&mut self, p: VertexId, way: Way) {
        let rim = self.front.beside(p, way);
        let top = self.height(rim);
        // Down to the bottom, then up again.
        let (mut at, mut y) = (rim, top);
        for is_falling in [true, false] {
            for _ in 0..BASIN_REACH {
                let beyond = self.front.beside(at, way);
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
        let [from, to] = match way {
            Way::Right => [rim, at],
            Way::Left => [at, rim],
        };
        let added = self.fill_front(from, to, Why::Basin);
        self.fabric.probe.count(|c| c.basin_triangles += added);
    }

    fn height(&self, v: VertexId) -> f64 {
        self.fabric.signs.approx(v)[1]
    }
}

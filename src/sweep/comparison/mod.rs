//! The algorithms that the paper compares its sweep with (section 4), on the same mesh, with the same signs and
//! counters. Divide and conquer is not among them: it is the net under the sweep
//! ([`super::divide_and_conquer`]).
//!
//! | the paper's | what | file |
//! |---|---|---|
//! | M-INC | randomized incremental insertion | [`incremental`] |
//! | F-S | Fortune's sweep line | [`fortune`], [`beach_line`] |
//! | section 3.1 | the sweep without artificial points | [`sweep_2005`] |
//!
//! Each triangulates the points. Then the edges are inserted one by one (Anglada 1997) by the code of the edge
//! event, in the order of the sweep. So the results are the same, and of several crossings the same is found.
//!
//! Points on one line have no triangle to begin with, and divide and conquer links them up.

mod beach_line;
mod fortune;
mod incremental;
mod sweep_2005;

use std::cmp::Ordering::Equal;

use super::fabric::Fabric;
use crate::ids::VertexId;
use crate::probe::Probe;
use crate::scalar::Scalar;

impl<S: Scalar, P: Probe> Fabric<'_, S, P> {
    /// The first vertex in sweep order that does not lie on the line of the first two, if there is one.
    fn first_off_line(&mut self) -> Option<VertexId> {
        let [a, b] = [0, 1].map(VertexId::new);
        let mut others = (2..self.signs.vertices.len()).map(VertexId::at);
        others.find(|&v| self.orient2d([a, b, v]) != Equal)
    }
}

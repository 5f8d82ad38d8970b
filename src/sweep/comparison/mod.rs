//! The algorithms that the paper compares its sweep with (section 4), on the same mesh, with the same predicates and
//! counters. Divide and conquer is not among them: it is the net under the sweep ([`super::divide_and_conquer`]).
//!
//! | the paper's | what | file |
//! |---|---|---|
//! | M-INC | randomized incremental insertion | [`incremental`] |
//! | F-S | Fortune's sweep line | [`fortune`], [`beach_line`] |
//! | section 3.1 | the sweep without artificial points | [`sweep_2005`] |
//!
//! Each algorithm triangulates the points. Then the code of the edge event inserts the edges one by one (Anglada 1997)
//! in sweep order. So the results are the same, and of several crossings the same one is found. Points on one line have
//! no triangle to begin with: divide and conquer links them up.

mod beach_line;
mod fortune;
mod incremental;
mod sweep_2005;

use core::cmp::Ordering::Equal;

use super::Sweep;
use super::delaunay::Delaunay;
use crate::error::Error;
use crate::ids::{TriangleId, VertexId};
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use crate::observe::recorder::Phase;

impl<P: Probe> Sweep<'_, P> {
    /// Begins the phase of sweeping, unless all vertices lie on one line. Returns the first vertex off the line.
    fn begin_off_line(&mut self) -> Option<VertexId> {
        let off_line = self.delaunay.first_off_line()?;
        self.delaunay.probe.begin(Phase::Sweeping);
        Some(off_line)
    }

    /// Removes the first triangle and its vertex on the front, for an algorithm that needs neither.
    fn clear(&mut self) {
        let n = self.delaunay.predicates.vertices.len();
        self.front.begin(n);
        self.delaunay.mesh.clear();
        self.delaunay.mesh.reset_borders(n + 2);
    }

    /// Inserts the edges where ghosts surround all vertices. For `start` see `hand_over`.
    fn finish_from_ghosts(&mut self, start: HalfEdge) -> Result<bool, Error> {
        self.hand_over(start);
        self.insert_all()?;
        Ok(true)
    }
}

impl<P: Probe> Delaunay<'_, P> {
    /// Legalizes all sides.
    fn legalize_all(&mut self) {
        for t in (0..self.mesh.len()).map(TriangleId::at) {
            // Each side from the lower-numbered of its two triangles.
            let sides = [0, 1, 2].map(|side| HalfEdge::new(t, side));
            let is_first = sides.map(|side| {
                let twin = self.mesh.twin(side);
                !twin.is_border() && twin.triangle() > t
            });
            let sides = sides.into_iter().zip(is_first);
            self.stack(sides.filter_map(|(side, is_first)| is_first.then_some(side)));
            self.legalize();
        }
    }

    /// The first vertex in sweep order that does not lie on the line of the first two, if there is one.
    fn first_off_line(&mut self) -> Option<VertexId> {
        let [a, b] = [0, 1].map(VertexId::new);
        let mut others = (2..self.predicates.vertices.len()).map(VertexId::at);
        others.find(|&v| self.orient2d([a, b, v]) != Equal)
    }
}

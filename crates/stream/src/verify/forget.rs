//! Forgetting: a vertex goes as soon as nothing that is right can still need it.
//!
//! Triangles are never kept. What may still come for a vertex v, and what is done about it:
//!
//! - *A triangle.* It has a corner at v as long as v is in no triangle, or a side there has one triangle (`open`). Once no
//!   side has, triangles go all the way round v, and one more would overlap them.
//! - *An edge that begins or ends at v.* Edges come before triangles at or above their lower ends. So those at v are
//!   known: v stays while one waits there for a side (`waiting`), or waits lower (`ends`).
//! - *An edge through v*, which may wait far below. It is known as well, but v need not stay for it: the sides that reach
//!   v from below and lead on in one line are joined to one *run*. An edge takes a run as it takes a side, since it
//!   neither begins nor ends at v. A side that nothing continues leads no edge past v, and goes with it.
//! - *An edge that must take a side at v*, for which the side has to be told apart (`unclaimed`): v stays.
//! - *A duplicate, or a triangle that names one.* Duplicates come before triangles go round v, and their numbers are
//!   forgotten with it.
//!
//! So only runs between vertices that are kept are kept, at most one for each direction at a vertex, whatever waits where.
//!
//! Cost: a pass over the runs at the vertex, each vertex once. Where no edge waits, no runs are kept.

use super::StreamVerifier;
use super::records::{Place, Towards, Vertex};
use sweep_cdt::scalar::{Scalar, orient2d};

impl<S: Scalar + Clone> StreamVerifier<S> {
    /// Forgets those of the vertices that may be closed now which are.
    pub(super) fn forget(&mut self) {
        while let Some(number) = self.loose.pop() {
            if self.is_closed(number)
                && let Some(vertex) = self.vertices.remove(number)
            {
                for duplicate in &vertex.duplicates {
                    self.duplicates.remove(duplicate);
                }
                self.join_runs(number, vertex);
            }
        }
    }

    /// Whether nothing that is right can need a corner of a triangle, but for edges that pass it.
    fn is_closed(&self, number: u64) -> bool {
        self.vertices.get(number).is_some_and(|vertex| {
            vertex.open == 0
                && vertex.unclaimed == 0
                && vertex.waiting.is_empty()
                && (self.ends.is_empty() || !self.ends.contains_key(&Place(vertex.point.clone())))
        })
    }

    /// Joins the runs that end at a forgotten vertex to those that lead on.
    fn join_runs(&mut self, number: u64, vertex: Vertex<S>) {
        let point = &vertex.point;
        let mut ups = vertex.up.into_values().peekable();
        for (down, low) in vertex.down {
            // Both go round counter-clockwise. What is right of the line from below is behind.
            let turn = |high: &[S; 2]| orient2d(&down.to, point, high);
            while ups.next_if(|up| turn(&up.point).is_lt()).is_some() {}
            let Some(up) = ups.next_if(|up| turn(&up.point).is_eq()) else {
                continue;
            };
            let Some(lower) = self.vertices.get_mut(low) else {
                continue;
            };
            let towards = Towards::new(&lower.point, point);
            let run = lower.up.get_mut(&towards);
            let Some(run) = run.filter(|run| run.high == number) else {
                continue;
            };
            let back = Towards::new(&up.point, point);
            (run.high, run.point) = (up.high, up.point);
            if let Some(high) = self.vertices.get_mut(up.high) {
                high.down.insert(back, low);
            }
        }
    }
}

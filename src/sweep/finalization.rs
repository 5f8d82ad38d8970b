//! Finalization (section 3.5, figure 15): the hull is completed and the artificial triangles are removed.
//!
//! The upper hull: one Graham scan ([`Delaunay::fill`](super::delaunay::Delaunay::fill)) fills the front from its first
//! to its last real node, the leftmost and the rightmost vertex (the upper ones of several). The lower hull needs no
//! filling: its sides are those between real and artificial triangles (for why see [`super::artificial`]). Following
//! the artificial triangles around P-1 and then around P-2 lists its vertices. Then these triangles are removed. The
//! others keep the ranks of their vertices; input indices are looked up when a triangle of the result is read.
//!
//! ```text
//!            .-'-.     .-'-.           The front from `first` to `last` is filled to the upper hull.
//!       first     `-.-'     `-last
//!       /   `-.             .-'  \      The lower hull is first, a, b, last. The artificial triangles
//!      /       a --------- b      \     follow it: first a P-1, a b P-1, then b P-2 P-1 at the turn,
//!     /  .--'   ___...---'  `--.   \    then b last P-2.
//!    P-1 <-----------------------> P-2
//! ```
//!
//! Cost: O(h) orientation tests for h nodes of the front. Removing the artificial triangles of a hull of h vertices
//! takes O(h log h) if it is small, otherwise O(h) and one bit for each triangle. No other triangle is looked at.
//!
//! Differs from the paper: the lower hull (figures 15b and c) needs no pass: sides to P-1 and P-2 are always legal.

use alloc::vec;
use alloc::vec::Vec;
use core::mem::take;

use super::Sweep;
use super::contradiction::inexact_scalar;
use crate::ids::{BorderId, TriangleId};
use crate::mesh::{HalfEdge, Triangle};
use crate::observe::probe::Probe;
use crate::observe::recorder::Phase;
use crate::trace::{Event, Why};
use crate::triangulation::Triangulation;
use crate::tuning::FEW_ARTIFICIAL;

impl<P: Probe> Sweep<'_, P> {
    /// Fills the front up to the upper hull.
    pub(super) fn complete_hull(&mut self) {
        self.delaunay.probe.begin(Phase::Finalization);
        self.delaunay.report(|_| Event::Finalization);
        let artificial = self.delaunay.predicates.artificial;
        let first = self.front.next(artificial.left);
        if first != artificial.right {
            let last = self.front.prev(artificial.right);
            self.fill_front(first, last, Why::Hull);
        }
    }

    /// Returns the triangulation, whose hull is complete.
    pub(super) fn finalize(&mut self) -> Triangulation {
        let bytes = self.heap_bytes();
        self.delaunay
            .probe
            .record(|r| r.stats.memory = r.stats.memory.max(bytes));
        let (mut hull, mut artificial) =
            (take(&mut self.lists.hull), take(&mut self.lists.artificial));
        hull.clear();
        artificial.clear();
        artificial.extend_from_slice(self.delaunay.mesh.unused());
        self.list_hull(&mut hull, &mut artificial);
        put_in_order(&mut artificial, self.delaunay.mesh.len());
        let mut triangles = self.delaunay.mesh.take_triangles();
        self.delaunay
            .probe
            .record(|r| r.survived(triangles.len(), &artificial));
        self.remove_artificial(&mut triangles, &artificial);
        self.delaunay.report(|_| Event::Finished {
            triangles: triangles.len(),
        });
        if triangles.is_empty() {
            hull.clear();
        }
        let result = Triangulation {
            hull,
            triangles,
            vertices: take(&mut self.delaunay.predicates.vertices.input),
            duplicates: take(&mut self.delaunay.predicates.vertices.duplicates),
            chains: take(&mut self.chains).finish(),
        };
        self.delaunay.probe.begin(Phase::Finished);
        self.lists.artificial = artificial;
        result
    }

    /// Lists the hull counter-clockwise from the leftmost vertex, and the artificial triangles; closes the upper hull.
    fn list_hull(&mut self, hull: &mut Vec<u32>, triangles: &mut Vec<TriangleId>) {
        let artificial = self.delaunay.predicates.artificial;
        let (left, right) = (artificial.left, artificial.right);
        let (first, last) = (self.front.next(left), self.front.prev(right));
        if first == right {
            return;
        }
        let (mesh, vertices) = (&mut self.delaunay.mesh, &self.delaunay.predicates.vertices);
        hull.push(vertices.input_index(first));
        // The lower hull: around P-1 from the front down to P-2, then around P-2 up to the front.
        let mut side = mesh.border_twin(BorderId::segment(left));
        let mut pivot = left;
        while !side.is_border() {
            // The hull has no more sides than there are triangles.
            if hull.len() > mesh.len() {
                inexact_scalar();
            }
            triangles.push(side.triangle());
            let v = mesh.opposite(side);
            side = if v == right {
                pivot = right;
                mesh.twin(side.prev())
            } else {
                hull.push(vertices.input_index(v));
                mesh.twin(side.next())
            };
        }
        debug_assert!(pivot == right && side == HalfEdge::border(BorderId::segment(last)));
        // The front is the upper hull now. From right to left:
        let mut at = last;
        while at != first {
            at = self.front.prev(at);
            mesh.close(BorderId::segment(at));
            if at != first {
                hull.push(vertices.input_index(at));
            }
        }
    }

    /// Removes artificial triangles, which are in ascending order; the last triangle takes the place of each.
    fn remove_artificial(&mut self, triangles: &mut Vec<Triangle>, mut artificial: &[TriangleId]) {
        while let Some((&t, others)) = artificial.split_first() {
            artificial = others;
            loop {
                let record = triangles[t.index()];
                self.delaunay.report(|name| Event::Removed {
                    vertices: record.vertices().map(name),
                });
                // The neighbours get the hull in place of the triangle.
                for i in 0..3 {
                    relink(triangles, record.twin(i), HalfEdge::HULL);
                }
                triangles.swap_remove(t.index());
                if let Some(&moved) = triangles.get(t.index()) {
                    for i in 0..3 {
                        relink(triangles, moved.twin(i), HalfEdge::new(t, i));
                    }
                }
                // The triangle moved here may be artificial, too.
                let from = TriangleId::at(triangles.len());
                match artificial.split_last() {
                    Some((&last, others)) if last == from => artificial = others,
                    _ => break,
                }
            }
        }
    }
}

/// Sorts distinct triangle numbers below `count`: a few by comparison, many with one bit for each number.
fn put_in_order(list: &mut Vec<TriangleId>, count: usize) {
    const BITS: usize = u64::BITS as usize;
    if list.len() <= FEW_ARTIFICIAL {
        return list.sort_unstable();
    }
    let mut marks = vec![0_u64; count.div_ceil(BITS)];
    for t in list.drain(..) {
        marks[t.index() / BITS] |= 1 << (t.index() % BITS);
    }
    for (word, &marks) in marks.iter().enumerate() {
        let mut rest = marks;
        while rest != 0 {
            list.push(TriangleId::at(word * BITS + rest.trailing_zeros() as usize));
            rest &= rest - 1;
        }
    }
}

/// Sets the twin of `side`, if that is the side of a triangle.
fn relink(triangles: &mut [Triangle], side: HalfEdge, twin: HalfEdge) {
    if !side.is_border() {
        triangles[side.triangle().index()].set_twin(side.corner(), twin.constrained_as(side));
    }
}

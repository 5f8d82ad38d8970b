//! From ghosts to the state of a sweep whose hull is complete, in O(h) for h vertices on the hull.
//!
//! Ghosts of the lower hull become artificial triangles: left of the lowest vertex with P-1, right of it with P-2.
//! Between them comes the triangle of the lowest vertex with both. The ghosts of the upper hull make way for the front.
//! See the figures of [`super::super::artificial`] and [`super::super::finalization`].

use alloc::vec::Vec;
use core::cmp::Ordering::Greater;

use super::super::Sweep;
use super::super::contradiction::inexact_scalar;
use crate::ids::{BorderId, VertexId};
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;

impl<P: Probe> Sweep<'_, P> {
    /// Replaces the ghosts; the hull side of `start` starts at the lowest vertex.
    pub(in crate::sweep) fn hand_over(&mut self, start: HalfEdge) {
        let ghosts = self.ring_of(start);
        // Counter-clockwise: the lower hull to the right, the upper hull back, the lower hull to the left.
        let falls = |ghost: &HalfEdge| {
            let [a, b] = self.delaunay.ends(*ghost);
            self.delaunay.predicates.compare_x(a, b) == Greater
        };
        let rises = |ghost: &&HalfEdge| {
            let [a, b] = self.delaunay.ends(**ghost);
            a < b && !falls(ghost)
        };
        let right = ghosts.iter().take_while(rises).count();
        let upper = ghosts[right..]
            .iter()
            .take_while(|&ghost| falls(ghost))
            .count();
        let (right, others) = ghosts.split_at(right);
        let (upper, left) = others.split_at(upper);

        let [lowest, _] = self.delaunay.ends(start);
        let last = right
            .last()
            .map_or(lowest, |&ghost| self.delaunay.ends(ghost)[1]);
        self.open_upper_hull(upper, last);
        self.close_lower_hull(left, right, lowest, last);
    }

    /// All ghosts, counter-clockwise from `start`.
    fn ring_of(&self, start: HalfEdge) -> Vec<HalfEdge> {
        let after = |&ghost: &HalfEdge| {
            let next = self.delaunay.after(ghost);
            (next != start).then_some(next)
        };
        let most = self.delaunay.mesh.len();
        let ghosts: Vec<HalfEdge> = core::iter::successors(Some(start), after)
            .take(most + 1)
            .collect();
        if ghosts.len() > most {
            inexact_scalar();
        }
        ghosts
    }

    /// Puts the front in place of the ghosts `upper`, which run from right to left, from `last` on.
    fn open_upper_hull(&mut self, upper: &[HalfEdge], last: VertexId) {
        let artificial = self.delaunay.predicates.artificial;
        self.front.link(last, artificial.left);
        for &ghost in upper {
            let [_, left] = self.delaunay.ends(ghost);
            let inner = self.delaunay.mesh.twin(ghost);
            self.delaunay
                .mesh
                .connect(inner, HalfEdge::border(BorderId::segment(left)));
            self.delaunay.mesh.retire(ghost.triangle());
            self.front.link(left, artificial.left);
        }
    }

    /// Makes ghosts artificial triangles: `left` ones run down to the `lowest` vertex, `right` ones up to `last`.
    pub(in crate::sweep) fn close_lower_hull(
        &mut self,
        left: &[HalfEdge],
        right: &[HalfEdge],
        lowest: VertexId,
        last: VertexId,
    ) {
        let artificial = self.delaunay.predicates.artificial;
        let mesh = &mut self.delaunay.mesh;
        for &ghost in right {
            mesh.set_opposite(ghost, artificial.right);
        }
        let [mut at_left, mut at_right] =
            [artificial.left, lowest].map(|v| HalfEdge::border(BorderId::segment(v)));
        if let (Some(first), Some(end)) = (left.first(), left.last()) {
            mesh.connect(first.next(), at_left);
            at_left = end.prev();
        }
        if let (Some(first), Some(end)) = (right.first(), right.last()) {
            mesh.connect(end.prev(), HalfEdge::border(BorderId::segment(last)));
            at_right = first.next();
        }
        let vertices = [lowest, artificial.left, artificial.right];
        mesh.add(vertices, [HalfEdge::NOTHING, at_right, at_left]);
    }
}

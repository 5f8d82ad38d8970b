//! From ghosts to the state of a sweep whose hull is complete.
//!
//! Ghosts of the lower hull become artificial triangles: left of the lowest vertex with P-1, right of it with
//! P-2. Between them comes the triangle of the lowest vertex with both. The ghosts of the upper hull make way
//! for the front. See the figures of [`super::super::artificial`] and [`super::super::finalization`].
//!
//! Cost: O(h) for h vertices on the hull.

use std::cmp::Ordering::Greater;

use super::super::flip_limit::contradiction;
use super::super::state::Sweep;
use crate::ids::{OpenId, VertexId};
use crate::mesh::Side;
use crate::probe::Probe;
use crate::scalar::Scalar;

impl<S: Scalar, P: Probe> Sweep<'_, S, P> {
    /// Replaces the ghosts; the hull side of `start` starts at the lowest vertex.
    pub(in crate::sweep) fn hand_over(&mut self, start: Side) {
        let ghosts = self.ring_of(start);
        // Counter-clockwise: the lower hull to the right, the upper hull back, the lower hull to the left.
        let falls = |ghost: &Side| {
            let [a, b] = self.fabric.ends(*ghost);
            self.fabric.signs.compare_x(a, b) == Greater
        };
        let rises = |ghost: &&Side| {
            let [a, b] = self.fabric.ends(**ghost);
            a < b && !falls(ghost)
        };
        let right = ghosts.iter().take_while(rises).count();
        let upper = ghosts[right..]
            .iter()
            .take_while(|&ghost| falls(ghost))
            .count();
        let (right, others) = ghosts.split_at(right);
        let (upper, left) = others.split_at(upper);

        let [lowest, _] = self.fabric.ends(start);
        let last = right
            .last()
            .map_or(lowest, |&ghost| self.fabric.ends(ghost)[1]);
        self.open_upper_hull(upper, last);
        self.close_lower_hull(left, right, lowest, last);
    }

    /// All ghosts, counter-clockwise from `start`.
    fn ring_of(&self, start: Side) -> Vec<Side> {
        let after = |&ghost: &Side| {
            let next = self.fabric.after(ghost);
            (next != start).then_some(next)
        };
        let most = self.fabric.mesh.len();
        let ghosts: Vec<Side> = std::iter::successors(Some(start), after)
            .take(most + 1)
            .collect();
        if ghosts.len() > most {
            contradiction();
        }
        ghosts
    }

    /// The front takes the place of these ghosts, which run from right to left, from `last` on.
    fn open_upper_hull(&mut self, upper: &[Side], last: VertexId) {
        let artificial = self.fabric.signs.artificial;
        self.front.link(last, artificial.left);
        for &ghost in upper {
            let [_, left] = self.fabric.ends(ghost);
            let inner = self.fabric.mesh.across(ghost);
            self.fabric
                .mesh
                .connect(inner, Side::open(OpenId::segment(left)));
            self.fabric.mesh.retire(ghost.triangle());
            self.front.link(left, artificial.left);
        }
    }

    /// Artificial triangles take the place of these ghosts: those `left` of the lowest vertex, which run down
    /// to it, and those `right` of it, which run up to the last vertex of the front.
    pub(in crate::sweep) fn close_lower_hull(
        &mut self,
        left: &[Side],
        right: &[Side],
        lowest: VertexId,
        last: VertexId,
    ) {
        let artificial = self.fabric.signs.artificial;
        let mesh = &mut self.fabric.mesh;
        for &ghost in right {
            mesh.set_opposite(ghost, artificial.right);
        }
        let [mut at_left, mut at_right] =
            [artificial.left, lowest].map(|v| Side::open(OpenId::segment(v)));
        if let (Some(first), Some(end)) = (left.first(), left.last()) {
            mesh.connect(first.next(), at_left);
            at_left = end.prev();
        }
        if let (Some(first), Some(end)) = (right.first(), right.last()) {
            mesh.connect(end.prev(), Side::open(OpenId::segment(last)));
            at_right = first.next();
        }
        let vertices = [lowest, artificial.left, artificial.right];
        mesh.add(vertices, [Side::NOTHING, at_right, at_left]);
    }
}

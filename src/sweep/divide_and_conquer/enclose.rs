//! From the state of a sweep whose hull is complete to a part with ghosts around it: the inverse of
//! [`hand_over`](super::hand_over).
//!
//! ```text
//!         first . u . last            The artificial triangles follow the lower hull counter-clockwise: first
//!        /               \            those with P-1, then the triangle of the lowest vertex with both, then
//!       a                 c           those with P-2. Each of them but that one is a ghost already, once P-2
//!        \               /            gives way to the vertex of all ghosts. The upper hull, which is what is
//!          lowest . . . b             left of the front, gets new ghosts.
//! ```
//!
//! Cost: O(h) for h vertices on the hull.

use super::super::flip_limit::contradiction;
use super::super::state::Sweep;
use super::Part;
use crate::ids::{OpenId, VertexId};
use crate::mesh::Side;
use crate::probe::Probe;
use crate::scalar::Scalar;

impl<S: Scalar, P: Probe> Sweep<'_, S, P> {
    /// Encloses the first `vertices` vertices, two or more and all that have been swept, in ghosts with the
    /// vertex `outside`.
    pub(in crate::sweep) fn enclose(&mut self, vertices: usize, outside: VertexId) -> Part {
        let mut ghosts = self.lower_ghosts();
        self.add_upper_ghosts(&mut ghosts);
        let highest = VertexId::at(vertices - 1);
        let part = Part {
            first: self.starting_at(VertexId::new(0), &ghosts),
            last: self.starting_at(highest, &ghosts),
        };
        for (i, &ghost) in ghosts.iter().enumerate() {
            let next = ghosts[(i + 1) % ghosts.len()];
            self.fabric.join_ghosts(ghost, next);
            self.fabric.mesh.set_opposite(ghost, outside);
        }
        part
    }

    /// The artificial triangles of the lower hull as ghosts, counter-clockwise; the one between those of P-1
    /// and those of P-2 retires.
    pub(in crate::sweep) fn lower_ghosts(&mut self) -> Vec<Side> {
        let artificial = self.fabric.signs.artificial;
        let mesh = &mut self.fabric.mesh;
        let mut ghosts = Vec::new();
        // What lies across, seen from the triangle before; first from the front.
        let mut side = mesh.below(OpenId::segment(artificial.left));
        while !side.is_open() {
            // The hull has no more sides than there are triangles.
            if ghosts.len() > mesh.len() {
                contradiction();
            }
            if mesh.opposite(side) == artificial.right {
                let lowest = side.triangle();
                side = mesh.across(side.prev());
                mesh.retire(lowest);
            } else {
                ghosts.push(side.prev());
                side = mesh.across(side.next());
            }
        }
        ghosts
    }

    /// New ghosts for the upper hull, from right to left.
    fn add_upper_ghosts(&mut self, ghosts: &mut Vec<Side>) {
        let artificial = self.fabric.signs.artificial;
        let mut at = self.front.prev(artificial.right);
        loop {
            let left = self.front.prev(at);
            if left == artificial.left {
                break;
            }
            let inner = self.fabric.mesh.below(OpenId::segment(left));
            let ghost = self.fabric.add_ghost(at, left);
            self.fabric.mesh.connect(ghost, inner);
            ghosts.push(ghost);
            at = left;
        }
    }

    /// The ghost of the hull side that starts at `v`, which is the first or the last vertex in sweep order.
    fn starting_at(&self, v: VertexId, ghosts: &[Side]) -> Side {
        let found = ghosts
            .iter()
            .find(|&&ghost| self.fabric.ends(ghost)[0] == v);
        found.copied().unwrap_or_else(|| contradiction())
    }
}

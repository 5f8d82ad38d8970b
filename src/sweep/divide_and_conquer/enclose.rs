//! From the state of a sweep whose hull is complete to a sub-triangulation with ghosts around it, in O(h) for h
//! vertices on the hull: the inverse of [`hand_over`](super::hand_over).
//!
//! ```text
//!         first . u . last            The artificial triangles follow the lower hull counter-clockwise: first
//!        /               \            those with P-1, then the triangle of the lowest vertex with both, then
//!       a                 c           those with P-2. Each of them but that one is a ghost already, once P-2
//!        \               /            gives way to the vertex of all ghosts. The upper hull, which is what is
//!          lowest . . . b             left of the front, gets new ghosts.
//! ```

use super::super::Sweep;
use super::super::contradiction::inexact_scalar;
#[cfg(feature = "parallel")]
use super::SubTriangulation;
use crate::ids::BorderId;
#[cfg(feature = "parallel")]
use crate::ids::VertexId;
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use alloc::vec::Vec;

impl<P: Probe> Sweep<'_, P> {
    /// The artificial triangles of the lower hull as ghosts, counter-clockwise; the one with both P-1 and P-2 retires.
    pub(in crate::sweep) fn lower_ghosts(&mut self) -> Vec<HalfEdge> {
        let artificial = self.delaunay.predicates.artificial;
        let mesh = &mut self.delaunay.mesh;
        let mut ghosts = Vec::new();
        // The twin, seen from the triangle before; first from the front.
        let mut side = mesh.border_twin(BorderId::segment(artificial.left));
        while !side.is_border() {
            // The hull has no more sides than there are triangles.
            if ghosts.len() > mesh.len() {
                inexact_scalar();
            }
            if mesh.opposite(side) == artificial.right {
                let lowest = side.triangle();
                side = mesh.twin(side.prev());
                mesh.retire(lowest);
            } else {
                ghosts.push(side.prev());
                side = mesh.twin(side.next());
            }
        }
        ghosts
    }
}

#[cfg(feature = "parallel")]
impl<P: Probe> Sweep<'_, P> {
    /// Encloses the `vertices` vertices swept, two or more, in ghosts with the vertex `outside`.
    pub(in crate::sweep) fn enclose(
        &mut self,
        vertices: usize,
        outside: VertexId,
    ) -> SubTriangulation {
        let mut ghosts = self.lower_ghosts();
        self.add_upper_ghosts(&mut ghosts);
        let highest = VertexId::at(vertices - 1);
        let part = SubTriangulation {
            first: self.starting_at(VertexId::new(0), &ghosts),
            last: self.starting_at(highest, &ghosts),
        };
        for (i, &ghost) in ghosts.iter().enumerate() {
            let next = ghosts[(i + 1) % ghosts.len()];
            self.delaunay.join_ghosts(ghost, next);
            self.delaunay.mesh.set_opposite(ghost, outside);
        }
        part
    }

    /// Adds ghosts for the upper hull, from right to left.
    fn add_upper_ghosts(&mut self, ghosts: &mut Vec<HalfEdge>) {
        let artificial = self.delaunay.predicates.artificial;
        let mut at = self.front.prev(artificial.right);
        loop {
            let left = self.front.prev(at);
            if left == artificial.left {
                break;
            }
            let inner = self.delaunay.mesh.border_twin(BorderId::segment(left));
            let ghost = self.delaunay.add_ghost(at, left);
            self.delaunay.mesh.connect(ghost, inner);
            ghosts.push(ghost);
            at = left;
        }
    }

    /// The ghost of the hull side that starts at `v`, which is the first or the last vertex in sweep order.
    fn starting_at(&self, v: VertexId, ghosts: &[HalfEdge]) -> HalfEdge {
        let found = ghosts
            .iter()
            .find(|&&ghost| self.delaunay.ends(ghost)[0] == v);
        found.copied().unwrap_or_else(|| inexact_scalar())
    }
}

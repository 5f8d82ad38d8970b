//! Ghosts: triangles outside the hull of a part, which make its triangulation a closed surface.
//!
//! Each hull side has one ghost. Its third vertex is the same for all; P-1 stands for it, though here it is
//! no point at all. A ghost is named by the side that it has in common with the hull.
//!
//! ```text
//!             G                   The hull side runs from a to b, counter-clockwise around the part. The
//!           / | \                 ghost is the triangle G, b, a. The ghost *before* it has the hull side
//!         /   |   \               that ends at a, the one *after* it the hull side that starts at b.
//!       /  b--|--a  \
//!      / after|before\            A part whose vertices all lie on one line has no triangle. Its hull runs
//!        part         \           along the line and back, with a ghost on either side.
//! ```
//!
//! Cost: O(1) for each function.

use core::cmp::Ordering;

use super::super::delaunay::Delaunay;
use super::SubTriangulation;
use crate::ids::VertexId;
use crate::mesh::HalfEdge;
use crate::probe::Probe;

impl<P: Probe> Delaunay<'_, P> {
    /// A ghost for the hull side from `a` to `b`.
    pub(in crate::sweep) fn add_ghost(&mut self, a: VertexId, b: VertexId) -> HalfEdge {
        let ghost = self.predicates.artificial.left;
        let t = self.mesh.add([ghost, b, a], [HalfEdge::NOTHING; 3]);
        HalfEdge::new(t, 0)
    }

    /// Both ends of a ghost's hull side, counter-clockwise around the hull.
    pub(in crate::sweep) fn ends(&self, ghost: HalfEdge) -> [VertexId; 2] {
        let [_, b, a] = self.mesh.around(ghost);
        [a, b]
    }

    /// The ghost whose hull side starts where that of `ghost` ends.
    pub(super) fn after(&self, ghost: HalfEdge) -> HalfEdge {
        self.mesh.twin(ghost.prev()).prev()
    }

    /// The ghost whose hull side ends where that of `ghost` starts.
    pub(super) fn before(&self, ghost: HalfEdge) -> HalfEdge {
        self.mesh.twin(ghost.next()).next()
    }

    /// Makes two ghosts neighbours: the hull side of `after` starts where that of `before` ends.
    pub(in crate::sweep) fn join_ghosts(&mut self, before: HalfEdge, after: HalfEdge) {
        self.mesh.connect(before.prev(), after.next());
    }

    /// Two or three vertices, number `from` to `to` (exclusive) in sweep order.
    pub(super) fn leaf(&mut self, from: usize, to: usize) -> SubTriangulation {
        let v = [from, from + 1, to - 1].map(VertexId::at);
        if to - from == 2 {
            let ghosts = self.ring([v[0], v[1]]);
            self.mesh.connect(ghosts[0], ghosts[1]);
            let [first, last] = ghosts;
            return SubTriangulation { first, last };
        }
        match self.orient2d(v) {
            Ordering::Equal => {
                let ghosts = self.ring([v[0], v[1], v[2], v[1]]);
                self.mesh.connect(ghosts[0], ghosts[3]);
                self.mesh.connect(ghosts[1], ghosts[2]);
                let [first, _, last, _] = ghosts;
                SubTriangulation { first, last }
            }
            Ordering::Greater => {
                let ghosts = self.triangle(v);
                SubTriangulation {
                    first: ghosts[0],
                    last: ghosts[2],
                }
            }
            Ordering::Less => {
                let ghosts = self.triangle([v[0], v[2], v[1]]);
                SubTriangulation {
                    first: ghosts[0],
                    last: ghosts[1],
                }
            }
        }
    }

    /// A triangle with its ghosts; the hull side of the first one starts at its first vertex.
    pub(in crate::sweep) fn triangle(&mut self, [a, b, c]: [VertexId; 3]) -> [HalfEdge; 3] {
        let ghosts = self.ring([a, b, c]);
        let t = self.mesh.add([c, a, b], ghosts);
        self.probe.record(|r| r.merged(t));
        ghosts
    }

    /// Ghosts around a hull with these vertices.
    fn ring<const N: usize>(&mut self, hull: [VertexId; N]) -> [HalfEdge; N] {
        let ghosts: [HalfEdge; N] =
            core::array::from_fn(|i| self.add_ghost(hull[i], hull[(i + 1) % N]));
        for i in 0..N {
            self.join_ghosts(ghosts[i], ghosts[(i + 1) % N]);
        }
        ghosts
    }
}

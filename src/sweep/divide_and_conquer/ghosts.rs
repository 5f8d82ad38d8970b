//! Ghosts: triangles outside the hull of a sub-triangulation, which make it a closed surface. Each hull side has one.
//! All ghosts share their third vertex; P-1 stands for it, though here it is no point at all. A ghost is named by the
//! side that it has in common with the hull. Each function costs O(1).
//!
//! ```text
//!             G                   The hull side runs from a to b, counter-clockwise around the hull. The
//!           / | \                 ghost is the triangle G, b, a. The ghost *before* it has the hull side
//!         /   |   \               that ends at a, the one *after* it the hull side that starts at b.
//!       /  b--|--a  \
//!      / after|before\            If all vertices lie on one line, there is no triangle. The hull runs
//!       inside        \           along the line and back, with a ghost on either side.
//! ```

use core::cmp::Ordering;

use super::super::delaunay::Delaunay;
use super::SubTriangulation;
use crate::ids::VertexId;
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;

impl<P: Probe> Delaunay<'_, P> {
    /// Adds a ghost for the hull side from `a` to `b`.
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

    /// The sub-triangulation of two or three vertices, with ranks `from` to `to` (exclusive).
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

    /// Adds a triangle and its ghosts; the hull side of the first ghost starts at `a`.
    pub(in crate::sweep) fn triangle(&mut self, [a, b, c]: [VertexId; 3]) -> [HalfEdge; 3] {
        let ghosts = self.ring([a, b, c]);
        let t = self.mesh.add([c, a, b], ghosts);
        self.probe.record(|r| r.merged(t));
        ghosts
    }

    /// Adds ghosts around a hull with these vertices.
    fn ring<const N: usize>(&mut self, hull: [VertexId; N]) -> [HalfEdge; N] {
        let ghosts: [HalfEdge; N] =
            core::array::from_fn(|i| self.add_ghost(hull[i], hull[(i + 1) % N]));
        for i in 0..N {
            self.join_ghosts(ghosts[i], ghosts[(i + 1) % N]);
        }
        ghosts
    }
}

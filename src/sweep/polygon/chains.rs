//! The chains of the intervals inside: what the advancing front is to the sweep of all points.
//!
//! A chain runs from left to right, over vertices that have been swept. Below it is what has been triangulated, or an
//! edge of the ring, or a diagonal that has no triangle yet. No corner of it turns left, but those at a vertex that is
//! being swept: these are *closed*, one after the other, until none is left.
//!
//! ```text
//!            v                    A chain with `v` as its new first vertex. The corner at `a` turns left
//!           / ` . `  .            and is closed by the triangle v-a-b, then the corner at `b` by v-b-c.
//!          /   `   `     `  .     The corner at `c` turns right, and the chain is v-c-d now.
//!         a     `     `        `
//!           `--- b ---- c       d    The fan around `v` is legalized from left to right. Its spokes v-b
//!                        ` ---- '    are legal: at `b` the chain did not turn left.
//! ```
//!
//! A *node* is a vertex on one chain. Its border half-edge is the side of the chain from there to the next node. Cost:
//! an orientation test for each triangle and for the end of each fan.

use alloc::vec::Vec;
use core::cmp::Ordering::Greater;

use crate::ids::{BorderId, VertexId};
use crate::mesh::{HalfEdge, Mesh};
use crate::sweep::delaunay::Delaunay;

/// The number of a node, and of its border half-edge.
pub(super) type NodeId = u32;

/// Beyond the ends of a chain.
const NONE: NodeId = u32::MAX;

#[derive(Clone, Copy, Debug)]
struct Node {
    vertex: VertexId,
    /// The nodes on the left and on the right.
    beside: [NodeId; 2],
}

/// A chain: its ends, and the node of the vertex that was swept last.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Chain {
    pub(super) ends: [NodeId; 2],
    pub(super) last_swept: NodeId,
}

/// The nodes of all chains.
#[derive(Debug, Default)]
pub(super) struct Chains {
    nodes: Vec<Node>,
}

impl Chains {
    pub(super) fn clear(&mut self) {
        self.nodes.clear();
    }

    #[inline(always)]
    fn add(&mut self, vertex: VertexId, beside: [NodeId; 2], mesh: &mut Mesh) -> NodeId {
        self.nodes.push(Node { vertex, beside });
        mesh.add_border_to(HalfEdge::NOTHING).number()
    }

    #[inline(always)]
    fn beside(&mut self, node: NodeId) -> &mut [NodeId; 2] {
        &mut self.nodes[node as usize].beside
    }

    /// A chain of one vertex.
    pub(super) fn begin(&mut self, v: VertexId, mesh: &mut Mesh) -> Chain {
        let node = self.add(v, [NONE; 2], mesh);
        Chain {
            ends: [node; 2],
            last_swept: node,
        }
    }

    /// Makes `v` the new left end (`RIGHT` is 0) or right end (1) of a chain, by an edge of the ring, and closes corners.
    #[inline(always)]
    pub(super) fn extend<const RIGHT: usize>(
        &mut self,
        chain: &mut Chain,
        v: VertexId,
        approx: [f64; 2],
        delaunay: &mut Delaunay<'_, ()>,
    ) {
        let mut beside = [NONE; 2];
        beside[1 - RIGHT] = chain.ends[RIGHT];
        let node = self.add(v, beside, &mut delaunay.mesh);
        self.beside(chain.ends[RIGHT])[RIGHT] = node;
        (chain.ends[RIGHT], chain.last_swept) = (node, node);
        if RIGHT == 0 {
            self.close::<1>(node, approx, delaunay);
        } else {
            self.close::<0>(node, approx, delaunay);
        }
    }

    /// Joins two chains by the edges from the right end of one and the left end of the other to `v`, and closes corners.
    pub(super) fn merge(
        &mut self,
        [left, right]: [Chain; 2],
        v: VertexId,
        approx: [f64; 2],
        delaunay: &mut Delaunay<'_, ()>,
    ) -> Chain {
        let beside = [left.ends[1], right.ends[0]];
        let node = self.add(v, beside, &mut delaunay.mesh);
        self.beside(beside[0])[1] = node;
        self.beside(beside[1])[0] = node;
        self.close::<0>(node, approx, delaunay);
        self.close::<1>(node, approx, delaunay);
        Chain {
            ends: [left.ends[0], right.ends[1]],
            last_swept: node,
        }
    }

    /// Cuts a chain in two by a diagonal from the vertex swept last to `v`, and closes corners.
    pub(super) fn split(
        &mut self,
        chain: Chain,
        v: VertexId,
        approx: [f64; 2],
        delaunay: &mut Delaunay<'_, ()>,
    ) -> [Chain; 2] {
        let mesh = &mut delaunay.mesh;
        let at = chain.last_swept;
        let Node { vertex, beside } = self.nodes[at as usize];
        // The side right of the vertex goes to its node on the right chain.
        let copy = self.add(vertex, [NONE, beside[1]], mesh);
        let mut last = chain.ends[1];
        if last == at {
            last = copy;
        } else {
            self.beside(beside[1])[0] = copy;
            let below = mesh.border_twin(BorderId::new(at));
            mesh.connect(HalfEdge::border(BorderId::new(copy)), below);
        }
        let [left, right] = [[at, NONE], [NONE, copy]].map(|beside| self.add(v, beside, mesh));
        self.beside(at)[1] = left;
        self.beside(copy)[0] = right;
        // The two sides of the diagonal.
        let [a, b] = [at, right].map(|node| HalfEdge::border(BorderId::new(node)));
        mesh.connect(a, b);
        self.close::<0>(left, approx, delaunay);
        self.close::<1>(right, approx, delaunay);
        [([chain.ends[0], left], left), ([right, last], right)]
            .map(|(ends, last_swept)| Chain { ends, last_swept })
    }

    /// Whether a chain is a single side.
    pub(super) fn is_single_side(&self, chain: &Chain) -> bool {
        self.nodes[chain.ends[0] as usize].beside[1] == chain.ends[1]
    }

    /// Closes the corners beside a node that has been swept just now, on its left (`RIGHT` is 0) or its right (1), and
    /// legalizes the fan.
    #[inline(always)]
    fn close<const RIGHT: usize>(
        &mut self,
        node: NodeId,
        approx: [f64; 2],
        delaunay: &mut Delaunay<'_, ()>,
    ) {
        let Node { vertex: v, beside } = self.nodes[node as usize];
        let first = beside[RIGHT];
        let (mut near, mut corner) = (first, self.nodes[first as usize]);
        let nearest = corner.vertex;
        let mut approx_corner = delaunay.predicates.approx(nearest);
        let mut fan = None;
        while corner.beside[RIGHT] != NONE {
            let far = corner.beside[RIGHT];
            let next = self.nodes[far as usize];
            let approx_next = delaunay.predicates.approx(next.vertex);
            let ([a, b], [approx_a, approx_b], outer) = if RIGHT == 1 {
                let approx = [approx_corner, approx_next];
                ([corner.vertex, next.vertex], approx, near)
            } else {
                let approx = [approx_next, approx_corner];
                ([next.vertex, corner.vertex], approx, far)
            };
            if delaunay.orient2d_approx([v, a, b], [approx, approx_a, approx_b]) != Greater {
                break;
            }
            // The side from `v` to the corner gives way to one to the next vertex.
            let mesh = &mut delaunay.mesh;
            let outer = mesh.border_twin(BorderId::new(outer));
            let t = if RIGHT == 1 {
                let side = BorderId::new(node);
                let inner = mesh.border_twin(side);
                mesh.add([v, a, b], [outer, HalfEdge::border(side), inner])
            } else {
                let inner = mesh.border_twin(BorderId::new(near));
                let side = HalfEdge::border(BorderId::new(far));
                mesh.add([v, a, b], [outer, inner, side])
            };
            // The fan is legalized from left to right.
            fan = if RIGHT == 1 { fan.or(Some(t)) } else { Some(t) };
            (near, corner, approx_corner) = (far, next, approx_next);
        }
        if let Some(t) = fan {
            self.beside(node)[RIGHT] = near;
            self.beside(near)[1 - RIGHT] = node;
            let last = if RIGHT == 1 { corner.vertex } else { nearest };
            delaunay.legalize_fan(t, approx, last);
        }
    }
}

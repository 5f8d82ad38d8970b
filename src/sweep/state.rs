//! The state of the sweep between two events: the [`Delaunay`], the advancing front with its search
//! structure, and the edges still to come.
//!
//! Invariants between two events, for the vertices swept so far:
//! - triangles fill the region under the front: real ones above the lower hull, artificial ones below it;
//! - they are the canonical constrained Delaunay triangulation of that region with the edges inserted so
//!   far;
//! - the front runs from P-1 to P-2 and is strictly x-monotone.

use std::mem::take;

use super::corner::ChainVertex;
use super::delaunay::Delaunay;
use super::edges::{Edges, PendingEdges};
use super::incidence::Incidence;
use super::obstacles::Obstacles;
use super::scratch::Scratch;
use crate::edge_chains::EdgeChainBuilder;
use crate::front::{Front, FrontNode, Search};
use crate::ids::{BorderId, VertexId};
use crate::probe::Probe;
use crate::recorder::Recorder;
use crate::scalar::Scalar;
use crate::settings::Heuristics;
use crate::trace::{Event, Why};

/// A vertex that is being added, with its approximated coordinates, which are looked up once.
#[derive(Clone, Copy, Debug)]
pub(super) struct NewVertex {
    pub(super) id: VertexId,
    pub(super) approx: [f64; 2],
}

/// The state between two events.
#[derive(Debug)]
pub(super) struct Sweep<'a, S, P> {
    pub(super) delaunay: Delaunay<'a, S, P>,
    pub(super) front: Front,
    pub(super) search: Search<'a>,
    pub(super) heuristics: Heuristics,
    pub(super) edges: Edges,
    /// For the result: the vertices along each edge inserted so far.
    pub(super) chains: EdgeChainBuilder,
    /// What is left of edges that pass through vertices.
    pub(super) pending: PendingEdges,
    /// A triangle of each vertex, once the hull is complete.
    pub(super) incidence: Incidence,
    /// Working memory: lower ends and input indices of the edges being inserted.
    pub(super) list: Vec<(VertexId, u32)>,
    /// What the edge being inserted runs into.
    pub(super) obstacles: Obstacles,
    /// Working memory: the stretch of the front being filled.
    pub(super) chain: Vec<ChainVertex>,
}

impl<'a, S: Scalar, P: Probe> Sweep<'a, S, P> {
    /// These triangles, this front without a vertex on it, and the edges that `memory` lists.
    pub(super) fn new(
        delaunay: Delaunay<'a, S, P>,
        front: Front,
        chains: EdgeChainBuilder,
        heuristics: Heuristics,
        search: Search<'a>,
        scratch: &mut Scratch,
    ) -> Self {
        let mut incidence = take(&mut scratch.incidence);
        incidence.clear();
        Sweep {
            delaunay,
            front,
            search,
            heuristics,
            edges: take(&mut scratch.edges),
            chains,
            pending: PendingEdges::new(),
            incidence,
            list: take(&mut scratch.list),
            obstacles: take(&mut scratch.obstacles),
            chain: take(&mut scratch.chain),
        }
    }

    /// The heuristics of the next point event: those asked for, or the paper's where these flip too much.
    #[inline(always)]
    pub(super) fn heuristics(&self) -> Heuristics {
        if self.delaunay.flip_limit.is_excessive() {
            Heuristics::PAPER
        } else {
            self.heuristics
        }
    }

    /// A vertex to be added.
    #[inline(always)]
    pub(super) fn new_vertex(&self, id: VertexId) -> NewVertex {
        let approx = self.delaunay.predicates.approx(id);
        NewVertex { id, approx }
    }

    /// Puts `p` on the front between `left` and the node after it.
    #[inline(always)]
    pub(super) fn put_on_front(&mut self, p: NewVertex, left: VertexId) {
        self.front.link(p.id, left);
        self.delaunay.probe.record(Recorder::front_grows);
        self.delaunay.report(|name| Event::FrontInsert {
            vertex: name(p.id),
            after: name(left),
        });
        let x = self.delaunay.predicates.search_x_approx(p.id, p.approx);
        self.search.inserted(FrontNode::new(p.id), x);
    }

    /// Takes `v`, which triangles now cover, off the front.
    #[inline(always)]
    pub(super) fn take_off_front(&mut self, v: VertexId) {
        self.front.unlink(v);
        self.delaunay.probe.record(Recorder::front_shrinks);
        self.delaunay
            .report(|name| Event::FrontRemove { vertex: name(v) });
        let x = self.delaunay.predicates.search_x(v);
        self.search.removed(FrontNode::new(v), x);
    }

    /// Fills the front from node `from` to node `to`, both real, up to its upper hull.
    pub(super) fn fill_front(&mut self, from: VertexId, to: VertexId, why: Why) {
        self.chain.clear();
        let (mut at, mut corners) = (from, 1);
        while at != to {
            (at, corners) = (self.front.next(at), corners + 1);
        }
        self.chain.reserve(corners);
        at = from;
        loop {
            let border = BorderId::segment(at);
            self.chain.push(ChainVertex { vertex: at, border });
            if at == to {
                break;
            }
            at = self.front.next(at);
        }

        let kept = self.delaunay.mesh.border_count();
        self.delaunay.fill(&mut self.chain, why);
        self.delaunay.legalize();
        self.delaunay.mesh.truncate_borders(kept);

        // The nodes between two neighbours on the hull are covered now.
        for k in 1..self.chain.len() {
            let [left, right] = [self.chain[k - 1].vertex, self.chain[k].vertex];
            while self.front.next(left) != right {
                self.take_off_front(self.front.next(left));
            }
        }
    }

    /// Bytes of the arrays that grow with the input.
    pub(super) fn heap_bytes(&self) -> usize {
        self.delaunay.mesh.heap_bytes()
            + self.delaunay.predicates.heap_bytes()
            + self.front.heap_bytes()
            + self.edges.heap_bytes()
            + self.chains.heap_bytes()
            + self.incidence.heap_bytes()
    }
}

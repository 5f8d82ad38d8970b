//! The state of the sweep between two events: the [`Fabric`], the advancing front with its search
//! structure, and the edges still to come.
//!
//! Invariants between two events, for the vertices swept so far:
//! - triangles fill the region under the front: real ones above the lower hull, artificial ones below it;
//! - they are the canonical constrained Delaunay triangulation of that region with the edges inserted so
//!   far;
//! - the front runs from P-1 to P-2 and is strictly x-monotone.

use std::mem::take;

use super::corner::Corner;
use super::edges::{Edges, Rests};
use super::fabric::Fabric;
use super::incidence::Incidence;
use super::memory::Memory;
use super::obstacles::Obstacles;
use crate::chains::ChainNotes;
use crate::front::{Front, FrontNode, Search};
use crate::ids::{OpenId, VertexId};
use crate::probe::Probe;
use crate::recorder::Recorder;
use crate::scalar::Scalar;
use crate::settings::Heuristics;
use crate::trace::{Event, Why};

/// A vertex that is being added, with its approximated coordinates, which are looked up once.
#[derive(Clone, Copy, Debug)]
pub(super) struct NewVertex {
    pub(super) id: VertexId,
    pub(super) near: [f64; 2],
}

/// The state between two events.
#[derive(Debug)]
pub(super) struct Sweep<'a, S, P> {
    pub(super) fabric: Fabric<'a, S, P>,
    pub(super) front: Front,
    pub(super) search: Search<'a>,
    pub(super) heuristics: Heuristics,
    pub(super) edges: Edges,
    /// For the result: the vertices along each edge inserted so far.
    pub(super) chains: ChainNotes,
    /// What is left of edges that pass through vertices.
    pub(super) rests: Rests,
    /// A triangle of each vertex, once the hull is complete.
    pub(super) incidence: Incidence,
    /// Working memory: lower ends and input indices of the edges being inserted.
    pub(super) list: Vec<(VertexId, u32)>,
    /// What the edge being inserted runs into.
    pub(super) obstacles: Obstacles,
    /// Working memory: the stretch of the front being filled.
    pub(super) chain: Vec<Corner>,
}

impl<'a, S: Scalar, P: Probe> Sweep<'a, S, P> {
    /// These triangles, this front without a vertex on it, and the edges that `memory` lists.
    pub(super) fn new(
        fabric: Fabric<'a, S, P>,
        front: Front,
        chains: ChainNotes,
        heuristics: Heuristics,
        search: Search<'a>,
        memory: &mut Memory,
    ) -> Self {
        let mut incidence = take(&mut memory.incidence);
        incidence.clear();
        Sweep {
            fabric,
            front,
            search,
            heuristics,
            edges: take(&mut memory.edges),
            chains,
            rests: Rests::new(),
            incidence,
            list: take(&mut memory.list),
            obstacles: take(&mut memory.obstacles),
            chain: take(&mut memory.chain),
        }
    }

    /// The heuristics of the next point event: those asked for, or the paper's where these flip too much.
    #[inline(always)]
    pub(super) fn heuristics(&self) -> Heuristics {
        if self.fabric.flip_limit.is_excessive() {
            Heuristics::PAPER
        } else {
            self.heuristics
        }
    }

    /// A vertex to be added.
    #[inline(always)]
    pub(super) fn new_vertex(&self, id: VertexId) -> NewVertex {
        let near = self.fabric.signs.approx(id);
        NewVertex { id, near }
    }

    /// Puts `p` on the front between `left` and the node after it.
    #[inline(always)]
    pub(super) fn put_on_front(&mut self, p: NewVertex, left: VertexId) {
        self.front.link(p.id, left);
        self.fabric.probe.record(Recorder::front_grows);
        self.fabric.report(|name| Event::FrontInsert {
            vertex: name(p.id),
            after: name(left),
        });
        let x = self.fabric.signs.search_x_near(p.id, p.near);
        self.search.inserted(FrontNode::new(p.id), x);
    }

    /// Takes `v`, which triangles now cover, off the front.
    #[inline(always)]
    pub(super) fn take_off_front(&mut self, v: VertexId) {
        self.front.unlink(v);
        self.fabric.probe.record(Recorder::front_shrinks);
        self.fabric
            .report(|name| Event::FrontRemove { vertex: name(v) });
        let x = self.fabric.signs.search_x(v);
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
            let open = OpenId::segment(at);
            self.chain.push(Corner { vertex: at, open });
            if at == to {
                break;
            }
            at = self.front.next(at);
        }

        let kept = self.fabric.mesh.count_open();
        self.fabric.fill(&mut self.chain, why);
        self.fabric.legalize();
        self.fabric.mesh.forget_open(kept);

        // The nodes between two neighbours on the hull are covered now.
        for k in 1..self.chain.len() {
            let [left, right] = [self.chain[k - 1].vertex, self.chain[k].vertex];
            while self.front.next(left) != right {
                self.take_off_front(self.front.next(left));
            }
        }
    }

    /// Bytes of the arrays that grow with the input.
    pub(super) fn memory(&self) -> usize {
        self.fabric.mesh.memory()
            + self.fabric.signs.memory()
            + self.front.memory()
            + self.edges.memory()
            + self.chains.memory()
            + self.incidence.memory()
    }
}

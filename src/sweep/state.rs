//! The state between two events, and the memory that one run leaves for the next.
//!
//! A [`Sweep`] owns the [`Arrays`] that nearly every step reads, and borrows the rest of a [`Scratch`]. When it ends, the
//! scratch gets the arrays back, with whatever they hold, also where the run ends in an error. If the sizes suffice, the
//! next run neither asks the system for pages nor frees any. The arrays of a result leave the scratch, and come back if
//! the result does ([`Scratch::recycle`]). For a single run the scratch is empty at the start and costs nothing; what only
//! the initialization needs is then freed at its end.

use alloc::vec::Vec;
use core::mem::take;

use super::Sweep;
use super::delaunay::{self, ChainVertex, Delaunay};
use super::edges::Edges;
use super::predicates::SweepPredicates;
use super::traversal::Traversed;
use super::vertex_triangles::VertexTriangles;
use super::vertices::{SortBuffers, Vertices};
use super::waiting_edges::WaitingEdges;
use crate::front::{Front, FrontNode, HashTable, Search};
use crate::ids::{BorderId, TriangleId, VertexId};
use crate::mesh::Mesh;
use crate::observe::probe::Probe;
use crate::observe::recorder::Recorder;
use crate::scalar::ExactPoints;
use crate::settings::{Heuristics, Settings};
use crate::trace::{Event, Why};
use crate::triangulation::Triangulation;
use crate::triangulation::edge_chains::EdgeChainBuilder;

/// The memory of a run.
#[derive(Debug, Default)]
pub(crate) struct Scratch {
    pub(super) is_kept: bool,
    pub(super) sort: SortBuffers,
    /// The ends of the edges as input indices, between two runs.
    pub(super) ends: Vec<[u32; 2]>,
    pub(super) arrays: Arrays,
    pub(super) buffers: delaunay::Buffers,
    pub(super) lists: Lists,
}

/// What a sweep owns until it ends, because an access by reference is slower.
#[derive(Debug, Default)]
pub(super) struct Arrays {
    pub(super) vertices: Vertices,
    pub(super) mesh: Mesh,
    /// None before the first run.
    pub(super) front: Option<Front>,
    /// The default search structure of the front.
    pub(super) table: HashTable,
    /// The ends of all edges as input indices, and the vertices along those inserted.
    pub(super) chains: EdgeChainBuilder,
    pub(super) traversed: Traversed,
}

/// What a sweep borrows.
#[derive(Debug, Default)]
pub(super) struct Lists {
    pub(super) edges: Edges,
    /// A triangle of each vertex, once the hull is complete.
    pub(super) vertex_triangles: VertexTriangles,
    /// Lower ends and input indices of the edges being inserted.
    pub(super) inserted: Vec<(VertexId, u32)>,
    /// The nodes of the front being filled.
    pub(super) chain: Vec<ChainVertex>,
    /// Finalization: the hull as input indices, and the artificial triangles.
    pub(super) hull: Vec<u32>,
    pub(super) artificial: Vec<TriangleId>,
}

impl Scratch {
    /// A scratch for many runs, without buffers yet.
    pub(crate) fn kept() -> Scratch {
        Scratch {
            is_kept: true,
            ..Scratch::default()
        }
    }

    /// Takes back the buffers of a result that nobody needs any more.
    pub(crate) fn recycle(&mut self, result: Triangulation) {
        self.arrays.mesh.reuse(result.triangles);
        self.arrays.vertices.input = result.vertices;
        self.arrays.vertices.duplicates = result.duplicates;
        self.ends = result.chains.into_ends();
        self.lists.hull = result.hull;
    }
}

/// A vertex that is being added, with its approximations, which are looked up once.
#[derive(Clone, Copy, Debug)]
pub(super) struct NewVertex {
    pub(super) id: VertexId,
    pub(super) approx: [f64; 2],
}

impl<'a, P: Probe> Sweep<'a, P> {
    /// The state with the vertices, triangles and edges in `scratch`, and with its front.
    pub(super) fn new(
        points: &'a dyn ExactPoints,
        settings: Settings,
        search: Search<'a>,
        probe: P,
        scratch: &'a mut Scratch,
    ) -> Self {
        let Scratch {
            arrays,
            buffers,
            lists,
            ..
        } = scratch;
        let vertices = take(&mut arrays.vertices);
        let predicates = SweepPredicates::new(points, vertices).with_ties(settings.ties);
        let mesh = take(&mut arrays.mesh);
        let delaunay = Delaunay::new(mesh, predicates, settings, probe, buffers);
        let waiting = WaitingEdges::new(&delaunay);
        lists.vertex_triangles.clear();
        Sweep {
            delaunay,
            front: arrays.front.take().expect("a front for these vertices"),
            search,
            heuristics: settings.heuristics,
            lists,
            chains: take(&mut arrays.chains),
            waiting,
            traversed: take(&mut arrays.traversed),
        }
    }

    /// Ends, and returns the arrays, with the probe.
    pub(super) fn give_back(self) -> (Arrays, P) {
        let arrays = Arrays {
            vertices: self.delaunay.predicates.vertices,
            mesh: self.delaunay.mesh,
            front: Some(self.front),
            table: self.search.into_table(),
            chains: self.chains,
            traversed: self.traversed,
        };
        (arrays, self.delaunay.probe)
    }

    /// The heuristics of the next point event: the caller's, or the paper's where these flip too much.
    #[inline(always)]
    pub(super) fn heuristics(&self) -> Heuristics {
        if self.delaunay.flip_limit.is_excessive() {
            Heuristics::PAPER
        } else {
            self.heuristics
        }
    }

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
        self.search.inserted(FrontNode::new(p.id), p.approx[0]);
    }

    /// Takes `v`, which triangles now cover, off the front.
    #[inline(always)]
    pub(super) fn take_off_front(&mut self, v: VertexId) {
        self.front.unlink(v);
        self.delaunay.probe.record(Recorder::front_shrinks);
        self.delaunay
            .report(|name| Event::FrontRemove { vertex: name(v) });
        let predicates = &self.delaunay.predicates;
        self.search
            .removed(FrontNode::new(v), || predicates.approx(v)[0]);
    }

    /// Fills the front from node `from` to node `to`, both real, up to its upper hull.
    pub(super) fn fill_front(&mut self, from: VertexId, to: VertexId, why: Why) {
        self.lists.chain.clear();
        let (mut at, mut corners) = (from, 1);
        while at != to {
            (at, corners) = (self.front.next(at), corners + 1);
        }
        self.lists.chain.reserve(corners);
        at = from;
        loop {
            let border = BorderId::segment(at);
            self.lists.chain.push(ChainVertex { vertex: at, border });
            if at == to {
                break;
            }
            at = self.front.next(at);
        }

        let kept = self.delaunay.mesh.border_count();
        self.delaunay.fill(&mut self.lists.chain, why);
        self.delaunay.legalize();
        self.delaunay.mesh.truncate_borders(kept);

        // The nodes between two neighbours on the hull are covered now.
        for k in 1..self.lists.chain.len() {
            let [left, right] = [self.lists.chain[k - 1].vertex, self.lists.chain[k].vertex];
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
            + self.lists.edges.heap_bytes()
            + self.chains.heap_bytes()
            + self.lists.vertex_triangles.heap_bytes()
    }
}

#[cfg(test)]
mod tests {
    use crate::settings::Settings;
    use crate::sweep::{Scratch, run};
    use crate::watch::Watch;

    /// Of each array that grows with the input, how much it holds without asking for more.
    fn room(scratch: &Scratch) -> [usize; 6] {
        let (arrays, lists) = (&scratch.arrays, &scratch.lists);
        [
            scratch.ends.capacity(),
            arrays.vertices.heap_bytes(),
            arrays.mesh.heap_bytes(),
            arrays.front.as_ref().map_or(0, |front| front.heap_bytes()),
            lists.edges.heap_bytes(),
            lists.artificial.capacity(),
        ]
    }

    #[test]
    fn an_error_leaves_memory_and_nothing_else() {
        let settings = Settings::default();
        let square = [[0, 0], [4, 0], [4, 4], [0, 4]];
        let right = [[0, 2], [1, 2]];
        let mut scratch = Scratch::kept();
        let mut runs = |edges: [[usize; 2]; 2]| {
            let run = run(&square, &edges, settings, Watch::new(), &mut scratch);
            let result = run.map(|result| result.canonical_triangles());
            (result, room(&scratch))
        };
        runs(right).0.expect("edges that do not cross");
        let (crossing, out_of_range) = ([[0, 2], [1, 3]], [[0, 2], [1, 4]]);
        for wrong in [crossing, out_of_range] {
            let (error, room) = runs(wrong);
            error.expect_err("wrong edges");
            assert!(room.iter().all(|&room| room > 0), "{room:?}");
            let result = runs(right).0;
            let triangles = result.expect("edges that do not cross");
            assert_eq!(triangles, [[0, 1, 2], [0, 2, 3]]);
        }
    }
}

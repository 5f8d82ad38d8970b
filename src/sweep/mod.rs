//! The sweep (section 3): initialization, point events and edge events in sweep order, finalization.
//!
//! | section | figure | what | file |
//! |---|---|---|---|
//! | 3.2 | | the three parts; the state between two events | `mod.rs` |
//! | 3.3 | | initialization | [`initialization`] |
//! | 3.3 | | distinct points in sweep order | [`vertices`] |
//! | 3.3 | 5 | edges at their upper ends | [`edges`] |
//! | 3.3 | 6 | P-1 and P-2, first triangle | [`artificial`], [`initialization`] |
//! | 3.4.1 | 7, 8 | point event: projection, middle and left case | [`point_event`] |
//! | 3.4.1 (i), (ii) | 9, 10 | heuristics: narrow corners, basins | [`heuristics`] |
//! | 3.4.2 | | edge event: pockets under the edge, parts of it, constrained sides | [`edge_event`] |
//! | 3.4.2 (i), (ii) | 11, 13, 14 | triangle and front traversal | [`traversal`] |
//! | 3.4.2 (ii), (iii) | 12 | removed triangles, pseudo-polygons | [`delaunay`] (`cavity.rs`) |
//! | 3.4.2, 3.5 | 12, 13, 15a | filling a chain up to its hull | [`delaunay`] (`fill.rs`) |
//! | 2 | 2, 3 | empty circle test and its ties, legalization | [`predicates`], [`delaunay`] (`legalization.rs`) |
//! | 3.5 | 15 | finalization | [`finalization`] |
//! | none | | edges through vertices | [`pending_edges`] |
//! | none | | edges that pierce many triangles; which crossing is named | [`deferred_edges`], [`first_crossing`] |
//! | none | | when the sweep is abandoned | [`flip_limit`] |
//! | none | | the net under it: divide and conquer | [`divide_and_conquer`] |
//! | none | | the sweep on all cores | `bands` (feature `parallel`) |
//! | none | | other algorithms of section 4, and the sweep of 2005 | `comparison` (feature `comparison`) |
//! | none | | the inside of a polygon alone | [`polygon`] |
//! | none | | memory for many runs | [`scratch`] |
//! | none | | edges that cross none of the others, for the list of crossings | [`mod@separate`] |
//!
//! The mesh is [`crate::mesh`], the front and its hash table (3.4.1) are [`crate::front`], and the settings of the
//! heuristics [`crate::Heuristics`]. Each file names its differences from the paper.
//!
//! Cost: about O(n log n) on ordinary inputs. O(n^2) at worst: on some inputs every algorithm that keeps a Delaunay
//! triangulation of the points swept so far must make that many flips. Then the sweep is abandoned, unless the caller
//! forbids it.

mod artificial;
#[cfg(feature = "parallel")]
mod bands;
#[cfg(feature = "comparison")]
mod comparison;
mod deferred_edges;
mod delaunay;
mod divide_and_conquer;
mod edge_event;
mod edges;
mod finalization;
mod first_crossing;
mod flip_limit;
mod heuristics;
mod initialization;
mod pending_edges;
mod point_event;
mod polygon;
mod predicates;
mod scratch;
mod separate;
mod traversal;
mod vertices;

use alloc::vec::Vec;
use core::mem::take;

use crate::error::Error;
use crate::front::{Front, FrontNode, FrontSearch, Search};
use crate::ids::{BorderId, TriangleId, VertexId};
use crate::observe::probe::{Observer, Probe};
use crate::observe::recorder::{Phase, Recorder};
use crate::scalar::{ExactPoints, Scalar};
use crate::settings::{Algorithm, Heuristics, Progress, Settings};
use crate::trace::{Event, Why};
use crate::triangulation::Triangulation;
use crate::triangulation::edge_chains::EdgeChainBuilder;
use crate::tuning::{EVENTS_BETWEEN_LOOKS, EVENTS_BETWEEN_REPORTS};
use crate::watch::Watch;
#[cfg(feature = "parallel")]
pub(crate) use bands::run as run_in_bands;
use deferred_edges::DeferredEdges;
use delaunay::{ChainVertex, Delaunay};
use edges::Edges;
use pending_edges::{PendingEdges, VertexTriangles};
pub(crate) use polygon::{PolygonScratch, triangulate_rings};
use predicates::SweepPredicates;
pub(crate) use scratch::Scratch;
use scratch::{Held, Lent};
pub(crate) use separate::{Separated, separate};
use traversal::Traversed;

/// Runs the three parts of section 3.2, or divide and conquer in place of the first two.
pub(crate) fn run<S: Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    settings: Settings,
    watch: Watch<'_>,
    scratch: &mut Scratch,
) -> Result<Triangulation, Error> {
    let Watch {
        front,
        progress,
        events,
        stats,
    } = watch;
    let is_watched = stats.is_some() || events.is_some();
    let mut observer = is_watched.then(|| Observer::of(events));
    if let Some(observer) = &mut observer {
        observer.recorder.clock(Phase::Initialization);
    }
    let chains = initialization::initialize(points, edges, settings.tuning, scratch)?;
    let call = Call {
        chains,
        settings,
        front,
        progress,
    };
    let (result, observer) = triangulate_observed(&points, call, observer, scratch)?;
    if let (Some(stats), Some(observer)) = (stats, observer) {
        *stats = observer.recorder.finish(points.len(), edges.len(), &result);
    }
    Ok(result)
}

/// What a run is given beside its points and edges.
struct Call<'a> {
    chains: EdgeChainBuilder,
    settings: Settings,
    front: Option<&'a mut dyn FrontSearch>,
    progress: Progress<'a>,
}

/// Triangulates the vertices and edges that are in `scratch`. What follows the initialization knows neither the scalar nor
/// the search structure by type: so this crate compiles the sweep twice, and no crate that uses it once more.
#[inline(never)]
fn triangulate_observed<'o>(
    points: &dyn ExactPoints,
    call: Call<'_>,
    observer: Option<Observer<'o>>,
    scratch: &mut Scratch,
) -> Result<(Triangulation, Option<Observer<'o>>), Error> {
    match observer {
        None => Ok((triangulate(points, call, (), scratch)?.0, None)),
        Some(observer) => {
            let (result, observer) = triangulate(points, call, observer, scratch)?;
            Ok((result, Some(observer)))
        }
    }
}

fn triangulate<P: Probe>(
    points: &dyn ExactPoints,
    call: Call<'_>,
    probe: P,
    scratch: &mut Scratch,
) -> Result<(Triangulation, P), Error> {
    let Call {
        chains,
        settings,
        front,
        progress,
    } = call;
    let front = front.map(|front| front as _);
    let held = take(&mut scratch.held);
    let lent = &mut scratch.lent;
    let mut sweep = initialization::begin(points, chains, settings, front, probe, held, lent);
    let result = sweep
        .triangulate(settings, progress)
        .map(|()| sweep.finalize());
    let chains = take(&mut sweep.chains);
    let (held, probe) = sweep.give_back();
    scratch.held = held;
    if result.is_err() {
        scratch.ends = chains.into_ends();
    }
    Ok((result?, probe))
}

/// A vertex that is being added, with its approximations, which are looked up once.
#[derive(Clone, Copy, Debug)]
struct NewVertex {
    id: VertexId,
    approx: [f64; 2],
}

/// The state between two events.
#[derive(Debug)]
struct Sweep<'a, P> {
    delaunay: Delaunay<'a, P>,
    front: Front,
    search: Search<'a>,
    heuristics: Heuristics,
    edges: &'a Edges,
    /// For the result: the vertices along each edge inserted so far.
    chains: EdgeChainBuilder,
    pending: PendingEdges,
    deferred: DeferredEdges,
    /// A triangle of each vertex, once the hull is complete.
    vertex_triangles: &'a mut VertexTriangles,
    /// A buffer: lower ends and input indices of the edges being inserted.
    list: &'a mut Vec<(VertexId, u32)>,
    traversed: Traversed,
    /// A buffer: the nodes of the front being filled.
    chain: &'a mut Vec<ChainVertex>,
    /// Buffers of the finalization: the hull, and the artificial triangles.
    hull: &'a mut Vec<u32>,
    artificial: &'a mut Vec<TriangleId>,
}

impl<'a, P: Probe> Sweep<'a, P> {
    /// The state with the vertices, triangles and front of `held` and the edges of `lent`.
    fn new(
        points: &'a dyn ExactPoints,
        chains: EdgeChainBuilder,
        settings: Settings,
        search: Search<'a>,
        probe: P,
        held: Held,
        lent: &'a mut Lent,
    ) -> Self {
        let predicates = SweepPredicates::new(points, held.vertices).with_ties(settings.ties);
        let delaunay = Delaunay::new(held.mesh, predicates, settings, probe, &mut lent.delaunay);
        let deferred = DeferredEdges::new(&delaunay);
        lent.vertex_triangles.clear();
        Sweep {
            delaunay,
            front: held.front.expect("a front for these vertices"),
            search,
            heuristics: settings.heuristics,
            edges: &lent.edges,
            chains,
            pending: PendingEdges::new(),
            deferred,
            vertex_triangles: &mut lent.vertex_triangles,
            list: &mut lent.list,
            traversed: held.traversed,
            chain: &mut lent.chain,
            hull: &mut lent.hull,
            artificial: &mut lent.artificial,
        }
    }

    /// Ends, and returns what the state held, with the probe.
    fn give_back(self) -> (Held, P) {
        let held = Held {
            vertices: self.delaunay.predicates.vertices,
            mesh: self.delaunay.mesh,
            front: Some(self.front),
            table: self.search.into_table(),
            traversed: self.traversed,
        };
        (held, self.delaunay.probe)
    }

    /// The heuristics of the next point event: the caller's, or the paper's where these flip too much.
    #[inline(always)]
    fn heuristics(&self) -> Heuristics {
        if self.delaunay.flip_limit.is_excessive() {
            Heuristics::PAPER
        } else {
            self.heuristics
        }
    }

    #[inline(always)]
    fn new_vertex(&self, id: VertexId) -> NewVertex {
        let approx = self.delaunay.predicates.approx(id);
        NewVertex { id, approx }
    }

    /// Puts `p` on the front between `left` and the node after it.
    #[inline(always)]
    fn put_on_front(&mut self, p: NewVertex, left: VertexId) {
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
    fn take_off_front(&mut self, v: VertexId) {
        self.front.unlink(v);
        self.delaunay.probe.record(Recorder::front_shrinks);
        self.delaunay
            .report(|name| Event::FrontRemove { vertex: name(v) });
        let predicates = &self.delaunay.predicates;
        self.search
            .removed(FrontNode::new(v), || predicates.approx(v)[0]);
    }

    /// Fills the front from node `from` to node `to`, both real, up to its upper hull.
    fn fill_front(&mut self, from: VertexId, to: VertexId, why: Why) {
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
        self.delaunay.fill(self.chain, why);
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
    fn heap_bytes(&self) -> usize {
        self.delaunay.mesh.heap_bytes()
            + self.delaunay.predicates.heap_bytes()
            + self.front.heap_bytes()
            + self.edges.heap_bytes()
            + self.chains.heap_bytes()
            + self.vertex_triangles.heap_bytes()
    }
}

impl<P: Probe> Sweep<'_, P> {
    /// Triangulates up to the hull, with all edges, artificial triangles around it.
    fn triangulate(&mut self, settings: Settings, progress: Progress<'_>) -> Result<(), Error> {
        match self.triangulate_in_any_order(settings, progress) {
            Err(Error::CrossingEdges { .. }) if self.deferred.were_any() => {
                Err(self.first_crossing())
            }
            result => result,
        }
    }

    /// Triangulates, but where edges have been deferred, edges that cross need not be those that the paper's order meets
    /// first.
    fn triangulate_in_any_order(
        &mut self,
        settings: Settings,
        progress: Progress<'_>,
    ) -> Result<(), Error> {
        let is_swept = match settings.algorithm {
            Algorithm::DivideAndConquer => false,
            Algorithm::Auto | Algorithm::Sweep | Algorithm::Paper => {
                self.sweep_to_hull(progress)?
            }
            #[cfg(feature = "comparison")]
            Algorithm::Incremental => self.insert_at_random()?,
            #[cfg(feature = "comparison")]
            Algorithm::Fortune => self.sweep_beach_line()?,
            #[cfg(feature = "comparison")]
            Algorithm::Sweep2005 => self.sweep_without_artificial()?,
        };
        if !is_swept && self.delaunay.predicates.vertices.len() > 0 {
            self.divide_and_conquer()?;
        }
        self.delaunay.probe.begin(Phase::Finalization);
        self.insert_pending()?;
        self.insert_deferred()
    }

    /// Sweeps, and completes the hull. Returns false if the budget is spent.
    fn sweep_to_hull(&mut self, progress: Progress<'_>) -> Result<bool, Error> {
        if !self.sweep(progress)? {
            return Ok(false);
        }
        let n = self.delaunay.predicates.vertices.len();
        self.delaunay.flip_limit.grant_for_hull(n);
        self.complete_hull();
        Ok(!self.delaunay.flip_limit.is_spent())
    }

    /// Sweeping (section 3.4): stops at every vertex, for a point event and the edges that end there. Returns false if
    /// the budget is spent.
    fn sweep(&mut self, mut progress: Progress<'_>) -> Result<bool, Error> {
        self.delaunay.probe.begin(Phase::Sweeping);
        let n = self.delaunay.predicates.vertices.len();
        for v in (0..n).map(VertexId::at) {
            // The first vertex is in the first triangle.
            if v != VertexId::new(0) {
                self.point_event(v);
            }
            if !self.edges.at(v).is_empty() {
                self.edge_event(v)?;
            }
            if v.number() % EVENTS_BETWEEN_LOOKS == 0 {
                self.delaunay
                    .flip_limit
                    .grant_for_vertices(EVENTS_BETWEEN_LOOKS);
                if self.delaunay.flip_limit.is_spent() {
                    return Ok(false);
                }
                if v.number() % EVENTS_BETWEEN_REPORTS == 0
                    && let Some(progress) = &mut progress
                {
                    progress(v.index(), n);
                }
            }
        }
        Ok(true)
    }
}

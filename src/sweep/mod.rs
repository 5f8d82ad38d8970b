//! The sweep (section 3): initialization, point events and edge events in sweep order, finalization.
//!
//! | section | figure | what | file |
//! |---|---|---|---|
//! | 3.2 | | the three parts; the state between two events | `mod.rs`, [`state`] |
//! | 3.3 | | initialization | [`initialization`] |
//! | 3.3 | | distinct points in sweep order | [`vertices`] |
//! | 3.3 | 5 | edges at their upper ends | [`edges`] |
//! | 3.3 | 6 | P-1 and P-2, first triangle | [`artificial`], [`initialization`] |
//! | 3.4.1 | 7, 8 | point event: projection, middle and left case | [`point_event`] |
//! | 3.4.1 (i), (ii) | 9, 10 | heuristics: narrow corners, basins | [`narrow_corners`], [`basins`] |
//! | 3.4.2 | | edge event: pockets under the edge, parts of it, constrained sides | [`edge_event`] |
//! | 3.4.2 (i), (ii) | 11, 13, 14 | triangle and front traversal | [`traversal`] |
//! | 3.4.2 (ii), (iii) | 12 | removed triangles, pseudo-polygons | [`delaunay`] (`cavity.rs`) |
//! | 3.4.2, 3.5 | 12, 13, 15a | filling a chain up to its hull | [`delaunay`] (`fill.rs`) |
//! | 2 | 2, 3 | empty circle test and its ties, legalization | [`predicates`], [`delaunay`] (`legalization.rs`) |
//! | 3.5 | 15 | finalization | [`finalization`] |
//!
//! The mesh is [`crate::mesh`], the front and its hash table (3.4.1) are [`crate::front`], and the settings of the
//! heuristics [`crate::Heuristics`]. docs/architecture.md lists the files beside the paper.
//! Each file names its differences from it.
//!
//! Cost: about O(n log n) on ordinary inputs. O(n^2) at worst: on some inputs every algorithm that keeps a Delaunay
//! triangulation of the points swept so far must make that many flips. Then the sweep is abandoned ([`flip_limit`]),
//! unless the caller forbids it.

mod artificial;
#[cfg(feature = "parallel")]
mod bands;
mod basins;
#[cfg(feature = "comparison")]
mod comparison;
mod contradiction;
mod delaunay;
mod divide_and_conquer;
mod edge_event;
mod edges;
mod finalization;
mod first_crossing;
mod flip_limit;
mod initialization;
mod narrow_corners;
mod point_event;
mod polygon;
mod predicates;
mod separate;
mod state;
mod traversal;
mod vertex_triangles;
mod vertices;
mod waiting_edges;

use core::mem::take;

use crate::error::Error;
use crate::front::{Front, Search};
use crate::ids::VertexId;
use crate::observe::probe::{Observer, Probe};
use crate::observe::recorder::Phase;
use crate::scalar::{ExactPoints, Scalar};
use crate::settings::{Algorithm, Heuristics, Progress, Settings};
use crate::triangulation::Triangulation;
use crate::triangulation::edge_chains::EdgeChainBuilder;
use crate::tuning::{EVENTS_BETWEEN_LOOKS, EVENTS_BETWEEN_REPORTS};
use crate::watch::Watch;
#[cfg(feature = "parallel")]
pub(crate) use bands::run as run_in_bands;
use delaunay::Delaunay;
pub(crate) use polygon::{PolygonScratch, triangulate_rings};
pub(crate) use separate::{Separated, separate};
pub(crate) use state::Scratch;
use state::{Lists, NewVertex};
use traversal::Traversed;
use waiting_edges::WaitingEdges;

/// Runs the three parts of section 3.2, or divide and conquer in place of the first two.
pub(crate) fn run<S: Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    settings: Settings,
    mut watch: Watch<'_>,
    scratch: &mut Scratch,
) -> Result<Triangulation, Error> {
    let (events, stats) = (watch.events.take(), watch.stats.take());
    let is_watched = stats.is_some() || events.is_some();
    let mut observer = is_watched.then(|| Observer::of(events));
    if let Some(observer) = &mut observer {
        observer.recorder.clock(Phase::Initialization);
    }
    initialization::initialize(points, edges, settings.tuning, scratch)?;
    let (result, observer) = run_observed(&points, settings, watch, observer, scratch)?;
    if let (Some(stats), Some(observer)) = (stats, observer) {
        *stats = observer.recorder.finish(points.len(), edges.len(), &result);
    }
    Ok(result)
}

/// Triangulates the vertices and edges that are in `scratch`. What follows the initialization knows neither the scalar nor
/// the search structure by type: so this crate compiles the sweep twice, and no crate that uses it once more.
#[inline(never)]
fn run_observed<'o>(
    points: &dyn ExactPoints,
    settings: Settings,
    watch: Watch<'_>,
    observer: Option<Observer<'o>>,
    scratch: &mut Scratch,
) -> Result<(Triangulation, Option<Observer<'o>>), Error> {
    match observer {
        None => Ok((run_probed(points, settings, watch, (), scratch)?.0, None)),
        Some(observer) => {
            let (result, observer) = run_probed(points, settings, watch, observer, scratch)?;
            Ok((result, Some(observer)))
        }
    }
}

fn run_probed<P: Probe>(
    points: &dyn ExactPoints,
    settings: Settings,
    watch: Watch<'_>,
    probe: P,
    scratch: &mut Scratch,
) -> Result<(Triangulation, P), Error> {
    let front = watch.front.map(|front| front as _);
    let mut sweep = initialization::begin(points, settings, front, probe, scratch);
    let result = sweep
        .triangulate(settings, watch.progress)
        .map(|()| sweep.finalize());
    let (arrays, probe) = sweep.give_back();
    scratch.arrays = arrays;
    if result.is_err() {
        scratch.ends = take(&mut scratch.arrays.chains).into_ends();
    }
    Ok((result?, probe))
}

/// The state between two events.
#[derive(Debug)]
struct Sweep<'a, P> {
    delaunay: Delaunay<'a, P>,
    front: Front,
    search: Search<'a>,
    heuristics: Heuristics,
    lists: &'a mut Lists,
    /// For the result: the vertices along each edge inserted so far.
    chains: EdgeChainBuilder,
    waiting: WaitingEdges,
    traversed: Traversed,
}

impl<P: Probe> Sweep<'_, P> {
    /// Triangulates up to the hull, with all edges, artificial triangles around it.
    fn triangulate(&mut self, settings: Settings, progress: Progress<'_>) -> Result<(), Error> {
        match self.triangulate_in_any_order(settings, progress) {
            Err(Error::CrossingEdges { .. }) if self.waiting.any_deferred() => {
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
            Algorithm::Auto | Algorithm::Sweep | Algorithm::Paper => self.sweep(progress)?,
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
        self.insert_waiting()
    }

    /// Sweeping (section 3.4): stops at every vertex, for a point event and the edges that end there. Then completes
    /// the hull. Returns false if the budget is spent.
    fn sweep(&mut self, mut progress: Progress<'_>) -> Result<bool, Error> {
        self.delaunay.probe.begin(Phase::Sweeping);
        let n = self.delaunay.predicates.vertices.len();
        for v in (0..n).map(VertexId::at) {
            // The first vertex is in the first triangle.
            if v != VertexId::new(0) {
                self.point_event(v);
            }
            if !self.lists.edges.at(v).is_empty() {
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
        self.delaunay.flip_limit.grant_for_hull(n);
        self.complete_hull();
        Ok(!self.delaunay.flip_limit.is_spent())
    }
}

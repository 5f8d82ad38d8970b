//! Bands: the sweep on all cores.
//!
//! The points are cut into bands by their heights ([`cut`], [`partition`]). A thread sweeps each band, with the edges
//! that run within it ([`band`]), and encloses it in ghosts. Then neighbouring bands are merged as in divide and
//! conquer, and the edges from band to band are inserted ([`join`], [`across`]).
//!
//! Why it is right: the points and edges have one triangulation (the canonical rule), and every step leads to the one
//! of all that has been joined so far. Cost: that of the sweep, divided among the threads, and O(n) to join n vertices.
//! One thread alone legalizes along the gaps and inserts the edges from band to band.

mod across;
mod band;
mod cut;
mod join;
mod partition;

use alloc::sync::Arc;
use alloc::vec::Vec;

use rayon::prelude::*;

use super::initialization::LIMIT;
use super::state::Scratch;
use super::vertices::ApproxPoints;
use crate::front::FrontSearch;
use crate::ids::VertexId;
use crate::memory::{has_room, of_bands};
use crate::observe::probe::{Observer, Probe};
use crate::observe::recorder::{Phase, Recorder};
use crate::scalar::{ExactPoints, Scalar};
use crate::settings::Settings;
use crate::threads::in_pool;
use crate::triangulation::Triangulation;
use crate::tuning::{MANY_ACROSS, MOST_BANDS};
use band::{Band, Shared, Swept};
use partition::Partition;

/// The search structures that the caller gives, one for each band, or none.
type Fronts<'f, 'a> = &'f mut [&'a mut (dyn FrontSearch + Send)];

/// Triangulates in `bands` bands, at least two, on the current rayon pool. Returns the result with what was counted, if
/// anything is to be. `None` where only [`super::run`] can say what is wrong, or is as fast.
pub(crate) fn run<S: Scalar + Sync>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    settings: Settings,
    fronts: Fronts<'_, '_>,
    counts: bool,
    bands: usize,
) -> Option<(Triangulation, Option<Recorder>)> {
    // All bands together have a few triangles more than one sweep. One sweep may have room where they have none.
    let is_large = points.len() + bands > LIMIT || edges.len() > LIMIT;
    if is_large || !has_room(of_bands(points.len(), edges.len())) {
        return None;
    }
    let mut result = None;
    // All else runs on threads of the pool. Otherwise this thread would wake them for each step, and some systems start
    // a woken thread on the core of the thread that woke it.
    in_pool(&mut || {
        let mut observer = counts.then(Observer::default);
        if let Some(observer) = &mut observer {
            observer.recorder.clock(Phase::Initialization);
        }
        let partition = ApproxPoints::new_parallel(points)
            .map(|located| Partition::new(&located, bands.min(MOST_BANDS), settings.tuning));
        if let Ok(partition) = partition {
            let given = Given {
                points: &points,
                count: points.len(),
                edges,
                settings,
                fronts: &mut *fronts,
            };
            result = sweep_observed_bands(given, partition, observer);
        }
    });
    result
}

/// What a run in bands is given: the points and how many they are, the edges, the settings, and the search structures.
struct Given<'a, 'f> {
    points: &'a (dyn ExactPoints + Sync),
    count: usize,
    edges: &'a [[usize; 2]],
    settings: Settings,
    fronts: Fronts<'a, 'f>,
}

/// [`sweep_bands`], which is compiled in this crate, whatever the scalar.
#[inline(never)]
fn sweep_observed_bands(
    given: Given<'_, '_>,
    partition: Partition,
    observer: Option<Observer<'_>>,
) -> Option<(Triangulation, Option<Recorder>)> {
    match observer {
        None => Some((sweep_bands(given, partition, ())?.0, None)),
        Some(observer) => {
            let (triangulation, observer) = sweep_bands(given, partition, observer)?;
            Some((triangulation, Some(observer.recorder)))
        }
    }
}

/// Sweeps the bands with their edges, and joins them.
fn sweep_bands<P: Probe>(
    Given {
        points,
        count,
        edges,
        settings,
        fronts,
    }: Given<'_, '_>,
    partition: Partition,
    mut probe: P,
) -> Option<(Triangulation, P)> {
    let (first, last) = (&partition.first, partition.bands.len());
    if last < 2 {
        return None;
    }
    let edges = partition.split_edges(count, edges)?;
    if edges.crossing.len() > MANY_ACROSS + count / 8 {
        return None;
    }
    let shared = Shared {
        points,
        inputs: Arc::new(edges.inputs),
        outside: VertexId::at(first[last]),
        settings,
        counts: P::RECORDS,
    };
    let mut fronts = fronts.iter_mut();
    let parts = partition.bands.into_iter().zip(edges.local);
    let sorted: Vec<Band<'_>> = parts
        .zip(first)
        .map(|((vertices, edges), &first)| Band {
            vertices,
            edges,
            first,
            front: fronts.next().map(|front| &mut **front as _),
        })
        .collect();
    probe.begin(Phase::Sweeping);
    let swept: Vec<Swept> = sorted
        .into_par_iter()
        .map(|band| shared.sweep(band))
        .collect::<Result<_, _>>()
        .ok()?;
    drop(shared);
    probe.begin(Phase::Finalization);
    let mut scratch = Scratch::default();
    let mut sweep = join::join(points, swept, edges.crossing, settings, probe, &mut scratch)?;
    let triangulation = sweep.finalize();
    Some((triangulation, sweep.give_back().1))
}

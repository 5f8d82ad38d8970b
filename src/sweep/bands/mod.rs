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

use super::RunProbe;
use super::initialization::LIMIT;
use super::scratch::Lent;
use super::vertices::ApproxPoints;
use crate::front::Search;
use crate::ids::VertexId;
use crate::memory::{has_room, of_bands};
use crate::observe::probe::Observer;
use crate::observe::recorder::{Phase, Recorder};
use crate::scalar::{ExactPoints, Scalar};
use crate::settings::{Algorithm, Heuristics, Settings, Ties};
use crate::threads::in_pool;
use crate::triangulation::Triangulation;
use band::{Band, Shared, Structure, Swept};
use partition::Partition;

/// The greatest number of bands of any use: each band takes some memory for each chunk of points.
const MOST: usize = 256;
/// How many edges from band to band, beyond one for every eight points, make bands no gain: one thread inserts them.
const MANY_ACROSS: usize = 10_000;

/// Triangulates in `bands` bands, at least two, each with a search structure of its own, on the current rayon pool and
/// without reports of progress. Returns the result with the counts. `None` where only [`super::run`] can say what is
/// wrong, or is as fast.
pub(crate) fn run<'f, S: Scalar + Sync, P: BandProbe>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    settings: Settings<'_>,
    structure: &mut (dyn FnMut() -> Structure<'f> + Send),
    bands: usize,
) -> Option<(Triangulation, P::Counts)> {
    // All bands together have a few triangles more than one sweep. One sweep may have room where they have none.
    let is_large = points.len() + bands > LIMIT || edges.len() > LIMIT;
    if is_large || !has_room(of_bands(points.len(), edges.len())) {
        return None;
    }
    let choice = (settings.algorithm, settings.heuristics);
    let mut result = None;
    // All else runs on threads of the pool. Otherwise this thread would wake them for each step, and some systems start
    // a woken thread on the core of the thread that woke it.
    in_pool(&mut || {
        let mut probe = P::default();
        probe.begin(Phase::Initialization);
        let partition = ApproxPoints::new_parallel(points)
            .map(|located| Partition::new(&located, bands.min(MOST)));
        if let Ok(partition) = partition {
            let given = Given {
                points: &points,
                count: points.len(),
                edges,
                choice,
                structure,
            };
            result = probe.sweep_bands(given, partition);
        }
    });
    result
}

/// What a run in bands is given: the points and how many they are, the edges, the settings, and what makes the search
/// structure of each band.
pub(crate) struct Given<'a, 'f> {
    points: &'a (dyn ExactPoints + Sync),
    count: usize,
    edges: &'a [[usize; 2]],
    choice: (Algorithm, Heuristics),
    structure: &'a mut (dyn FnMut() -> Structure<'f> + Send),
}

/// A probe of one band or of all, for which [`sweep_bands`] is compiled in this crate.
pub(crate) trait BandProbe: RunProbe + Default {
    /// What a band's thread sends to the one that joins the bands.
    type Counts: Send;

    fn counts(self) -> Self::Counts;

    /// Adds the counts of a band whose triangles come after the first `triangles` of all bands.
    fn add(&mut self, counts: Self::Counts, triangles: usize);

    /// Calls [`sweep_bands`].
    fn sweep_bands(
        self,
        given: Given<'_, '_>,
        partition: Partition,
    ) -> Option<(Triangulation, Self::Counts)>;
}

macro_rules! band_probe {
    ($probe:ty, $counts:ty, $($methods:tt)*) => {
        impl BandProbe for $probe {
            type Counts = $counts;

            $($methods)*

            #[inline(never)]
            fn sweep_bands(
                self,
                given: Given<'_, '_>,
                partition: Partition,
            ) -> Option<(Triangulation, Self::Counts)> {
                sweep_bands(given, partition, self)
            }
        }
    };
}

band_probe! { (), (),
    fn counts(self) {}

    fn add(&mut self, (): (), _triangles: usize) {}
}

band_probe! { Observer<'_>, Recorder,
    fn counts(self) -> Recorder {
        self.recorder
    }

    fn add(&mut self, counts: Recorder, triangles: usize) {
        self.recorder.add_band(counts, triangles);
    }
}

/// Sweeps the bands with their edges, and joins them.
fn sweep_bands<P: BandProbe>(
    Given {
        points,
        edges,
        count,
        choice: (algorithm, heuristics),
        structure,
    }: Given<'_, '_>,
    partition: Partition,
    mut probe: P,
) -> Option<(Triangulation, P::Counts)> {
    let settings = || Settings {
        algorithm,
        heuristics,
        progress: None,
        ties: Ties::default(),
    };
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
    };
    let parts = partition.bands.into_iter().zip(edges.local);
    let sorted: Vec<Band<'_>> = parts
        .zip(first)
        .map(|((vertices, edges), &first)| Band {
            vertices,
            edges,
            first,
            search: structure(),
        })
        .collect();
    probe.begin(Phase::Sweeping);
    let sweep = |band| shared.sweep::<P>(band, settings());
    let swept: Vec<Swept<P::Counts>> = sorted
        .into_par_iter()
        .map(sweep)
        .collect::<Result<_, _>>()
        .ok()?;
    drop(shared);
    probe.begin(Phase::Finalization);
    let (mut lent, mut search) = (Lent::default(), structure());
    let search = Search::with(&mut *search);
    let crossing = edges.crossing;
    let mut sweep = join::join(
        points,
        swept,
        crossing,
        settings(),
        search,
        probe,
        &mut lent,
    )?;
    let triangulation = sweep.finalize();
    let (_, probe) = sweep.give_back();
    Some((triangulation, probe.counts()))
}

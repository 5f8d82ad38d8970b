//! The call with all its settings.

#[cfg(feature = "parallel")]
use alloc::boxed::Box;
use core::fmt;

use crate::error::Error;
use crate::front::{FrontSearch, HashTable};
use crate::observe::probe::Observer;
use crate::observe::recorder::Recorder;
use crate::observe::stats::Stats;
use crate::scalar::Scalar;
use crate::session::Session;
use crate::settings::{Algorithm, Heuristics, Settings, Ties};
#[cfg(feature = "parallel")]
use crate::sweep::BandProbe;
use crate::sweep::{self, RunProbe, Scratch};
#[cfg(feature = "parallel")]
use crate::threads::has_threads;
use crate::trace::Event;
use crate::triangulation::Triangulation;

/// A band has at least so many points.
#[cfg(feature = "parallel")]
const LEAST: usize = 50_000;

/// Triangulates with the settings of your choice, any number of times. They change the work, never the result.
///
/// ```
/// use sweep_cdt::front::SkipList;
/// use sweep_cdt::{Heuristics, Triangulator};
///
/// let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [1.0, 0.2]];
/// let triangulator = Triangulator::new()
///     .front(SkipList::default())
///     .heuristics(Heuristics::PAPER);
/// let run = triangulator.triangulate_with_stats(&points, &[[0, 1]])?;
/// assert_eq!((run.triangulation.len(), run.stats.triangles), (3, 3));
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[derive(Clone)]
pub struct Triangulator<'p, F = HashTable> {
    settings: Settings<'p>,
    front: F,
    #[cfg(feature = "parallel")]
    bands: Option<usize>,
}

/// A result, the statistics of the run, and the front's search structure as the run left it.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Run<F> {
    /// The result.
    pub triangulation: Triangulation,
    /// The statistics of the run.
    pub stats: Stats,
    /// The search structure, with whatever it counted.
    pub front: F,
}

impl Triangulator<'_> {
    /// The defaults: hash table, fastest heuristics, no progress report.
    pub fn new() -> Self {
        Triangulator {
            settings: Settings {
                algorithm: Algorithm::default(),
                heuristics: Heuristics::default(),
                progress: None,
                ties: Ties::default(),
            },
            front: HashTable::default(),
            #[cfg(feature = "parallel")]
            bands: None,
        }
    }
}

impl Default for Triangulator<'_> {
    fn default() -> Self {
        Self::new()
    }
}

impl<F: fmt::Debug> fmt::Debug for Triangulator<'_, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Triangulator")
            .field("algorithm", &self.settings.algorithm)
            .field("heuristics", &self.settings.heuristics)
            .field("front", &self.front)
            .finish_non_exhaustive()
    }
}

impl<'p, F> Triangulator<'p, F> {
    /// Uses another search structure for the advancing front, with its parameters. Each run works on a clone of
    /// `front`, which [`Run::front`] holds afterwards.
    #[must_use]
    pub fn front<G: FrontSearch + Clone>(self, front: G) -> Triangulator<'p, G> {
        Triangulator {
            settings: self.settings,
            front,
            #[cfg(feature = "parallel")]
            bands: self.bands,
        }
    }

    /// Uses this algorithm.
    #[must_use]
    pub fn algorithm(mut self, algorithm: Algorithm) -> Self {
        self.settings.algorithm = algorithm;
        self
    }

    /// Uses these heuristics; [`Heuristics`] says what [`Algorithm::Auto`] makes of them.
    #[must_use]
    pub fn heuristics(mut self, heuristics: Heuristics) -> Self {
        self.settings.heuristics = heuristics;
        self
    }

    /// Calls `progress(swept, vertices)` every few thousand point events.
    #[must_use]
    pub fn progress(mut self, progress: &'p dyn Fn(usize, usize)) -> Self {
        self.settings.progress = Some(progress);
        self
    }
}

#[cfg(feature = "parallel")]
impl<F: FrontSearch + Clone + Send> Triangulator<'_, F> {
    /// Cuts the points into `bands` bands, from bottom to top, for
    /// [`triangulate_parallel`](Triangulator::triangulate_parallel). By default there is one for each thread, but none
    /// has fewer than 50,000 points. There are at most 256.
    #[must_use]
    pub fn bands(mut self, bands: usize) -> Self {
        self.bands = Some(bands);
        self
    }

    /// [`triangulate`](Triangulator::triangulate) on all threads of the current rayon pool.
    ///
    /// The points are cut into bands, which are swept at the same time and then joined. The result is the same, but for
    /// the numbers of the triangles. The call takes up to half more memory at its peak, and reports no progress. Few
    /// points are triangulated on one thread. Where edges cross, where many run from band to band, or where joining the
    /// bands would take too many flips, one thread begins anew.
    ///
    /// # Errors
    /// See [`Error`]; the same as on one thread.
    ///
    /// ```
    /// use sweep_cdt::Triangulator;
    ///
    /// let points: Vec<_> = (0..1000).map(|i| [i * i % 997, i]).collect();
    /// let edges = [[0, 999], [3, 4]];
    /// let triangulator = Triangulator::new();
    /// let one = triangulator.triangulate(&points, &edges)?;
    /// let all = triangulator.bands(3).triangulate_parallel(&points, &edges)?;
    /// assert_eq!(all.canonical_triangles(), one.canonical_triangles());
    /// # Ok::<(), sweep_cdt::Error>(())
    /// ```
    pub fn triangulate_parallel<S: Scalar + Sync>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
    ) -> Result<Triangulation, Error> {
        match self.run_in_bands::<S, ()>(points, edges) {
            Some((triangulation, ())) => Ok(triangulation),
            None => self.triangulate(points, edges),
        }
    }

    /// [`triangulate_parallel`](Triangulator::triangulate_parallel) with statistics.
    ///
    /// The counters are those of all bands together and of joining them; the most of something is the most of one band.
    /// Sweeping is timed from the first band's start to the last one's end; finalization is what joins the bands. Where
    /// one thread has begun anew, the statistics are its own.
    ///
    /// # Errors
    /// See [`Error`]; the same as on one thread.
    ///
    /// ```
    /// use sweep_cdt::Triangulator;
    ///
    /// let points: Vec<_> = (0..1000).map(|i| [i * i % 997, i]).collect();
    /// let triangulator = Triangulator::new().bands(3);
    /// let (all, stats) = triangulator.triangulate_parallel_with_stats(&points, &[[0, 999]])?;
    /// assert_eq!(all.len() as u64, stats.counters.survived.sum());
    /// # Ok::<(), sweep_cdt::Error>(())
    /// ```
    pub fn triangulate_parallel_with_stats<S: Scalar + Sync>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
    ) -> Result<(Triangulation, Stats), Error> {
        match self.run_in_bands::<S, Observer<'_>>(points, edges) {
            Some((triangulation, recorder)) => {
                let stats = recorder.finish(points.len(), edges.len(), &triangulation);
                Ok((triangulation, stats))
            }
            None => {
                let run = self.triangulate_with_stats(points, edges)?;
                Ok((run.triangulation, run.stats))
            }
        }
    }

    /// `None` where one thread is to triangulate.
    fn run_in_bands<S: Scalar + Sync, P: BandProbe>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
    ) -> Option<(Triangulation, P::Counts)> {
        // Rayon panics where it cannot start its threads.
        if !has_threads() {
            return None;
        }
        let most = rayon::current_num_threads();
        let bands = self.bands.unwrap_or(most.min(points.len() / LEAST));
        let bands = bands.min(points.len() / 2);
        if bands < 2 {
            return None;
        }
        let front = self.front.clone();
        let structure = &mut move || Box::new(front.clone()) as _;
        sweep::run_in_bands::<S, P>(points, edges, self.settings, structure, bands)
    }
}

impl<'p, F: FrontSearch + Clone> Triangulator<'p, F> {
    /// The constrained Delaunay triangulation of `points` with `edges`, as [`crate::triangulate`].
    ///
    /// # Errors
    /// See [`Error`].
    pub fn triangulate<S: Scalar>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
    ) -> Result<Triangulation, Error> {
        let (triangulation, ()) = self.run(points, edges, &mut self.front.clone(), ())?;
        Ok(triangulation)
    }

    /// Triangulates many inputs, one after the other, in the same memory.
    pub fn session(self) -> Session<'p, F> {
        Session::new(self.settings, self.front)
    }

    /// [`triangulate`](Triangulator::triangulate) with statistics; counting costs a few per cent of the time.
    ///
    /// # Errors
    /// See [`Error`].
    pub fn triangulate_with_stats<S: Scalar>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
    ) -> Result<Run<F>, Error> {
        self.record(points, edges, None)
    }

    /// Triangulates with statistics, and passes every step to `observer` as it happens.
    ///
    /// The steps are those of the sweep, which [`Algorithm::Auto`] does not abandon here. The other algorithms pass on
    /// the steps of their edge events alone, which are no trace that can be replayed. Edges are inserted in the paper's
    /// order. Other runs defer edges that pierce many triangles, so that their counters and the order of their triangles
    /// can differ.
    ///
    /// # Errors
    /// See [`Error`]; the steps before it have been reported.
    pub fn observe<S: Scalar>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        mut observer: impl FnMut(Event),
    ) -> Result<Run<F>, Error> {
        self.record(points, edges, Some(&mut observer))
    }

    fn record<S: Scalar>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        events: Option<&mut dyn FnMut(Event)>,
    ) -> Result<Run<F>, Error> {
        let mut front = self.front.clone();
        let recorder = Recorder::default();
        let probe = Observer { recorder, events };
        let (triangulation, probe) = self.run(points, edges, &mut front, probe)?;
        let (points, edges) = (points.len(), edges.len());
        let stats = probe.recorder.finish(points, edges, &triangulation);
        Ok(Run {
            triangulation,
            stats,
            front,
        })
    }
}

impl<F> Triangulator<'_, F> {
    fn run<S: Scalar, P: RunProbe>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        front: &mut dyn FrontSearch,
        probe: P,
    ) -> Result<(Triangulation, P), Error> {
        let mut settings = self.settings;
        if probe.wants_events() {
            settings.algorithm = settings.algorithm.observed();
        }
        let scratch = &mut Scratch::default();
        sweep::run(points, edges, settings, front, probe, scratch)
    }
}

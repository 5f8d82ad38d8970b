//! The call with all its settings.

use crate::error::Error;
#[cfg(feature = "parallel")]
use crate::front::FrontSearch;
use crate::scalar::Scalar;
use crate::session::Session;
use crate::settings::{Algorithm, Heuristics, Settings};
use crate::sweep::{self, Scratch};
use crate::triangulation::Triangulation;
use crate::tuning::Tuning;
#[cfg(feature = "parallel")]
use crate::watch::Bands;
use crate::watch::Watch;

/// Triangulates with the settings of your choice, any number of times. They change the work, never the result.
///
/// ```
/// use sweep_cdt::{Heuristics, Triangulator};
///
/// let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [1.0, 0.2]];
/// let triangulator = Triangulator::new().heuristics(Heuristics::PAPER);
/// assert_eq!(triangulator.triangulate(&points, &[[0, 1]])?.len(), 3);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Triangulator {
    settings: Settings,
}

impl Triangulator {
    /// The defaults: [`Algorithm::Auto`] with the fastest heuristics.
    pub fn new() -> Self {
        Self::default()
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

    /// Uses these thresholds. For tests.
    #[doc(hidden)]
    #[must_use]
    pub fn tuning(mut self, tuning: &'static Tuning) -> Self {
        self.settings.tuning = tuning;
        self
    }

    /// The constrained Delaunay triangulation of `points` with `edges`, as [`crate::triangulate`].
    ///
    /// # Errors
    /// See [`Error`].
    pub fn triangulate<S: Scalar>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
    ) -> Result<Triangulation, Error> {
        self.run(points, edges, Watch::new())
    }

    /// [`triangulate`](Triangulator::triangulate) with a search structure of your choice, statistics, steps or reports of
    /// progress: see [`Watch`].
    ///
    /// # Errors
    /// See [`Error`]; the steps before it have been passed on.
    pub fn run<S: Scalar>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        watch: Watch<'_>,
    ) -> Result<Triangulation, Error> {
        sweep::run(points, edges, self.settings, watch, &mut Scratch::default())
    }

    /// Triangulates many inputs, one after the other, in the same memory.
    pub fn session(&self) -> Session {
        Session::new(self.settings)
    }
}

#[cfg(feature = "parallel")]
impl Triangulator {
    /// [`triangulate`](Triangulator::triangulate) on all threads of the current rayon pool.
    ///
    /// The points are cut into bands, which are swept at the same time and then joined. The result is the same, but for
    /// the numbers of the triangles. The call takes up to half more memory at its peak. Few points are triangulated on one
    /// thread. Where edges cross, where many run from band to band, or where joining the bands would take too many flips,
    /// one thread begins anew. [`Bands`] has what belongs to one call.
    ///
    /// # Errors
    /// See [`Error`]; the same as on one thread.
    ///
    /// ```
    /// use sweep_cdt::{Bands, Stats, Triangulator};
    ///
    /// let points: Vec<_> = (0..1000).map(|i| [i * i % 997, i]).collect();
    /// let edges = [[0, 999], [3, 4]];
    /// let triangulator = Triangulator::new();
    /// let one = triangulator.triangulate(&points, &edges)?;
    /// let mut stats = Stats::default();
    /// let bands = Bands::new().count(3).stats(&mut stats);
    /// let all = triangulator.triangulate_parallel(&points, &edges, bands)?;
    /// assert_eq!(all.canonical_triangles(), one.canonical_triangles());
    /// assert_eq!(all.len() as u64, stats.counters.survived.sum());
    /// # Ok::<(), sweep_cdt::Error>(())
    /// ```
    pub fn triangulate_parallel<S: Scalar + Sync>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        mut bands: Bands<'_>,
    ) -> Result<Triangulation, Error> {
        let (count, settings) = (bands.count_for(points.len()), self.settings);
        if count >= 2 {
            let (fronts, counts) = (&mut bands.fronts[..], bands.stats.is_some());
            let run = sweep::run_in_bands(points, edges, settings, fronts, counts, count);
            if let Some((triangulation, recorder)) = run {
                if let (Some(stats), Some(recorder)) = (bands.stats, recorder) {
                    *stats = recorder.finish(points.len(), edges.len(), &triangulation);
                }
                return Ok(triangulation);
            }
        }
        let fronts = bands.fronts.into_iter();
        let watch = Watch {
            front: fronts.map(|front| front as &mut dyn FrontSearch).next(),
            stats: bands.stats,
            ..Watch::new()
        };
        self.run(points, edges, watch)
    }
}

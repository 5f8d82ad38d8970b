//! The call with all its knobs.

use std::fmt;
use std::marker::PhantomData;

use crate::probe::{Observer, Probe};
use crate::stats::Counters;
use crate::trace::Event;
use crate::{Error, FrontSearch, HashTable, Heuristics, Scalar, Stats, Triangulation, sweep};

/// Triangulates with a front, heuristics and progress report of one's choice.
///
/// None of the settings changes the result, only the work.
///
/// ```
/// use sweep_cdt::{Heuristics, SkipList, Triangulator};
///
/// let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [1.0, 0.2]];
/// let (result, stats) = Triangulator::new()
///     .front::<SkipList>()
///     .heuristics(Heuristics::PAPER)
///     .triangulate_with_stats(&points, &[[0, 1]])?;
/// assert_eq!((result.len(), stats.triangles), (3, 3));
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
pub struct Triangulator<'p, F = HashTable> {
    heuristics: Heuristics,
    progress: Progress<'p>,
    front: PhantomData<F>,
}

/// Who is told how far the sweep has come.
pub(crate) type Progress<'p> = Option<&'p mut dyn FnMut(usize, usize)>;

impl<'p> Triangulator<'p> {
    /// The defaults: hash table, fastest heuristics, no report.
    pub fn new() -> Self {
        Triangulator {
            heuristics: Heuristics::default(),
            progress: None,
            front: PhantomData,
        }
    }
}

impl Default for Triangulator<'_> {
    fn default() -> Self {
        Self::new()
    }
}

impl<F> fmt::Debug for Triangulator<'_, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Triangulator")
            .field("heuristics", &self.heuristics)
            .finish_non_exhaustive()
    }
}

impl<'p, F: FrontSearch> Triangulator<'p, F> {
    /// Uses another search structure for the advancing front.
    #[must_use]
    pub fn front<G: FrontSearch>(self) -> Triangulator<'p, G> {
        Triangulator {
            heuristics: self.heuristics,
            progress: self.progress,
            front: PhantomData,
        }
    }

    /// Uses these heuristics.
    #[must_use]
    pub fn heuristics(self, heuristics: Heuristics) -> Self {
        Triangulator { heuristics, ..self }
    }

    /// Calls `progress(swept, vertices)` every few thousand point events.
    #[must_use]
    pub fn progress(self, progress: &'p mut dyn FnMut(usize, usize)) -> Self {
        Triangulator {
            progress: Some(progress),
            ..self
        }
    }

    /// The constrained Delaunay triangulation of `points` with `edges`, as [`crate::triangulate`].
    ///
    /// # Errors
    /// See [`Error`].
    pub fn triangulate<S: Scalar>(
        self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
    ) -> Result<Triangulation, Error> {
        Ok(self.run(points, edges, ())?.0)
    }

    /// The same, and what was done for it; counting costs a few per cent of the time.
    ///
    /// # Errors
    /// See [`Error`].
    pub fn triangulate_with_stats<S: Scalar>(
        self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
    ) -> Result<(Triangulation, Stats), Error> {
        let (result, stats, counters) = self.run(points, edges, Counters::default())?;
        Ok((result, Stats { counters, ..stats }))
    }

    /// The same, and every step of it, as it happens, to `observer`.
    ///
    /// # Errors
    /// See [`Error`]; the steps up to it have been told.
    pub fn triangulate_observed<S: Scalar>(
        self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        observer: impl FnMut(Event),
    ) -> Result<Triangulation, Error> {
        Ok(self.run(points, edges, Observer(observer))?.0)
    }

    fn run<S: Scalar, P: Probe>(
        self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        probe: P,
    ) -> Result<(Triangulation, Stats, P), Error> {
        sweep::run::<S, F, P>(points, edges, self.heuristics, self.progress, probe)
    }
}

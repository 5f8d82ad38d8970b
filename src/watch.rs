//! What belongs to one call, beside its input and the settings.

#[cfg(feature = "parallel")]
use alloc::vec::Vec;
use core::fmt;

use crate::front::FrontSearch;
use crate::observe::stats::Stats;
#[cfg(feature = "parallel")]
use crate::threads::has_threads;
use crate::trace::Event;
#[cfg(feature = "parallel")]
use crate::tuning::LEAST_IN_BAND;

/// What one call is given beside its input, for [`Triangulator::run`](crate::Triangulator::run): the search structure of
/// the front, and who is told of what. Nothing of it changes the result.
///
/// ```
/// use sweep_cdt::front::SkipList;
/// use sweep_cdt::{Stats, Triangulator, Watch};
///
/// let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [1.0, 0.2]];
/// let (mut front, mut stats, mut steps) = (SkipList::counting(), Stats::default(), Vec::new());
/// let mut keep = |step| steps.push(step);
/// let watch = Watch::new().front(&mut front).stats(&mut stats).events(&mut keep);
/// let result = Triangulator::new().run(&points, &[[0, 1]], watch)?;
/// assert_eq!((result.len(), stats.triangles), (3, 3));
/// println!("{} steps, {} comparisons", steps.len(), front.work().comparisons);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[derive(Default)]
pub struct Watch<'a> {
    pub(crate) front: Option<&'a mut dyn FrontSearch>,
    pub(crate) progress: Option<&'a mut dyn FnMut(usize, usize)>,
    pub(crate) events: Option<&'a mut dyn FnMut(Event)>,
    pub(crate) stats: Option<&'a mut Stats>,
}

impl<'a> Watch<'a> {
    /// The default search structure, and nobody is told of anything.
    pub fn new() -> Self {
        Watch::default()
    }

    /// What lives longer serves for a shorter time, too.
    fn shortened<'b>(self) -> Watch<'b>
    where
        'a: 'b,
    {
        Watch {
            front: self.front.map(|front| front as _),
            progress: self.progress.map(|progress| progress as _),
            events: self.events.map(|events| events as _),
            stats: self.stats,
        }
    }

    /// Uses this search structure for the advancing front. The run begins it anew, and leaves it with whatever it counted.
    #[must_use]
    pub fn front<'b>(self, front: &'b mut dyn FrontSearch) -> Watch<'b>
    where
        'a: 'b,
    {
        Watch {
            front: Some(front),
            ..self.shortened()
        }
    }

    /// Calls `progress(swept, vertices)` every few thousand point events.
    #[must_use]
    pub fn progress<'b>(self, progress: &'b mut dyn FnMut(usize, usize)) -> Watch<'b>
    where
        'a: 'b,
    {
        Watch {
            progress: Some(progress),
            ..self.shortened()
        }
    }

    /// Passes on each step as it happens, up to an error. With [`Algorithm::Paper`](crate::Algorithm::Paper) the steps are
    /// a trace that can be replayed; other algorithms have steps that no event names.
    #[must_use]
    pub fn events<'b>(self, events: &'b mut dyn FnMut(Event)) -> Watch<'b>
    where
        'a: 'b,
    {
        Watch {
            events: Some(events),
            ..self.shortened()
        }
    }

    /// Puts the statistics of a run without error there. Counting costs a few per cent of the time.
    #[must_use]
    pub fn stats<'b>(self, stats: &'b mut Stats) -> Watch<'b>
    where
        'a: 'b,
    {
        Watch {
            stats: Some(stats),
            ..self.shortened()
        }
    }
}

impl fmt::Debug for Watch<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Watch")
            .field("front", &self.front.is_some())
            .field("progress", &self.progress.is_some())
            .field("events", &self.events.is_some())
            .field("stats", &self.stats.is_some())
            .finish()
    }
}

/// What a call on many threads is given beside its input, for
/// [`Triangulator::triangulate_parallel`](crate::Triangulator::triangulate_parallel). It has neither steps nor progress,
/// which belong to one thread.
#[cfg(feature = "parallel")]
#[derive(Default)]
pub struct Bands<'a> {
    count: Option<usize>,
    pub(crate) fronts: Vec<&'a mut (dyn FrontSearch + Send)>,
    pub(crate) stats: Option<&'a mut Stats>,
}

#[cfg(feature = "parallel")]
impl<'a> Bands<'a> {
    /// A band for each thread, but none of fewer than 50,000 points.
    pub fn new() -> Self {
        Bands::default()
    }

    /// Cuts the points into `count` bands, at most 256.
    #[must_use]
    pub fn count(mut self, count: usize) -> Self {
        self.count = Some(count);
        self
    }

    /// Uses these search structures, one for each band; there are no more bands than structures. They are left with
    /// whatever they counted.
    #[must_use]
    pub fn fronts<F: FrontSearch + Send>(mut self, fronts: &'a mut [F]) -> Self {
        self.fronts = fronts.iter_mut().map(|front| front as _).collect();
        self
    }

    /// Puts the statistics there. The counters are those of all bands together and of joining them; the most of something
    /// is the most of one band. Sweeping is timed from the first band's start to the last one's end; finalization is what
    /// joins the bands. Where one thread has begun anew, the statistics are its own.
    #[must_use]
    pub fn stats(mut self, stats: &'a mut Stats) -> Self {
        self.stats = Some(stats);
        self
    }

    /// How many bands this many points are cut into: fewer than two where one thread triangulates.
    pub(crate) fn count_for(&self, points: usize) -> usize {
        // Rayon panics where it cannot start its threads.
        if !has_threads() {
            return 0;
        }
        let count = self
            .count
            .unwrap_or_else(|| rayon::current_num_threads().min(points / LEAST_IN_BAND));
        let count = count.min(points / 2);
        match self.fronts.len() {
            0 => count,
            fronts => count.min(fronts),
        }
    }
}

#[cfg(feature = "parallel")]
impl fmt::Debug for Bands<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Bands")
            .field("count", &self.count)
            .field("fronts", &self.fronts.len())
            .field("stats", &self.stats.is_some())
            .finish()
    }
}

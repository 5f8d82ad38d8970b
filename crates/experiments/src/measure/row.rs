//! A row of the CSV file: what one variant did on one input.

use std::time::Duration;

use serde::{Deserialize, Serialize};
use sweep_cdt::Stats;
use sweep_cdt::front::Work;

use super::watched::Seen;

/// The columns. All up to `repetitions` are the same in every run and on every platform; the others, whose
/// names end in `_ms`, are times.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Row {
    pub(crate) data: String,
    /// The number of points asked for.
    pub(crate) size: usize,
    pub(crate) variant: String,
    /// Whether the variant was left out, as it would have taken too long. Then nothing but points and edges is
    /// counted.
    pub(crate) is_left_out: bool,

    pub(crate) points: usize,
    pub(crate) edges: usize,
    pub(crate) triangles: usize,
    /// A number for the result: equal for all variants on this input, and empty for another program's.
    pub(crate) result: String,
    /// Whether divide and conquer made the result.
    pub(crate) is_divided: bool,

    pub(crate) searches: u64,
    /// Searches that named the very segment, so that no step followed.
    pub(crate) hits: u64,
    pub(crate) front_mean: f64,
    pub(crate) front_max: u64,
    pub(crate) comparisons: Option<u64>,
    pub(crate) visited: Option<u64>,
    pub(crate) updates: Option<u64>,
    pub(crate) rearranged: Option<u64>,
    pub(crate) bytes: Option<u64>,
    pub(crate) front_steps: u64,

    pub(crate) flips: u64,
    pub(crate) legalization_tests: u64,
    pub(crate) most_tests: u64,
    pub(crate) most_flips: u64,
    pub(crate) orientation_tests: u64,
    pub(crate) orientation_exact: u64,
    pub(crate) in_circle_tests: u64,
    pub(crate) in_circle_exact: u64,
    pub(crate) symbolic: u64,
    pub(crate) cocircular: u64,
    pub(crate) left_cases: u64,
    pub(crate) narrow_corners: u64,
    pub(crate) basin_triangles: u64,
    pub(crate) pocket_triangles: u64,
    pub(crate) hull_triangles: u64,
    /// All triangles made but those of flips, and how many of these are in the result; then by what made them.
    pub(crate) made_by_steps: u64,
    pub(crate) survived_of_steps: u64,
    pub(crate) survived_points: u64,
    pub(crate) survived_narrow_corners: u64,
    pub(crate) survived_basins: u64,
    pub(crate) survived_pockets: u64,
    pub(crate) survived_pseudo_polygons: u64,
    pub(crate) survived_hull: u64,
    pub(crate) survived_divided: u64,
    pub(crate) edges_present: u64,
    pub(crate) edges_inserted: u64,
    pub(crate) pierced: u64,

    pub(crate) repetitions: usize,
    /// Medians over the repetitions.
    pub(crate) initialization_ms: f64,
    pub(crate) sweeping_ms: f64,
    pub(crate) finalization_ms: f64,
    pub(crate) total_ms: f64,
    pub(crate) least_ms: f64,
    pub(crate) greatest_ms: f64,
    /// The processor's time of the whole call: median, least and greatest; empty where it is not told.
    pub(crate) processor_ms: Option<f64>,
    pub(crate) processor_least_ms: Option<f64>,
    pub(crate) processor_greatest_ms: Option<f64>,
}

impl Row {
    /// Takes over what the sweep counted.
    pub(super) fn count(&mut self, stats: &Stats) {
        let counters = &stats.counters;
        self.points = stats.points;
        self.edges = stats.edges;
        self.triangles = stats.triangles;
        self.is_divided = stats.is_divided;
        self.front_steps = counters.front_steps;
        self.flips = counters.flips;
        self.legalization_tests = counters.legalization_tests;
        self.most_tests = counters.most_tests;
        self.most_flips = counters.most_flips;
        self.orientation_exact = counters.orient2d_exact();
        self.orientation_tests = counters.orient2d_filtered + counters.orient2d_exact();
        self.in_circle_exact = counters.in_circle_exact();
        self.in_circle_tests = counters.in_circle_filtered + counters.in_circle_exact();
        self.symbolic = counters.symbolic;
        self.cocircular = counters.cocircular;
        self.left_cases = counters.left_cases;
        self.narrow_corners = counters.made.narrow_corners;
        self.basin_triangles = counters.made.basins;
        self.pocket_triangles = counters.made.pockets;
        self.hull_triangles = counters.made.hull;
        let survived = &counters.survived;
        self.made_by_steps = counters.made.sum() - counters.made.flips;
        self.survived_of_steps = survived.sum() - survived.flips;
        self.survived_points = survived.middle + survived.left;
        self.survived_narrow_corners = survived.narrow_corners;
        self.survived_basins = survived.basins;
        self.survived_pockets = survived.pockets;
        self.survived_pseudo_polygons = survived.pseudo_polygons;
        self.survived_hull = survived.hull;
        self.survived_divided = survived.divide_and_conquer;
        self.edges_present = counters.edges_present;
        self.edges_inserted = counters.edges_inserted;
        self.pierced = counters.pierced;
    }

    /// Takes over what was seen of the front.
    pub(super) fn see(&mut self, seen: Seen) {
        self.searches = seen.searches;
        self.hits = seen.hits;
        self.front_mean = seen.lengths as f64 / seen.searches.max(1) as f64;
        self.front_max = seen.greatest_length;
    }

    /// Takes over what the structure counted.
    pub(super) fn work(&mut self, work: Option<Work>) {
        self.comparisons = work.map(|work| work.comparisons);
        self.visited = work.map(|work| work.visited);
        self.updates = work.map(|work| work.updates);
        self.rearranged = work.map(|work| work.rearranged);
        self.bytes = work.map(|work| work.bytes);
    }

    /// Medians and the spread of the times of all repetitions.
    pub(super) fn time(&mut self, runs: &[Timed]) {
        let sorted = |time: &dyn Fn(&Timed) -> Option<Duration>| {
            let mut times: Vec<f64> = runs
                .iter()
                .filter_map(|run| Some(1e3 * time(run)?.as_secs_f64()))
                .collect();
            times.sort_by(f64::total_cmp);
            times
        };
        let median = |times: &[f64]| times.get(times.len() / 2).copied();
        let phase = |time: fn(&Stats) -> Duration| {
            median(&sorted(&|run| Some(time(&run.stats)))).unwrap_or_default()
        };
        self.repetitions = runs.len();
        self.initialization_ms = phase(|stats| stats.initialization);
        self.sweeping_ms = phase(|stats| stats.sweeping);
        self.finalization_ms = phase(|stats| stats.finalization);
        let total = sorted(&|run| {
            let stats = &run.stats;
            Some(stats.initialization + stats.sweeping + stats.finalization)
        });
        self.total_ms = median(&total).unwrap_or_default();
        self.least_ms = total.first().copied().unwrap_or_default();
        self.greatest_ms = total.last().copied().unwrap_or_default();
        let processor = sorted(&|run| run.processor);
        self.processor_ms = median(&processor);
        self.processor_least_ms = processor.first().copied();
        self.processor_greatest_ms = processor.last().copied();
    }

    /// The times by which variants are compared: the processor's, or where it is not told that on the clock.
    /// Median, least and greatest.
    pub(crate) fn times_ms(&self) -> [f64; 3] {
        [
            self.processor_ms.unwrap_or(self.total_ms),
            self.processor_least_ms.unwrap_or(self.least_ms),
            self.processor_greatest_ms.unwrap_or(self.greatest_ms),
        ]
    }

    /// Nanoseconds a point of the median; `None` if no time was measured.
    pub(crate) fn ns_per_point(&self) -> Option<f64> {
        self.per_point(self.times_ms()[0])
    }

    /// Nanoseconds a point of the least time.
    pub(crate) fn least_ns_per_point(&self) -> Option<f64> {
        self.per_point(self.times_ms()[1])
    }

    /// Nanoseconds a point of the phases on the clock together.
    pub(crate) fn phases_ns_per_point(&self) -> Option<f64> {
        self.per_point(self.total_ms)
    }

    fn per_point(&self, ms: f64) -> Option<f64> {
        (self.repetitions > 0).then(|| 1e6 * ms / self.points.max(1) as f64)
    }
}

/// A run whose time counts.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Timed {
    pub(super) stats: Stats,
    pub(super) processor: Option<Duration>,
}

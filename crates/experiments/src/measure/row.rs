//! A row of the CSV files: what one variant did on one input, and how long each of its turns took.

use serde::{Deserialize, Serialize};
use sweep_cdt::Stats;
use sweep_cdt::front::Work;

use super::watched::Seen;

/// The columns of counts, the same in every run; those up to `pierced` on every platform, too.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Row {
    pub(crate) data: String,
    /// The number of points asked for.
    pub(crate) size: usize,
    pub(crate) seed: u64,
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

    /// Of one turn under Cachegrind, and what it depends on; empty where it was not asked for.
    pub(crate) instructions: Option<u64>,
    pub(crate) mispredicted: Option<u64>,
    pub(crate) first_misses: Option<u64>,
    pub(crate) second_misses: Option<u64>,
    pub(crate) built: String,

    /// In a file of their own.
    #[serde(skip)]
    pub(crate) turns: Vec<Turn>,
}

/// The columns of a turn: times on the clock in milliseconds, of the parts of the algorithm and of the whole call, and
/// the processor's time of the call; empty where the system does not tell it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Turn {
    pub(crate) data: String,
    pub(crate) size: usize,
    pub(crate) seed: u64,
    pub(crate) variant: String,
    pub(crate) turn: usize,
    pub(crate) initialization_ms: f64,
    pub(crate) sweeping_ms: f64,
    pub(crate) finalization_ms: f64,
    pub(crate) clock_ms: f64,
    pub(crate) processor_ms: Option<f64>,
    pub(crate) commit: String,
    pub(crate) processor: String,
}

impl Turn {
    /// The time by which variants are compared: the processor's, or where it is not told the clock's.
    pub(crate) fn ms(&self) -> f64 {
        self.processor_ms.unwrap_or(self.clock_ms)
    }

    /// Whether other programs took the processor for more than a tenth of the turn.
    pub(crate) fn is_disturbed(&self) -> bool {
        self.processor_ms
            .is_some_and(|processor| self.clock_ms > 1.1 * processor)
    }

    /// Whether this is a turn of this row.
    pub(crate) fn is_of(&self, row: &Row) -> bool {
        (&self.data, self.size, self.seed, &self.variant)
            == (&row.data, row.size, row.seed, &row.variant)
    }
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

    /// Nanoseconds a point of the median turn; `None` if no time was measured.
    pub(crate) fn ns_per_point(&self) -> Option<f64> {
        self.per_point(Turn::ms)
    }

    /// Nanoseconds a point of initialization, sweeping and finalization (section 3.2) on the clock; medians.
    pub(crate) fn phases(&self) -> Option<[f64; 3]> {
        Some([
            self.per_point(|turn| turn.initialization_ms)?,
            self.per_point(|turn| turn.sweeping_ms)?,
            self.per_point(|turn| turn.finalization_ms)?,
        ])
    }

    fn per_point(&self, ms: fn(&Turn) -> f64) -> Option<f64> {
        let median = median(self.turns.iter().map(ms))?;
        Some(1e6 * median / self.points.max(1) as f64)
    }
}

/// The number in the middle, of an even count the greater one.
pub(crate) fn median(numbers: impl Iterator<Item = f64>) -> Option<f64> {
    let mut sorted: Vec<f64> = numbers.collect();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied()
}

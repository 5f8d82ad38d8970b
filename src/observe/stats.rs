//! Numbers about one run: what there was, what was done, how long it took.

use core::ops::AddAssign;
use core::time::Duration;

use crate::scalar::Stage;

/// The statistics of a run: what it met and did.
///
/// All but the times are the same for every run on the same input with the same settings. Times are zero without a
/// clock (no feature `std`, or `wasm32-unknown-unknown`). The feature `serde` writes fields by name, times in seconds.
///
/// ```
/// use sweep_cdt::{Stats, Triangulator, Watch};
///
/// let points = [[0.0, 0.0], [2.0, 0.0], [0.0, 1.0]];
/// let mut stats = Stats::default();
/// Triangulator::new().run(&points, &[], Watch::new().stats(&mut stats))?;
/// assert_eq!((stats.triangles, stats.hull), (1, 3));
/// assert_eq!(stats.counters.survived.sum(), 1);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Stats {
    /// Input points.
    pub points: usize,
    /// Input points equal to one of a lower index.
    pub duplicates: usize,
    /// Input edges.
    pub edges: usize,
    /// Triangles of the result.
    pub triangles: usize,
    /// Vertices on the border of the hull.
    pub hull: usize,
    /// Time of the initialization (section 3.3; table 2).
    #[cfg_attr(feature = "serde", serde(with = "seconds"))]
    pub initialization: Duration,
    /// Time of the sweeping (section 3.4; table 2).
    #[cfg_attr(feature = "serde", serde(with = "seconds"))]
    pub sweeping: Duration,
    /// Time of the finalization (section 3.5; table 2).
    #[cfg_attr(feature = "serde", serde(with = "seconds"))]
    pub finalization: Duration,
    /// Whether divide and conquer made the result. After an abandoned sweep times and counters hold the work of both.
    pub is_divided: bool,
    /// The most bytes that the largest arrays held at one time, beyond the input.
    pub memory: usize,
    /// The work done.
    pub counters: Counters,
}

#[cfg(feature = "serde")]
mod seconds {
    use core::time::Duration;

    use serde::de::{Deserialize, Deserializer, Error};
    use serde::ser::Serializer;

    pub(super) fn serialize<S: Serializer>(
        time: &Duration,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.serialize_f64(time.as_secs_f64())
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Duration, D::Error> {
        let seconds = f64::deserialize(deserializer)?;
        Duration::try_from_secs_f64(seconds).map_err(D::Error::custom)
    }
}

/// Writes a struct of counts and their sum with the counts of another part of the run. A `max` keeps the greater count.
macro_rules! counts {
    ($(#[$about:meta])* pub struct $name:ident {
        $($(#[$doc:meta])* $field:ident: $type:ty $(= $max:ident)?,)+
    }) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[non_exhaustive]
        pub struct $name {
            $($(#[$doc])* pub $field: $type,)+
        }

        impl AddAssign for $name {
            fn add_assign(&mut self, other: $name) {
                $(counts!(@add self.$field, other.$field $(, $max)?);)+
            }
        }
    };
    (@add $sum:expr, $other:expr) => { $sum += $other };
    (@add $sum:expr, $other:expr, max) => { $sum = $sum.max($other) };
}

counts! {
    /// How often the sweep did each kind of work.
    pub struct Counters {
        /// Orientation tests decided by the floating-point filter.
        orient2d_filtered: u64,
        /// Orientation tests decided in machine integers.
        orient2d_integers: u64,
        /// Orientation tests decided by adaptive expansions.
        orient2d_expansions: u64,
        /// Orientation tests decided in big integers.
        orient2d_big: u64,
        /// Orientation tests decided in the scalar's own arithmetic.
        orient2d_own: u64,
        /// In-circle tests decided by the floating-point filter.
        in_circle_filtered: u64,
        /// In-circle tests decided in machine integers.
        in_circle_integers: u64,
        /// In-circle tests decided by adaptive expansions.
        in_circle_expansions: u64,
        /// In-circle tests decided in big integers.
        in_circle_big: u64,
        /// In-circle tests decided in the scalar's own arithmetic.
        in_circle_own: u64,
        /// Tests with an artificial vertex, decided by rule.
        symbolic: u64,
        /// In-circle tests that found four points on one circle.
        cocircular: u64,
        /// Sides that the legalization tested, constrained ones included.
        legalization_tests: u64,
        /// Sides swapped by the legalization.
        flips: u64,
        /// The most tests from one triangle made to the next: the greatest depth of a legalization.
        most_tests: u64 = max,
        /// The most flips from one triangle made to the next.
        most_flips: u64 = max,
        /// Steps along the front after the search structure's answer (3.4.1). Without a front, steps of the walk from
        /// triangle to triangle or along the beach line.
        front_steps: u64,
        /// Point events (3.4.1): vertices that joined the front after the first one.
        point_events: u64,
        /// The sum of the front's lengths at all point events, in vertices, without the new one.
        front_lengths: u64,
        /// The most vertices on the front.
        longest_front: u64 = max,
        /// Point events of the left case (figure 8).
        left_cases: u64,
        /// Edges (or pieces) that were there already (section 3.4.2).
        edges_present: u64,
        /// Edges (or pieces) inserted by removing triangles.
        edges_inserted: u64,
        /// Triangles removed because an edge pierced them.
        pierced: u64,
        /// Triangles made, artificial ones included.
        made: ByCause,
        /// Triangles made that are in the result: neither flipped nor removed since.
        survived: ByCause,
    }
}

counts! {
    /// Triangles by what made them.
    pub struct ByCause {
        /// The first triangle, which is artificial (figure 6).
        first: u64,
        /// On the segment under the new vertex (figure 7). For other algorithms: all that their points make.
        middle: u64,
        /// The second triangle of the left case (figure 8).
        left: u64,
        /// In narrow corners of the front: the pi/2 heuristic (figure 9).
        narrow_corners: u64,
        /// Below the front: the basin heuristic (figure 10).
        basins: u64,
        /// In pockets of the front under an edge (figures 13 and 14).
        pockets: u64,
        /// In pseudo-polygons beside an edge (figure 12).
        pseudo_polygons: u64,
        /// By the finalization, up to the upper hull (figure 15).
        hull: u64,
        /// By divide and conquer.
        divide_and_conquer: u64,
        /// Made by flips; each replaces two triangles by two (figure 3).
        flips: u64,
    }
}

impl ByCause {
    /// All triangles that no flip made.
    fn steps(&self) -> u64 {
        self.first
            + self.middle
            + self.left
            + self.narrow_corners
            + self.basins
            + self.pockets
            + self.pseudo_polygons
            + self.hull
            + self.divide_and_conquer
    }

    /// All triangles.
    #[must_use]
    pub fn sum(&self) -> u64 {
        self.steps() + self.flips
    }
}

impl Counters {
    /// Orientation tests that the filter left open.
    #[must_use]
    pub fn orient2d_exact(&self) -> u64 {
        self.orient2d_integers + self.orient2d_expansions + self.orient2d_big + self.orient2d_own
    }

    /// In-circle tests that the filter left open.
    #[must_use]
    pub fn in_circle_exact(&self) -> u64 {
        self.in_circle_integers
            + self.in_circle_expansions
            + self.in_circle_big
            + self.in_circle_own
    }

    /// Tests that follow a triangle made, on average.
    #[must_use]
    pub fn mean_tests(&self) -> f64 {
        mean(self.legalization_tests, self.made.steps())
    }

    /// Flips that follow a triangle made, on average.
    #[must_use]
    pub fn mean_flips(&self) -> f64 {
        mean(self.flips, self.made.steps())
    }

    /// Vertices on the front at a point event, on average.
    #[must_use]
    pub fn mean_front(&self) -> f64 {
        mean(self.front_lengths, self.point_events)
    }

    pub(crate) fn count_orient2d(&mut self, stage: Stage) {
        *match stage {
            Stage::Integers => &mut self.orient2d_integers,
            Stage::Expansions => &mut self.orient2d_expansions,
            Stage::BigIntegers => &mut self.orient2d_big,
            Stage::Own => &mut self.orient2d_own,
        } += 1;
    }

    pub(crate) fn count_in_circle(&mut self, stage: Stage) {
        *match stage {
            Stage::Integers => &mut self.in_circle_integers,
            Stage::Expansions => &mut self.in_circle_expansions,
            Stage::BigIntegers => &mut self.in_circle_big,
            Stage::Own => &mut self.in_circle_own,
        } += 1;
    }
}

/// A mean; 0 of nothing.
fn mean(sum: u64, count: u64) -> f64 {
    sum as f64 / count.max(1) as f64
}

//! Numbers about one run: what there was, what was done, how long it took.

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

/// How often the sweep did each kind of work.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Counters {
    /// Orientation tests decided by the floating-point filter.
    pub orient2d_filtered: u64,
    /// Orientation tests decided in machine integers.
    pub orient2d_integers: u64,
    /// Orientation tests decided by adaptive expansions.
    pub orient2d_expansions: u64,
    /// Orientation tests decided in big integers.
    pub orient2d_big: u64,
    /// Orientation tests decided in the scalar's own arithmetic.
    pub orient2d_own: u64,
    /// In-circle tests decided by the floating-point filter.
    pub in_circle_filtered: u64,
    /// In-circle tests decided in machine integers.
    pub in_circle_integers: u64,
    /// In-circle tests decided by adaptive expansions.
    pub in_circle_expansions: u64,
    /// In-circle tests decided in big integers.
    pub in_circle_big: u64,
    /// In-circle tests decided in the scalar's own arithmetic.
    pub in_circle_own: u64,
    /// Tests with an artificial vertex, decided by rule.
    pub symbolic: u64,
    /// In-circle tests that found four points on one circle.
    pub cocircular: u64,
    /// Sides that the legalization tested, constrained ones included.
    pub legalization_tests: u64,
    /// Sides swapped by the legalization.
    pub flips: u64,
    /// The most tests from one triangle made to the next: the greatest depth of a legalization.
    pub most_tests: u64,
    /// The most flips from one triangle made to the next.
    pub most_flips: u64,
    /// Steps along the front after the search structure's answer (3.4.1). Without a front, steps of the walk from
    /// triangle to triangle or along the beach line.
    pub front_steps: u64,
    /// Point events (3.4.1): vertices that joined the front after the first one.
    pub point_events: u64,
    /// The sum of the front's lengths at all point events, in vertices, without the new one.
    pub front_lengths: u64,
    /// The most vertices on the front.
    pub longest_front: u64,
    /// Point events of the left case (figure 8).
    pub left_cases: u64,
    /// Edges (or pieces) that were there already (section 3.4.2).
    pub edges_present: u64,
    /// Edges (or pieces) inserted by removing triangles.
    pub edges_inserted: u64,
    /// Triangles removed because an edge pierced them.
    pub pierced: u64,
    /// Triangles made, artificial ones included.
    pub made: ByCause,
    /// Triangles made that are in the result: neither flipped nor removed since.
    pub survived: ByCause,
}

/// Triangles by what made them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct ByCause {
    /// The first triangle, which is artificial (figure 6).
    pub first: u64,
    /// On the segment under the new vertex (figure 7). For other algorithms: all that their points make.
    pub middle: u64,
    /// The second triangle of the left case (figure 8).
    pub left: u64,
    /// In narrow corners of the front: the pi/2 heuristic (figure 9).
    pub narrow_corners: u64,
    /// Below the front: the basin heuristic (figure 10).
    pub basins: u64,
    /// In pockets of the front under an edge (figures 13 and 14).
    pub pockets: u64,
    /// In pseudo-polygons beside an edge (figure 12).
    pub pseudo_polygons: u64,
    /// By the finalization, up to the upper hull (figure 15).
    pub hull: u64,
    /// By divide and conquer.
    pub divide_and_conquer: u64,
    /// Made by flips; each replaces two triangles by two (figure 3).
    pub flips: u64,
}

impl ByCause {
    /// All triangles but those that flips made.
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

    #[cfg(feature = "parallel")]
    fn all(&mut self) -> [&mut u64; 10] {
        [
            &mut self.first,
            &mut self.middle,
            &mut self.left,
            &mut self.narrow_corners,
            &mut self.basins,
            &mut self.pockets,
            &mut self.pseudo_polygons,
            &mut self.hull,
            &mut self.divide_and_conquer,
            &mut self.flips,
        ]
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

    /// Adds the counters of another part of the run.
    #[cfg(feature = "parallel")]
    pub(crate) fn add(&mut self, other: &mut Counters) {
        for (sum, other) in self.sums().zip(other.sums()) {
            *sum += *other;
        }
        self.most_tests = self.most_tests.max(other.most_tests);
        self.most_flips = self.most_flips.max(other.most_flips);
        self.longest_front = self.longest_front.max(other.longest_front);
    }

    /// All counters but those of the most of something.
    #[cfg(feature = "parallel")]
    fn sums(&mut self) -> impl Iterator<Item = &mut u64> {
        [
            &mut self.orient2d_filtered,
            &mut self.orient2d_integers,
            &mut self.orient2d_expansions,
            &mut self.orient2d_big,
            &mut self.orient2d_own,
            &mut self.in_circle_filtered,
            &mut self.in_circle_integers,
            &mut self.in_circle_expansions,
            &mut self.in_circle_big,
            &mut self.in_circle_own,
            &mut self.symbolic,
            &mut self.cocircular,
            &mut self.legalization_tests,
            &mut self.flips,
            &mut self.front_steps,
            &mut self.point_events,
            &mut self.front_lengths,
            &mut self.left_cases,
            &mut self.edges_present,
            &mut self.edges_inserted,
            &mut self.pierced,
        ]
        .into_iter()
        .chain(self.made.all())
        .chain(self.survived.all())
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

#[cfg(test)]
#[cfg(feature = "parallel")]
mod tests {
    use alloc::format;
    use alloc::vec::Vec;

    use super::Counters;

    /// The counters of two bands are added up, all but the most of something.
    #[test]
    fn all_counters_are_added_up() {
        let mut band = Counters {
            most_tests: 7,
            most_flips: 7,
            longest_front: 7,
            ..Counters::default()
        };
        band.sums().for_each(|counter| *counter = 1);
        let mut both = band;
        both.add(&mut band);
        let text = format!("{both:?}");
        let words = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        let numbers: Vec<u64> = words.filter_map(|word| word.parse().ok()).collect();
        let of = |number| numbers.iter().filter(|&&other| other == number).count();
        assert_eq!((of(7), of(2)), (3, numbers.len() - 3), "{text}");
    }
}

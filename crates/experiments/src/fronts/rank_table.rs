//! A table over ranks of x ([`super::interval_table`]): the intervals hold equally many of the vertices, wherever
//! they crowd.
//!
//! Why it is right: ranks are in the order of x ([`super::parts`]).
//!
//! Cost: O(1) expected for a search where the front is spread over the vertices as they are from left to
//! right. At worst a search looks through O(sqrt(n)) intervals, and the sweep walks over O(n) nodes: those of intervals
//! whose last node has left. An update costs O(1). The ranks cost a sort once.

use sweep_cdt::front::{FrontInput, FrontNode, Work};

use super::interval_table::{IntervalTable, Intervals};
use super::parts::XRanks;

/// A table with 2 sqrt(n) intervals of equally many x: O(1) expected.
pub type RankTable = IntervalTable<ByRank>;

/// The intervals of equally many ranks.
#[derive(Clone, Debug, Default)]
pub struct ByRank(XRanks);

impl Intervals for ByRank {
    fn begin(&mut self, input: FrontInput<'_>, work: &mut Work) -> usize {
        self.0 = XRanks::new(input, work);
        2 * input.len().isqrt() + 1
    }

    fn of(&self, x: f64, count: usize, work: &mut Work) -> usize {
        let rank = self.0.last_up_to(x, work);
        // Without points there are no ranks, and one interval.
        rank.unwrap_or(0) * count / self.0.len().max(1)
    }

    fn joined(&mut self, node: FrontNode) {
        self.0.join(node);
    }
}

//! A table of a fixed number of equal intervals of x ([`super::interval_table`]), however many points there are.
//!
//! Of programs for this sweep or a sweep like it, two have such a table. The cdt crate 0.1.0 (Formlabs, `hull.rs`) has 1024
//! buckets of pseudo-angle over a linked list. The Java version of Poly2Tri (T. Åhlén, `AdvancingFrontIndex`) has an
//! index begun and not finished: a binary tree over the range of x that is at most five deep, which
//! makes 32 intervals. In use is its walk from the last node, [`Linear`](sweep_cdt::front::Linear) here; no hash of
//! its author was found.
//!
//! Differs from theirs: an entry is the node that joined last, and an empty interval takes from either side.
//!
//! Why it is right: the number of the interval ascends with x.
//!
//! Cost: a search looks at an entry, at all at worst, and computes its interval; an update O(1). The sweep walks
//! over the nodes in an interval: O(n), even where x spreads evenly, as their number grows and that of the
//! intervals does not.

use sweep_cdt::front::{FrontInput, Work};

use super::interval_table::{IntervalTable, Intervals};
use super::parts::EqualIntervals;

/// A table of `N` equal intervals: O(1) while the front is short.
pub type FixedTable<const N: usize> = IntervalTable<Fixed<N>>;

/// `N` equal intervals of x.
#[derive(Clone, Debug, Default)]
pub struct Fixed<const N: usize>(EqualIntervals);

impl<const N: usize> Intervals for Fixed<N> {
    fn begin(&mut self, input: FrontInput<'_>, _: &mut Work) -> usize {
        self.0 = EqualIntervals::new(input, N);
        N
    }

    fn of(&self, x: f64, _: usize, _: &mut Work) -> usize {
        self.0.number(x)
    }
}

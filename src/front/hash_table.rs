//! The paper's structure (section 3.4.1, after Žalik 2005): a hash table over intervals of x.
//!
//! Every interval remembers the node that was inserted in it last. A search looks into the interval of x.
//! If that is empty or its node has left the front, the search looks into the intervals on either side. The
//! node found is usually near: most nodes leave the front when one beside them joins it.
//!
//! Cost: O(1) expected for a search. There are 2 sqrt(n) intervals, about as many as the front has vertices
//! where the points are spread evenly. A dense cluster in a wide domain would crowd a few of many equal
//! intervals. A sample of the points shows this beforehand; then the intervals end at quantiles of the
//! sample, and finding one takes O(log n).
//!
//! Differs from the paper: the table is not updated when a node leaves the front; the search notices it.
//! Intervals may be quantiles.

use super::list::{Front, FrontNode};
use super::search::{Domain, FrontSearch};
use crate::bucket::bucket;

/// Intervals of x that remember their last insertion: O(1) expected. The default.
#[derive(Clone, Debug, Default)]
pub struct HashTable {
    intervals: Intervals,
    table: Vec<Option<FrontNode>>,
    last: Option<FrontNode>,
}

#[derive(Clone, Debug)]
enum Intervals {
    /// `x` lies in interval number `(x - low) * factor`.
    Equal { low: f64, factor: f64 },
    /// They end at these x, ascending; the last one has no end.
    Quantiles(Vec<f64>),
}

impl Default for Intervals {
    fn default() -> Self {
        Intervals::Quantiles(Vec::new())
    }
}

/// How many intervals are searched on either side before the last node inserted is taken.
const REACH: usize = 16;
/// How many points a sample has at most, and how many cells judge it.
const SAMPLE: usize = 4096;
const CELLS: usize = 64;

impl FrontSearch for HashTable {
    fn begin(&mut self, domain: Domain<'_>) {
        let n = domain.len();
        let size = 2 * n.isqrt() + 1;
        let (low, high) = (0..n).map(|v| domain.x(v)).fold(
            (f64::INFINITY, f64::NEG_INFINITY),
            |(low, high): (f64, f64), x| (low.min(x), high.max(x)),
        );
        let mut sample: Vec<f64> = (0..n)
            .step_by(n.div_ceil(SAMPLE).max(1))
            .map(|v| domain.x(v))
            .collect();
        sample.sort_unstable_by(f64::total_cmp);
        self.intervals = if is_skewed(&sample, low, high) {
            let ends = (1..size).map(|i| sample[i * sample.len() / size]);
            Intervals::Quantiles(ends.collect())
        } else {
            let factor = size as f64 / (high - low);
            Intervals::Equal {
                low,
                factor: if factor.is_finite() { factor } else { 0.0 },
            }
        };
        self.table.clear();
        self.table.resize(size, None);
        self.last = None;
    }

    #[inline]
    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        let live = |entry: &Option<FrontNode>| entry.filter(|&node| front.contains(node));
        let at = self.interval(x);
        if let Some(node) = live(&self.table[at]) {
            return node;
        }
        let around = (1..=REACH).flat_map(|i| [at.checked_sub(i), Some(at + i)]);
        around
            .filter_map(|i| self.table.get(i?).and_then(live))
            .next()
            .or_else(|| live(&self.last))
            .unwrap_or(front.left_end())
    }

    #[inline]
    fn inserted(&mut self, node: FrontNode, x: f64) {
        let at = self.interval(x);
        self.table[at] = Some(node);
        self.last = Some(node);
    }
}

impl HashTable {
    #[inline]
    fn interval(&self, x: f64) -> usize {
        match &self.intervals {
            Intervals::Equal { low, factor } => bucket((x - low) * factor, self.table.len()),
            Intervals::Quantiles(ends) => ends.partition_point(|&end| end <= x),
        }
    }
}

/// Whether equal intervals would be crowded. The sample is put into [`CELLS`] equal cells; it is skewed if
/// an average point shares its cell with four times as many points as if all cells held equally many.
fn is_skewed(sample: &[f64], low: f64, high: f64) -> bool {
    let mut cells = [0_usize; CELLS];
    let factor = CELLS as f64 / (high - low);
    for &x in sample {
        cells[bucket((x - low) * factor, CELLS)] += 1;
    }
    let pairs: usize = cells.iter().map(|count| count * count).sum();
    pairs * CELLS > 4 * sample.len() * sample.len().max(CELLS)
}

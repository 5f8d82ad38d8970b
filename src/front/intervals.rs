//! The intervals of x of the [hash table](super::hash_table), chosen by a sample of the points.
//!
//! They have equal widths where the sample spreads evenly over them; then finding one takes a few
//! instructions. Otherwise they end at quantiles of the sample, so that each holds as many points as the
//! others, and finding one takes O(log n). The equal ones span all but the outermost of the sample: points
//! far away, or at infinity, fall in the first or last one and make none of the others wider. Where neither
//! helps, the table asks for places, and each of them is an interval.

use super::places::Places;
use crate::bucket::bucket;

#[derive(Clone, Debug)]
pub(super) enum Intervals {
    /// `x` lies in interval number `(x - low) * factor`.
    Equal { low: f64, factor: f64 },
    /// They end at these x, ascending; the last one has no end.
    Quantiles(Vec<f64>),
    /// `x` is a place, with an interval of its own; the set of those that have had a node.
    Places(Places),
}

impl Default for Intervals {
    fn default() -> Self {
        Intervals::Quantiles(Vec::new())
    }
}

/// One of this many points of the sample may be far away at either end.
const OUTERMOST: usize = 64;

impl Intervals {
    /// So many intervals for points of which this is a sample: x ascending, none of them twice.
    pub(super) fn new(sample: &[f64], count: usize) -> Intervals {
        let equal = Intervals::equal(sample, count);
        if equal.are_crowded(sample, count) {
            let ends = (1..count).filter_map(|i| sample.get(i * sample.len() / count));
            Intervals::Quantiles(ends.copied().collect())
        } else {
            equal
        }
    }

    /// Equal ones over the range of the sample, as its inner part would have it.
    fn equal(sample: &[f64], count: usize) -> Intervals {
        let [Some(&low), Some(&high)] = [sample.first(), sample.last()] else {
            return Intervals::Equal {
                low: 0.0,
                factor: 0.0,
            };
        };
        let outer = sample.len() / OUTERMOST;
        let [first, last] = [sample[outer], sample[sample.len() - 1 - outer]];
        // What an even spread has outside.
        let margin = (last - first) / (OUTERMOST - 2) as f64;
        let (low, high) = (low.max(first - margin), high.min(last + margin));
        let factor = count as f64 / (high - low);
        Intervals::Equal {
            low,
            factor: if factor.is_finite() { factor } else { 0.0 },
        }
    }

    /// Whether a point shares its interval with four times as many of the sample as if all held equally
    /// many.
    fn are_crowded(&self, sample: &[f64], count: usize) -> bool {
        let runs = sample.chunk_by(|&a, &b| self.number(a, count) == self.number(b, count));
        let pairs: usize = runs.map(|run| run.len() * (run.len() - 1)).sum();
        pairs * count > 4 * sample.len() * sample.len()
    }

    /// The number of the interval of `x` among `count`.
    #[inline(always)]
    pub(super) fn number(&self, x: f64, count: usize) -> usize {
        match self {
            Intervals::Equal { low, factor } => bucket((x - low) * factor, count),
            Intervals::Quantiles(ends) => ends.partition_point(|&end| end <= x),
            Intervals::Places(_) => bucket(x, count),
        }
    }
}

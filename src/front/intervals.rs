//! The intervals of x of the [hash table](super::hash_table), chosen by a sample of the points.
//!
//! If the sample spreads evenly, the intervals have equal widths, and finding one takes a few instructions. They span
//! all but the outermost of the sample: points far away, or at infinity, fall in the first or last interval and widen
//! no other. Otherwise the intervals end at quantiles of the sample, so that each holds as many points, and finding one
//! takes O(log n).
//!
//! The sample may spread evenly as a whole where the front does not: clusters side by side and one above the other
//! crowd it here at one height and there at another. So the sample is also cut into slabs, and the equal intervals
//! become narrower by the crowding within slabs. More intervals than that would
//! be empty, or hold a node that has left the front.

use super::work::Tally;
use crate::bucket::bucket;
use crate::tuning::{CROWDED, FEWEST_SLABS, FINEST, Tuning};
use alloc::vec::Vec;

#[derive(Clone, Debug)]
pub(super) enum Intervals {
    /// `x` lies in interval number `(x - low) * factor`.
    Equal { low: f64, factor: f64 },
    /// The intervals end at these x, ascending; the last one has no end.
    Quantiles(Vec<f64>),
}

impl Default for Intervals {
    fn default() -> Self {
        Intervals::Quantiles(Vec::new())
    }
}

impl Intervals {
    /// About `count` intervals, and how many they are. `ranks` are a sample of the points; `x` is the x of a rank.
    pub(super) fn new(
        mut ranks: Vec<usize>,
        x: impl Fn(usize) -> f64,
        count: usize,
        tuning: &Tuning,
    ) -> (Intervals, usize) {
        // Of equal x only one is on the front.
        let sorted = |ranks: &[usize]| {
            let mut sample: Vec<f64> = ranks.iter().map(|&v| x(v)).collect();
            sample.sort_unstable_by(f64::total_cmp);
            sample.dedup();
            sample
        };
        let sample = sorted(&ranks);
        let equal = Intervals::equal(&sample, count, tuning);
        if equal.crowding(&[&sample[..]], count) >= CROWDED {
            let ends = (1..count).filter_map(|i| sample.get(i * sample.len() / count));
            return (Intervals::Quantiles(ends.copied().collect()), count);
        }
        if sample.len() < FEWEST_SLABS * tuning.slab {
            return (equal, count);
        }
        ranks.sort_unstable();
        let slabs: Vec<Vec<f64>> = ranks.chunks(tuning.slab).map(sorted).collect();
        let finer = equal.crowding(&slabs, count).clamp(1, FINEST);
        let count = finer * count;
        (Intervals::equal(&sample, count, tuning), count)
    }

    /// Equal intervals over the range of the sample, or less if its inner part suggests so.
    fn equal(sample: &[f64], count: usize, tuning: &Tuning) -> Intervals {
        let [Some(&low), Some(&high)] = [sample.first(), sample.last()] else {
            return Intervals::Equal {
                low: 0.0,
                factor: 0.0,
            };
        };
        let outer = sample.len() / tuning.outermost;
        let [first, last] = [sample[outer], sample[sample.len() - 1 - outer]];
        // The width of what an even spread has outside the inner part, on either side.
        let margin = (last - first) / (tuning.outermost - 2) as f64;
        let (low, high) = (low.max(first - margin), high.min(last + margin));
        let factor = count as f64 / (high - low);
        Intervals::Equal {
            low,
            factor: if factor.is_finite() { factor } else { 0.0 },
        }
    }

    /// Cuts each equal interval into `times` ones. Returns false for others, which stay.
    pub(super) fn divide(&mut self, times: usize) -> bool {
        let Intervals::Equal { factor, .. } = self else {
            return false;
        };
        *factor *= times as f64;
        true
    }

    /// Crowding: the mean number of points that share a point's interval, as a multiple of the uniform case. Averaged
    /// over all samples; each is sorted without duplicates.
    fn crowding(&self, samples: &[impl AsRef<[f64]>], count: usize) -> usize {
        let number = |x| self.number(x, count, &mut Tally::<false>::default());
        let pairs = |sample: &[f64]| -> usize {
            let runs = sample.chunk_by(|&a, &b| number(a) == number(b));
            runs.map(|run| run.len() * (run.len() - 1)).sum()
        };
        let samples = samples.iter().map(AsRef::as_ref);
        let (pairs, all) = samples.fold((0, 0), |(sum, all), sample| {
            (sum + pairs(sample), all + sample.len() * sample.len())
        });
        pairs * count / all.max(1)
    }

    /// The number of the interval of `x` among `count`; tallies the comparisons.
    #[inline(always)]
    pub(super) fn number<const COUNTS: bool>(
        &self,
        x: f64,
        count: usize,
        tally: &mut Tally<COUNTS>,
    ) -> usize {
        match self {
            Intervals::Equal { low, factor } => bucket((x - low) * factor, count),
            Intervals::Quantiles(ends) => ends.partition_point(|&end| {
                tally.count(|work| work.comparisons += 1);
                end <= x
            }),
        }
    }

    pub(super) fn bytes(&self) -> usize {
        match self {
            Intervals::Equal { .. } => 0,
            Intervals::Quantiles(ends) => size_of_val(&ends[..]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Intervals, Tally, Tuning};
    use crate::bucket::sampled;

    /// Twenty clusters side by side, one above the other, crowd each slab, though all together spread evenly.
    #[test]
    fn clusters_have_more_intervals() {
        let count = |x: fn(usize) -> f64| {
            let sample = sampled(40_000, 402).collect();
            Intervals::new(sample, x, 201, &Tuning::REAL).1
        };
        let even = |i: usize| (i as f64 * 0.618_034).fract();
        let clustered = |i: usize| (i / 2000 * 7 % 20) as f64 + (i as f64 * 0.618_034).fract();
        assert_eq!([count(even), count(clustered)], [201, 603]);
    }

    /// Two clusters need quantiles, found by bisection: sixteen ends between seventeen intervals.
    #[test]
    fn comparisons_of_quantiles_are_counted() {
        let x = |i: usize| (i / 128) as f64 + (i % 128) as f64 * 1e-9;
        let (mut intervals, count) = Intervals::new((0..256).collect(), x, 17, &Tuning::REAL);
        let mut tally = Tally::<true>::default();
        assert_eq!(intervals.number(0.0, count, &mut tally), 0);
        assert!((4..=5).contains(&tally.0.comparisons), "{tally:?}");
        assert_eq!((count, intervals.bytes()), (17, 8 * 16));
        assert!(!intervals.divide(4), "they cannot be cut");
    }

    #[test]
    fn the_parts_of_an_interval_are_side_by_side() {
        let x = |i: usize| i as f64;
        let (whole, count) = Intervals::new((0..100).collect(), x, 10, &Tuning::REAL);
        let mut cut = whole.clone();
        assert!(cut.divide(4));
        for i in -5..105 {
            let none = &mut Tally::<false>::default();
            let mut of = |intervals: &Intervals, count| intervals.number(f64::from(i), count, none);
            assert_eq!(of(&cut, 4 * count) / 4, of(&whole, count), "{i}");
        }
    }
}

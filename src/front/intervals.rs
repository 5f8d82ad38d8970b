//! The intervals of x of the [hash table](super::hash_table), chosen by a sample of the points, or by place.
//!
//! They have equal widths where the sample spreads evenly over them; then finding one takes a few
//! instructions. Otherwise they end at quantiles of the sample, so that each holds as many points as the
//! others, and finding one takes O(log n). The equal ones span all but the outermost of the sample: points
//! far away, or at infinity, fall in the first or last one and make none of the others wider. Where neither
//! helps, the table asks for places, and each of them is an interval.
//!
//! The whole sample may spread evenly where the front does not: clusters side by side and one above the other crowd
//! it here at one height and there at another. So the sample is also looked at slab by slab, and the equal intervals
//! are narrower by as much as it is crowded in them. (A million points in clusters: 1.1 steps along the front in
//! place of 4.1.) More of them than that would be empty, or hold a node that has left the front.

use super::work::Tally;
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
/// Quantiles are taken where a point shares its interval with so many times as many as if all held equally many.
const CROWDED: usize = 4;
/// A smaller sample is not divided into slabs.
const FEW: usize = 4 * SLAB;
/// So many points of the sample, one above the other, are a slab.
const SLAB: usize = 64;
/// How many times as many equal intervals there are at most.
const FINEST: usize = 8;

impl Intervals {
    /// About so many intervals, and how many they are, for points of which these ranks are a sample; `x` is that of
    /// a rank.
    pub(super) fn new(
        mut ranks: Vec<usize>,
        x: impl Fn(usize) -> f64,
        count: usize,
    ) -> (Intervals, usize) {
        // Only one of equal x is on the front.
        let sorted = |ranks: &[usize]| {
            let mut sample: Vec<f64> = ranks.iter().map(|&v| x(v)).collect();
            sample.sort_unstable_by(f64::total_cmp);
            sample.dedup();
            sample
        };
        let sample = sorted(&ranks);
        let equal = Intervals::equal(&sample, count);
        if equal.crowding(&[&sample[..]], count) >= CROWDED {
            let ends = (1..count).filter_map(|i| sample.get(i * sample.len() / count));
            return (Intervals::Quantiles(ends.copied().collect()), count);
        }
        if sample.len() < FEW {
            return (equal, count);
        }
        ranks.sort_unstable();
        let slabs: Vec<Vec<f64>> = ranks.chunks(SLAB).map(sorted).collect();
        let finer = equal.crowding(&slabs, count).clamp(1, FINEST);
        (Intervals::equal(&sample, finer * count), finer * count)
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

    /// With how many times as many points a point shares its interval as if all held equally many, each of these
    /// samples for itself; x ascending, none of them twice.
    fn crowding(&self, samples: &[impl AsRef<[f64]>], count: usize) -> usize {
        let number = |x| self.number(x, count, &mut ());
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

    /// The number of the interval of `x` among `count`; counts the comparisons.
    #[inline(always)]
    pub(super) fn number(&self, x: f64, count: usize, tally: &mut impl Tally) -> usize {
        match self {
            Intervals::Equal { low, factor } => bucket((x - low) * factor, count),
            Intervals::Quantiles(ends) => ends.partition_point(|&end| {
                tally.count(|work| work.comparisons += 1);
                end <= x
            }),
            Intervals::Places(_) => bucket(x, count),
        }
    }

    /// Bytes held.
    pub(super) fn bytes(&self) -> usize {
        match self {
            Intervals::Equal { .. } => 0,
            Intervals::Quantiles(ends) => size_of_val(&ends[..]),
            Intervals::Places(places) => places
                .levels
                .iter()
                .map(|words| size_of_val(&words[..]))
                .sum(),
        }
    }
}

/// A set of places: whole numbers below n, which number all vertices from left to right.
///
/// It is a tree of bits: a word has a bit for each of 64 places, and each word of the next level a bit for
/// each of 64 words that are not zero. The last member up to a place is the highest bit of a word on the
/// way up from there, and then the highest bits on the way down.
///
/// Cost: O(log n) at worst for each operation, four levels for 16 million places; n bits and some. The words
/// looked at are counted.
#[derive(Clone, Debug)]
pub(super) struct Places {
    /// From the bits of the places up to a single word.
    levels: Vec<Vec<u64>>,
}

impl Places {
    /// None of `count` places.
    pub(super) fn new(count: usize) -> Places {
        let mut levels = Vec::new();
        let mut words = count;
        while words > 1 || levels.is_empty() {
            words = words.div_ceil(64);
            levels.push(vec![0; words]);
        }
        Places { levels }
    }

    pub(super) fn insert(&mut self, place: usize, tally: &mut impl Tally) {
        let mut at = place;
        for words in &mut self.levels {
            tally.count(|work| work.visited += 1);
            words[at / 64] |= 1 << (at % 64);
            at /= 64;
        }
    }

    pub(super) fn remove(&mut self, place: usize, tally: &mut impl Tally) {
        let mut at = place;
        for words in &mut self.levels {
            tally.count(|work| work.visited += 1);
            words[at / 64] &= !(1 << (at % 64));
            if words[at / 64] != 0 {
                break;
            }
            at /= 64;
        }
    }

    /// The last one that is not after this place.
    pub(super) fn last_up_to(&self, place: usize, tally: &mut impl Tally) -> Option<usize> {
        let mut at = place;
        // The bits of the word that count: up to the place, on higher levels those before it.
        let mut mask = u64::MAX >> (63 - at % 64);
        for (level, words) in self.levels.iter().enumerate() {
            tally.count(|work| work.visited += 1);
            let word = words[at / 64] & mask;
            if word != 0 {
                let found = at / 64 * 64 + highest(word);
                tally.count(|work| work.visited += level as u64);
                let below = self.levels[..level].iter().rev();
                return Some(below.fold(found, |at, words| at * 64 + highest(words[at])));
            }
            at /= 64;
            mask = (1 << (at % 64)) - 1;
        }
        None
    }
}

/// The number of the highest bit of a word that is not zero.
fn highest(word: u64) -> usize {
    word.ilog2() as usize
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::Places;

    /// Insertions, removals and searches in a scattered order, against a sorted set.
    #[test]
    fn the_last_one_up_to_each_place() {
        for count in [1, 2, 63, 64, 65, 130, 4096, 4097, 5000] {
            let (mut places, mut expected) = (Places::new(count), BTreeSet::new());
            for i in 0..4000 {
                let place = i * 7919 % count;
                if i % 3 == 0 {
                    expected.insert(place);
                    places.insert(place, &mut ());
                } else if expected.remove(&(place / 2)) {
                    places.remove(place / 2, &mut ());
                }
                let asked = i * 104_729 % count;
                let last = expected.range(..=asked).next_back().copied();
                assert_eq!(
                    places.last_up_to(asked, &mut ()),
                    last,
                    "{asked} of {count}"
                );
            }
        }
    }
}

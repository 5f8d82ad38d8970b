//! A set of x-ranks: whole numbers below n, which number all vertices from left to right. It is a tree of bits: a word
//! has a bit for each of 64 x-ranks, and each word of the next level a bit for each of 64 words that are not zero. The
//! last member up to an x-rank is the highest bit of a word on the way up, and then the highest bits on the way down.
//! Cost: O(log n) at worst for each operation, four levels for 16 million x-ranks; n bits and some.

use super::work::Tally;
use alloc::vec;
use alloc::vec::Vec;

#[derive(Clone, Debug)]
pub(super) struct XRankSet {
    /// The bits of the x-ranks, then levels above up to a single word.
    levels: Vec<Vec<u64>>,
}

impl XRankSet {
    /// The empty set of x-ranks below `count`.
    pub(super) fn new(count: usize) -> XRankSet {
        let mut levels = Vec::new();
        let mut words = count;
        while words > 1 || levels.is_empty() {
            words = words.div_ceil(64);
            levels.push(vec![0; words]);
        }
        XRankSet { levels }
    }

    pub(super) fn bytes(&self) -> usize {
        self.levels
            .iter()
            .map(|words| size_of_val(&words[..]))
            .sum()
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

    /// The last member that is not after `place`.
    pub(super) fn last_up_to(&self, place: usize, tally: &mut impl Tally) -> Option<usize> {
        let mut at = place;
        // The bits of the word that count: up to the x-rank, on higher levels those before it.
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

fn highest(word: u64) -> usize {
    word.ilog2() as usize
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::XRankSet;

    #[test]
    fn the_last_one_up_to_each_place() {
        for count in [1, 2, 63, 64, 65, 130, 4096, 4097, 5000] {
            let (mut places, mut expected) = (XRankSet::new(count), BTreeSet::new());
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

//! A bit for each x that can occur, set while a node with that x is on the front ([`super::number_set`]).
//!
//! The set is a tree of words of 64 bits: a bit of a word on a higher level says whether one of 64 words below it
//! is not zero. So a search reads one word a level on the way up, and one a level on the way down.
//!
//! Why it is right: the words before a word with a bit hold lesser numbers only.
//!
//! Cost: a search and an update read O(log n) words with 64 ways a level, four levels for 16 million numbers,
//! whatever the front is like; n bits and some. The sweep takes no step.

use sweep_cdt::front::Work;

use super::number_set::{NumberSet, Numbers};

/// The ranks of x on the front as bits, searched by words: O(log n) with base 64.
pub type BitSet = NumberSet<Words>;

/// A set of whole numbers as bits.
#[derive(Clone, Debug, Default)]
pub struct Words {
    /// From the bits of the numbers up to a single word.
    levels: Vec<Vec<u64>>,
    /// Words read or changed.
    visited: u64,
}

impl Numbers for Words {
    fn new(count: usize) -> Words {
        let mut levels = Vec::new();
        let mut words = count.max(1);
        while words > 1 || levels.is_empty() {
            words = words.div_ceil(64);
            levels.push(vec![0; words]);
        }
        Words { levels, visited: 0 }
    }

    fn insert(&mut self, number: usize) {
        let mut at = number;
        for words in &mut self.levels {
            self.visited += 1;
            let word = &mut words[at / 64];
            let had_others = *word != 0;
            *word |= 1 << (at % 64);
            if had_others {
                break;
            }
            at /= 64;
        }
    }

    fn remove(&mut self, number: usize) {
        let mut at = number;
        for words in &mut self.levels {
            self.visited += 1;
            let word = &mut words[at / 64];
            *word &= !(1 << (at % 64));
            if *word != 0 {
                break;
            }
            at /= 64;
        }
    }

    fn last_up_to(&mut self, number: usize) -> Option<usize> {
        let mut at = number;
        // Up to the number itself; on higher levels what is before it.
        let mut mask = u64::MAX >> (63 - at % 64);
        for level in 0..self.levels.len() {
            self.visited += 1;
            let word = self.levels[level][at / 64] & mask;
            if word != 0 {
                let mut found = at / 64 * 64 + highest(word);
                for words in self.levels[..level].iter().rev() {
                    self.visited += 1;
                    found = found * 64 + highest(words[found]);
                }
                return Some(found);
            }
            at /= 64;
            mask = (1 << (at % 64)) - 1;
        }
        None
    }
    fn work(&self) -> Work {
        let words: usize = self.levels.iter().map(Vec::len).sum();
        Work {
            visited: self.visited,
            bytes: 8 * words as u64,
            ..Work::default()
        }
    }
}

/// The number of the highest bit of a word that is not zero.
pub(super) fn highest(word: u64) -> usize {
    word.ilog2() as usize
}

#[cfg(test)]
mod tests {
    use super::super::number_set::compare;
    use super::Words;

    #[test]
    fn the_greatest_member_up_to_a_number_is_found() {
        compare::<Words>();
    }
}

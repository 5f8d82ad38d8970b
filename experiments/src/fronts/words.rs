//! A set of whole numbers below n as bits, with the greatest member up to a number.
//!
//! It is a tree of words of 64 bits: a bit of a word on a higher level says whether one of 64 words below it
//! is not zero. So a search reads one word a level on the way up, and one a level on the way down.
//!
//! Cost: O(log n) with 64 ways a level, four levels for 16 million numbers; n bits and some.

#[derive(Clone, Debug, Default)]
pub(super) struct Words {
    /// From the bits of the numbers up to a single word.
    levels: Vec<Vec<u64>>,
    /// Words read or changed.
    pub(super) visited: u64,
}

impl Words {
    /// No numbers below `count`.
    pub(super) fn new(count: usize) -> Words {
        let mut levels = Vec::new();
        let mut words = count.max(1);
        while words > 1 || levels.is_empty() {
            words = words.div_ceil(64);
            levels.push(vec![0; words]);
        }
        Words { levels, visited: 0 }
    }

    /// How many words there are.
    pub(super) fn len(&self) -> usize {
        self.levels.iter().map(Vec::len).sum()
    }

    pub(super) fn insert(&mut self, number: usize) {
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

    pub(super) fn remove(&mut self, number: usize) {
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

    /// The greatest member that is at most this number.
    pub(super) fn last_up_to(&mut self, number: usize) -> Option<usize> {
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
}

/// The number of the highest bit of a word that is not zero.
fn highest(word: u64) -> usize {
    word.ilog2() as usize
}

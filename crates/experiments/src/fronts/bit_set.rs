//! A bit for each x that can occur, set while a node with that x is on the front.
//!
//! All x are known before the sweep starts, so the front is a set of whole numbers, the ranks of x
//! ([`super::parts`]), and the place of a vertex is the greatest member up to its rank ([`Words`]).
//! No coordinates are compared.
//!
//! Why it is right: ranks are in the order of x. Of nodes with equal x the one that joined last is kept, the
//! others are beside it.
//!
//! Cost: O(log n) with 64 ways a level for a search and an update; the ranks cost a sort once.

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch, Work};

use super::parts::XRanks;
use super::structure::Structure;

/// The ranks of x on the front as bits, searched by words: O(log n) with base 64.
#[derive(Clone, Debug, Default)]
pub struct BitSet {
    ranks: XRanks,
    set: Words,
    /// The node that joined last, by rank of x.
    nodes: Vec<Option<FrontNode>>,
    work: Work,
}

impl FrontSearch for BitSet {
    fn begin(&mut self, input: FrontInput<'_>) {
        self.work = Work::default();
        self.ranks = XRanks::new(input, &mut self.work);
        self.set = Words::new(self.ranks.len());
        self.nodes.clear();
        self.nodes.resize(self.ranks.len(), None);
        self.work.bytes += (8 * self.set.len() + size_of_val(&self.nodes[..])) as u64;
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        let rank = self.ranks.last_up_to(x, &mut self.work);
        let member = rank.and_then(|rank| self.set.last_up_to(rank));
        member
            .and_then(|member| self.nodes[member])
            .unwrap_or(front.left_end())
    }

    fn inserted(&mut self, node: FrontNode, _: f64) {
        let rank = self.ranks.join(node);
        self.set.insert(rank);
        self.nodes[rank] = Some(node);
        self.work.updates += 1;
    }

    fn removed(&mut self, node: FrontNode, _: f64) {
        let rank = self.ranks.of(node);
        if self.nodes[rank] == Some(node) {
            self.set.remove(rank);
            self.nodes[rank] = None;
            self.work.updates += 1;
        }
    }
}

impl Structure for BitSet {
    fn work(&self) -> Option<Work> {
        Some(Work {
            visited: self.set.visited,
            ..self.work
        })
    }
}

/// A set of whole numbers below n as bits, with the greatest member up to a number.
///
/// The set is a tree of words of 64 bits: a bit of a word on a higher level says whether one of 64 words below it
/// is not zero. So a search reads one word a level on the way up, and one a level on the way down.
///
/// Cost: O(log n) with 64 ways a level, four levels for 16 million numbers; n bits and some.
#[derive(Clone, Debug, Default)]
struct Words {
    /// From the bits of the numbers up to a single word.
    levels: Vec<Vec<u64>>,
    /// Words read or changed.
    visited: u64,
}

impl Words {
    /// No numbers below `count`.
    fn new(count: usize) -> Words {
        let mut levels = Vec::new();
        let mut words = count.max(1);
        while words > 1 || levels.is_empty() {
            words = words.div_ceil(64);
            levels.push(vec![0; words]);
        }
        Words { levels, visited: 0 }
    }

    /// How many words there are.
    fn len(&self) -> usize {
        self.levels.iter().map(Vec::len).sum()
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

    /// The greatest member that is at most this number.
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
}

/// The number of the highest bit of a word that is not zero.
fn highest(word: u64) -> usize {
    word.ilog2() as usize
}

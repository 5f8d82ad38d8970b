//! A van Emde Boas tree over ranks of x ([`super::number_set`]).
//!
//! P. van Emde Boas, Preserving order in a forest in less than logarithmic time, 1975, doi:10.1109/SFCS.1975.26.
//! A set of numbers of b bits is split by the upper half of the bits into sets of b/2 bits, the clusters; one more such
//! set, the summary, holds which clusters have members. The least and the greatest member stand in the set
//! itself, and the least one in no cluster. So each step goes into one of the two and halves the bits. Sets of six bits
//! are words. The tree of [`super::bit_set`] takes six bits off a number on each level instead.
//!
//! Why it is right: a number whose cluster has no member up to it comes after all members of the clusters before.
//!
//! Cost: a search and an update visit O(log log n) sets, three for 16 million numbers, whatever the front is like:
//! to join an empty cluster and to leave one that empties takes O(1), so only one of the two costs more. The
//! clusters are arrays, O(n) bits and some words a cluster. The sweep takes no step.

use sweep_cdt::front::Work;

use super::bit_set::highest;
use super::number_set::{NumberSet, Numbers};

/// The ranks of x on the front as a van Emde Boas tree: O(log log n).
pub type VanEmdeBoas = NumberSet<Tree>;

/// A tree, and how many sets were visited.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    root: Set,
    visited: u64,
}

/// The bits of a set that is a word.
const WORD: u32 = 6;

/// A set of numbers of some bits.
#[derive(Clone, Debug)]
enum Set {
    Word(u64),
    Split(Box<Split>),
}

impl Default for Set {
    fn default() -> Set {
        Set::Word(0)
    }
}

#[derive(Clone, Debug)]
struct Split {
    /// The lower bits, which number the members of a cluster.
    lower: u32,
    /// The least and the greatest member.
    ends: Option<[usize; 2]>,
    summary: Set,
    clusters: Vec<Set>,
}

impl Split {
    fn parts(&self, number: usize) -> [usize; 2] {
        [number >> self.lower, number & ((1 << self.lower) - 1)]
    }

    fn join(&self, upper: usize, lower: usize) -> usize {
        upper << self.lower | lower
    }
}

impl Set {
    /// The empty set of numbers of so many bits.
    fn new(bits: u32) -> Set {
        if bits <= WORD {
            return Set::Word(0);
        }
        let lower = bits / 2;
        Set::Split(Box::new(Split {
            lower,
            ends: None,
            summary: Set::new(bits - lower),
            clusters: vec![Set::new(lower); 1 << (bits - lower)],
        }))
    }

    /// The least and the greatest member.
    fn ends(&self) -> Option<[usize; 2]> {
        match self {
            Set::Word(0) => None,
            Set::Word(word) => Some([word.trailing_zeros() as usize, highest(*word)]),
            Set::Split(split) => split.ends,
        }
    }

    fn insert(&mut self, mut number: usize, visited: &mut u64) {
        *visited += 1;
        let split = match self {
            Set::Word(word) => {
                *word |= 1 << number;
                return;
            }
            Set::Split(split) => split,
        };
        let Some([least, greatest]) = &mut split.ends else {
            split.ends = Some([number; 2]);
            return;
        };
        *greatest = number.max(*greatest);
        if number < *least {
            std::mem::swap(&mut number, least);
        }
        let [upper, lower] = split.parts(number);
        if split.clusters[upper].ends().is_none() {
            split.summary.insert(upper, visited);
        }
        split.clusters[upper].insert(lower, visited);
    }

    fn remove(&mut self, mut number: usize, visited: &mut u64) {
        *visited += 1;
        let split = match self {
            Set::Word(word) => {
                *word &= !(1 << number);
                return;
            }
            Set::Split(split) => split,
        };
        let Some([mut least, mut greatest]) = split.ends else {
            return;
        };
        if least == greatest {
            split.ends = None;
            return;
        }
        if number == least {
            // The next one leaves its cluster to become the least.
            let [upper, _] = split.summary.ends().expect("there is another member");
            let [lower, _] = split.clusters[upper].ends().expect("the summary says so");
            number = split.join(upper, lower);
            least = number;
        }
        let [upper, lower] = split.parts(number);
        split.clusters[upper].remove(lower, visited);
        if split.clusters[upper].ends().is_none() {
            split.summary.remove(upper, visited);
        }
        if number == greatest {
            greatest = split.summary.ends().map_or(least, |[_, upper]| {
                let [_, lower] = split.clusters[upper].ends().expect("the summary says so");
                split.join(upper, lower)
            });
        }
        split.ends = Some([least, greatest]);
    }

    fn last_up_to(&self, number: usize, visited: &mut u64) -> Option<usize> {
        *visited += 1;
        let split = match self {
            Set::Word(word) => {
                let word = word & u64::MAX >> (63 - number);
                return (word != 0).then(|| highest(word));
            }
            Set::Split(split) => split,
        };
        let [least, greatest] = split.ends?;
        if number >= greatest {
            return Some(greatest);
        }
        if number < least {
            return None;
        }
        let [upper, lower] = split.parts(number);
        let cluster = &split.clusters[upper];
        if cluster.ends().is_some_and(|[least, _]| least <= lower) {
            let lower = cluster.last_up_to(lower, visited)?;
            return Some(split.join(upper, lower));
        }
        let before = upper.checked_sub(1);
        let before = before.and_then(|upper| split.summary.last_up_to(upper, visited));
        Some(before.map_or(least, |upper| {
            let [_, lower] = split.clusters[upper].ends().expect("the summary says so");
            split.join(upper, lower)
        }))
    }

    fn bytes(&self) -> usize {
        let inside = match self {
            Set::Word(_) => 0,
            Set::Split(split) => {
                let sets = split.clusters.iter().chain([&split.summary]);
                sets.map(Set::bytes).sum::<usize>() + size_of::<Split>()
            }
        };
        size_of::<Set>() + inside
    }
}

impl Numbers for Tree {
    fn new(count: usize) -> Tree {
        let bits = usize::BITS - count.saturating_sub(1).leading_zeros();
        Tree {
            root: Set::new(bits),
            visited: 0,
        }
    }

    fn insert(&mut self, number: usize) {
        self.root.insert(number, &mut self.visited);
    }

    fn remove(&mut self, number: usize) {
        self.root.remove(number, &mut self.visited);
    }

    fn last_up_to(&mut self, number: usize) -> Option<usize> {
        self.root.last_up_to(number, &mut self.visited)
    }

    fn work(&self) -> Work {
        Work {
            visited: self.visited,
            bytes: self.root.bytes() as u64,
            ..Work::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::number_set::compare;
    use super::Tree;

    #[test]
    fn the_greatest_member_up_to_a_number_is_found() {
        compare::<Tree>();
    }
}

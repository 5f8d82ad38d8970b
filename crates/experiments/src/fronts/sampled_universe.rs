//! The sampled universe over ranks of x ([`super::number_set`]).
//!
//! P. Dinklage, J. Fischer, A. Herlez, Engineering predecessor data structures for dynamic integer sets, SEA 2021,
//! doi:10.4230/LIPIcs.SEA.2021.7, with their hybrid buckets. The upper bits of a number name its bucket. A bucket of
//! few numbers is a list in no order, one of more is a bit vector. For every bucket the top level holds the last one up to
//! it that has members, so that a search looks into two buckets at most.
//!
//! Differs from theirs: the numbers are ranks, so a bucket has about sqrt(n) of them instead of a fixed
//! count. A list becomes a bit vector when it has as many entries as that has words, and again a list at half of that.
//! Bits are searched by words. The greatest number before a bucket is looked up and not kept.
//!
//! Why it is right: a number whose bucket has no member up to it comes after all of the last bucket before.
//!
//! Cost: a search reads O(sqrt(n)) bits, a word for 64; an update that fills an empty bucket or empties one
//! changes the top level up to the next bucket with members, O(sqrt(n)) entries. The sweep takes no step.

use sweep_cdt::front::Work;

use super::bit_set::highest;
use super::number_set::{NumberSet, Numbers};

/// The ranks of x on the front in buckets of sqrt(n) numbers, empty ones skipped by a table: O(1) expected.
pub type SampledUniverse = NumberSet<Universe>;

/// Buckets, and a table over them.
#[derive(Clone, Debug, Default)]
pub struct Universe {
    /// The lower bits, which number the members of a bucket.
    bits: u32,
    /// For each bucket the last one up to it that has members.
    top: Vec<Option<usize>>,
    buckets: Vec<Bucket>,
    members: usize,
    work: Work,
}

#[derive(Clone, Debug)]
enum Bucket {
    List(Vec<usize>),
    Bits { words: Vec<u64>, members: usize },
}

impl Bucket {
    fn is_empty(&self) -> bool {
        matches!(self, Bucket::List(list) if list.is_empty())
    }

    /// The entries or words that a search looks through.
    fn len(&self) -> usize {
        match self {
            Bucket::List(list) => list.len(),
            Bucket::Bits { words, .. } => words.len(),
        }
    }

    fn last_up_to(&self, number: usize) -> Option<usize> {
        match self {
            Bucket::List(list) => list.iter().copied().filter(|&other| other <= number).max(),
            Bucket::Bits { words, .. } => {
                let (last, mask) = (number / 64, u64::MAX >> (63 - number % 64));
                let masks = std::iter::once(mask).chain(std::iter::repeat(u64::MAX));
                let mut before = (0..=last).rev().zip(masks);
                before.find_map(|(at, mask)| {
                    let word = words[at] & mask;
                    (word != 0).then(|| at * 64 + highest(word))
                })
            }
        }
    }

    /// A list of more entries than the bits have words becomes bits.
    fn insert(&mut self, number: usize, bits: u32) {
        let list = match self {
            Bucket::List(list) => list,
            Bucket::Bits { words, members } => {
                words[number / 64] |= 1 << (number % 64);
                *members += 1;
                return;
            }
        };
        list.push(number);
        let count = (1_usize << bits).div_ceil(64);
        if list.len() > count {
            let mut words = vec![0; count];
            for &number in list.iter() {
                words[number / 64] |= 1 << (number % 64);
            }
            let members = list.len();
            *self = Bucket::Bits { words, members };
        }
    }

    /// Bits of less than half as many members as words become a list.
    fn remove(&mut self, number: usize) {
        match self {
            Bucket::List(list) => list.retain(|&other| other != number),
            Bucket::Bits { words, members } => {
                words[number / 64] &= !(1 << (number % 64));
                *members -= 1;
                if 2 * *members <= words.len() {
                    let is_member = |&number: &usize| words[number / 64] >> (number % 64) & 1 != 0;
                    let list = (0..64 * words.len()).filter(is_member).collect();
                    *self = Bucket::List(list);
                }
            }
        }
    }
}

impl Universe {
    fn parts(&self, number: usize) -> [usize; 2] {
        [number >> self.bits, number & ((1 << self.bits) - 1)]
    }

    /// From a bucket on, the top level names one bucket instead of another.
    fn rename(&mut self, from: usize, old: Option<usize>, new: Option<usize>) {
        for entry in self.top[from..]
            .iter_mut()
            .take_while(|entry| **entry == old)
        {
            *entry = new;
            self.work.rearranged += 1;
        }
    }

    fn last_in(&mut self, bucket: usize, number: usize) -> Option<usize> {
        self.work.visited += self.buckets[bucket].len() as u64;
        let lower = self.buckets[bucket].last_up_to(number)?;
        Some(bucket << self.bits | lower)
    }
}

impl Numbers for Universe {
    fn new(count: usize) -> Universe {
        let bits = count.max(1).ilog2().div_ceil(2);
        let buckets = (count >> bits) + 1;
        Universe {
            bits,
            top: vec![None; buckets],
            buckets: vec![Bucket::List(Vec::new()); buckets],
            ..Universe::default()
        }
    }

    fn insert(&mut self, number: usize) {
        let [bucket, lower] = self.parts(number);
        if self.buckets[bucket].is_empty() {
            let before = self.top[bucket];
            self.rename(bucket, before, Some(bucket));
        }
        self.buckets[bucket].insert(lower, self.bits);
        self.members += 1;
        let tables = size_of_val(&self.top[..]) + size_of_val(&self.buckets[..]);
        self.work
            .hold::<u8>(tables + self.members * size_of::<usize>());
    }

    fn remove(&mut self, number: usize) {
        let [bucket, lower] = self.parts(number);
        self.work.visited += self.buckets[bucket].len() as u64;
        self.buckets[bucket].remove(lower);
        self.members -= 1;
        if self.buckets[bucket].is_empty() {
            let before = bucket.checked_sub(1).and_then(|before| self.top[before]);
            self.rename(bucket, Some(bucket), before);
        }
    }

    fn last_up_to(&mut self, number: usize) -> Option<usize> {
        let [bucket, lower] = self.parts(number);
        self.work.visited += 1;
        let last = self.top[bucket]?;
        let all = (1 << self.bits) - 1;
        if last < bucket {
            return self.last_in(last, all);
        }
        self.last_in(bucket, lower).or_else(|| {
            let before = self.top[bucket.checked_sub(1)?]?;
            self.last_in(before, all)
        })
    }

    fn work(&self) -> Work {
        self.work
    }
}

#[cfg(test)]
mod tests {
    use super::super::number_set::compare;
    use super::Universe;

    #[test]
    fn the_greatest_member_up_to_a_number_is_found() {
        compare::<Universe>();
    }
}

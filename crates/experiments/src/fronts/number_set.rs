//! Structures that keep the front as a set of whole numbers: the ranks of x ([`super::parts`]) of its nodes.
//!
//! All x are known before the sweep starts, so the place of a vertex is the greatest member up to its rank. No
//! coordinates are compared. The sets differ in how they find that member: [`super::bit_set`],
//! [`super::van_emde_boas`], [`super::sampled_universe`].
//!
//! Why it is right: ranks are in the order of x. Of nodes with equal x the one that joined last is kept, the
//! others are beside it.
//!
//! Cost: that of the set, and a sort once for the ranks. The sweep walks over nodes of equal x only, of which the
//! front has one between two events, where x is no approximation.

use std::fmt::Debug;

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch, Work};

use super::parts::XRanks;
use super::structure::Structure;

/// A set of whole numbers, with the greatest member up to a number.
pub trait Numbers: Clone + Debug + Default + 'static {
    /// No numbers below `count`; the set has room for them.
    fn new(count: usize) -> Self;
    /// A number that is no member joins.
    fn insert(&mut self, number: usize);
    /// A member leaves.
    fn remove(&mut self, number: usize);
    /// The greatest member that is at most this number.
    fn last_up_to(&mut self, number: usize) -> Option<usize>;
    /// What the set has looked at and moved, and its bytes.
    fn work(&self) -> Work;
}

/// The ranks of x on the front as a set of numbers.
#[derive(Clone, Debug, Default)]
pub struct NumberSet<N> {
    ranks: XRanks,
    set: N,
    /// The node that joined last, by rank of x.
    nodes: Vec<Option<FrontNode>>,
    work: Work,
}

impl<N: Numbers> FrontSearch for NumberSet<N> {
    fn begin(&mut self, input: FrontInput<'_>) {
        self.work = Work::default();
        self.ranks = XRanks::new(input, &mut self.work);
        self.set = N::new(self.ranks.len());
        self.nodes.clear();
        self.nodes.resize(self.ranks.len(), None);
        self.work.bytes += size_of_val(&self.nodes[..]) as u64;
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
        if self.nodes[rank].replace(node).is_none() {
            self.set.insert(rank);
        }
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

impl<N: Numbers> Structure for NumberSet<N> {
    fn work(&self) -> Option<Work> {
        let set = self.set.work();
        Some(Work {
            visited: set.visited,
            rearranged: set.rearranged,
            bytes: self.work.bytes + set.bytes,
            ..self.work
        })
    }
}

/// Compares a set with the standard library's: numbers join and leave, near each other and anywhere, few and many.
#[cfg(test)]
pub(super) fn compare<N: Numbers>() {
    for count in [1, 2, 64, 65, 5000, 100_000] {
        let mut random = sweep_cdt_testing::Random::new(5);
        let (mut set, mut members) = (N::new(count), std::collections::BTreeSet::new());
        for step in 0..20_000 {
            let near = if step % 3 == 0 { count } else { count.min(300) };
            let number = random.below(near);
            // More join at first, more leave later.
            let joins = random.below(20_000) > step;
            if joins && members.insert(number) {
                set.insert(number);
            } else if !joins && members.remove(&number) {
                set.remove(number);
            }
            for number in [number, random.below(near), random.below(count)] {
                let found = set.last_up_to(number);
                let expected = members.range(..=number).next_back();
                assert_eq!(found.as_ref(), expected, "up to {number} of {count}");
            }
        }
    }
}

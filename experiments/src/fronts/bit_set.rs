//! A bit for each x that can occur, set while a node with that x is on the front.
//!
//! All x are known before the sweep starts, so the front is a set of whole numbers, the ranks of x
//! ([`super::x_ranks`]), and the place of a vertex is the greatest member up to its rank ([`super::words`]).
//! No coordinates are compared.
//!
//! Why it is right: ranks are in the order of x. Of nodes with equal x the one that joined last is kept, the
//! others are beside it.
//!
//! Cost: O(log n) with 64 ways a level for a search and an update; the ranks cost a sort once.

use sweep_cdt::front::{Domain, Front, FrontNode, FrontSearch};

use super::structure::{Structure, Work};
use super::words::Words;
use super::x_ranks::XRanks;

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
    fn begin(&mut self, domain: Domain<'_>) {
        self.work = Work::default();
        self.ranks = XRanks::new(domain, &mut self.work);
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

//! A hash table over ranks of x: the intervals hold equally many of the vertices, wherever they crowd.
//!
//! Every interval remembers the node that joined in it last. If that has left the front, the nearest
//! interval on either side that has one is taken.
//!
//! Why it is right: ranks are in the order of x ([`super::parts`]), so the node found is near.
//!
//! Cost: O(1) expected for a search where the front is spread over the vertices as they are from left to
//! right; O(n) at worst. The ranks cost a sort once.

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch, Work};

use super::parts::XRanks;
use super::structure::Structure;

/// A hash table with 2 sqrt(n) intervals of equally many x: O(1) expected.
#[derive(Clone, Debug, Default)]
pub struct RankTable {
    ranks: XRanks,
    table: Vec<Option<FrontNode>>,
    work: Work,
}

impl RankTable {
    fn interval(&self, rank: usize) -> usize {
        rank * self.table.len() / self.ranks.len()
    }
}

impl FrontSearch for RankTable {
    fn begin(&mut self, input: FrontInput<'_>) {
        self.work = Work::default();
        self.ranks = XRanks::new(input, &mut self.work);
        self.table.clear();
        self.table.resize(2 * input.len().isqrt() + 1, None);
        self.work.bytes += size_of_val(&self.table[..]) as u64;
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        let Some(rank) = self.ranks.last_up_to(x, &mut self.work) else {
            return front.left_end();
        };
        let at = self.interval(rank);
        let around = (0..self.table.len()).flat_map(|i| [at.checked_sub(i), Some(at + i)]);
        for interval in around.flatten() {
            let Some(entry) = self.table.get_mut(interval) else {
                continue;
            };
            self.work.visited += 1;
            if let Some(node) = *entry {
                if front.contains(node) {
                    return node;
                }
                *entry = None;
            }
        }
        front.left_end()
    }

    fn inserted(&mut self, node: FrontNode, _: f64) {
        let rank = self.ranks.join(node);
        let interval = self.interval(rank);
        self.table[interval] = Some(node);
        self.work.updates += 1;
    }
}

impl Structure for RankTable {
    fn work(&self) -> Option<Work> {
        Some(self.work)
    }
}

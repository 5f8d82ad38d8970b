//! A skip list over the nodes of the front (Pugh 1990). All nodes are linked in order of x at level 0. About one in
//! four nodes of a level is linked at the next level too, so that a search from the top passes O(log n) nodes. A fixed
//! hash of the rank decides which, so the list is the same in every run. Among equal x a search names any node. Cost:
//! O(log n) expected for search, insertion and removal on any front; 64 bytes for each vertex on the front at one time.

use super::list::{Front, FrontNode};
use super::search::{FrontInput, FrontSearch};
use super::work::{Tally, Work};
use crate::ids::narrow;
use alloc::vec;
use alloc::vec::Vec;

/// A skip list by x: O(log n) expected on any front. [`SkipList::counting`] makes one that counts its work.
#[derive(Clone, Debug)]
pub struct SkipList<const COUNTS: bool = false> {
    /// Tower 0 is the head; the towers in `free` are not in use.
    towers: Vec<Tower>,
    free: Vec<u32>,
    tally: Tally<COUNTS>,
}

/// Enough for 4^12 nodes on the front.
const LEVELS: usize = 12;
/// No tower: the end of a level.
const END: u32 = u32::MAX;

#[derive(Clone, Debug)]
struct Tower {
    x: f64,
    node: Option<FrontNode>,
    /// The next tower at each level that this one reaches; [`END`] above.
    next: [u32; LEVELS],
}

impl Tower {
    const HEAD: Tower = Tower {
        x: f64::NEG_INFINITY,
        node: None,
        next: [END; LEVELS],
    };
}

impl Default for SkipList {
    fn default() -> SkipList {
        SkipList::new()
    }
}

impl SkipList {
    /// A `SkipList<true>`, which counts its work.
    pub fn counting() -> SkipList<true> {
        SkipList::new()
    }
}

impl SkipList<true> {
    /// The work since the run began.
    pub fn work(&self) -> Work {
        self.tally.0
    }
}

impl<const COUNTS: bool> FrontSearch for SkipList<COUNTS> {
    fn begin(&mut self, _: FrontInput<'_>) {
        self.towers.clear();
        self.towers.push(Tower::HEAD);
        self.free.clear();
        self.tally = Tally::default();
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        let before = self.path(|tower| tower.x <= x);
        self.towers[before[0] as usize]
            .node
            .unwrap_or(front.left_end())
    }

    fn inserted(&mut self, node: FrontNode, x: f64) {
        let before = self.path(|tower| (tower.x, tower.node) < (x, Some(node)));
        let mut tower = Tower {
            x,
            node: Some(node),
            next: [END; LEVELS],
        };
        let place = self.free.pop().unwrap_or(narrow(self.towers.len()));
        for (level, &tower_before) in before.iter().enumerate().take(height(node)) {
            let link = &mut self.towers[tower_before as usize].next[level];
            tower.next[level] = *link;
            *link = place;
        }
        match self.towers.get_mut(place as usize) {
            Some(reused) => *reused = tower,
            None => self.towers.push(tower),
        }
        self.linked(node);
    }

    fn removed(&mut self, node: FrontNode, x: f64) {
        let before = self.path(|tower| (tower.x, tower.node) < (x, Some(node)));
        let place = self.towers[before[0] as usize].next[0];
        for (level, &tower_before) in before.iter().enumerate().take(height(node)) {
            self.towers[tower_before as usize].next[level] =
                self.towers[place as usize].next[level];
        }
        self.free.push(place);
        self.linked(node);
    }
}

impl<const COUNTS: bool> SkipList<COUNTS> {
    fn new() -> SkipList<COUNTS> {
        SkipList {
            towers: vec![Tower::HEAD],
            free: Vec::new(),
            tally: Tally::default(),
        }
    }

    /// Tallies that a node has joined or left, with a link on each of its levels.
    fn linked(&mut self, node: FrontNode) {
        self.tally.count(|work| {
            work.updates += 1;
            work.rearranged += height(node).min(LEVELS) as u64;
            work.hold::<Tower>(self.towers.len());
        });
    }

    /// At each level the last tower for which `is_before` holds.
    fn path(&mut self, is_before: impl Fn(&Tower) -> bool) -> [u32; LEVELS] {
        let mut path = [0; LEVELS];
        let mut at = 0;
        for level in (0..LEVELS).rev() {
            loop {
                let next = self.towers[at as usize].next[level];
                if next == END {
                    break;
                }
                self.tally.count(|work| {
                    work.comparisons += 1;
                    work.visited += 1;
                });
                if !is_before(&self.towers[next as usize]) {
                    break;
                }
                at = next;
            }
            path[level] = at;
        }
        path
    }
}

/// How many levels a node's tower has (may exceed [`LEVELS`]): at least one, each further one with probability 1/4.
fn height(node: FrontNode) -> usize {
    let mixed = (node.rank() as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let mixed = (mixed ^ mixed >> 29).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    1 + (mixed >> 32).trailing_zeros() as usize / 2
}

#[cfg(test)]
mod tests {
    use super::{Front, FrontInput, FrontNode, FrontSearch, LEVELS, SkipList, Tower, Work, height};

    /// Memory depends on the longest front, not on how many vertices are ever on it.
    #[test]
    fn the_place_of_a_node_that_has_left_is_used_again() {
        const LONGEST: usize = 10;
        let mut list = SkipList::default();
        for rank in 0..1000 {
            if rank >= LONGEST {
                let gone = rank - LONGEST;
                list.removed(FrontNode::from_rank(gone), gone as f64);
            }
            list.inserted(FrontNode::from_rank(rank), rank as f64);
        }
        assert_eq!(list.towers.len(), LONGEST + 1);
    }

    #[test]
    fn every_fourth_node_of_a_level_is_on_the_next() {
        let mut on_level = [0_i32; 40];
        for rank in 0..1 << 16 {
            for count in &mut on_level[..height(FrontNode::from_rank(rank))] {
                *count += 1;
            }
        }
        let mut expected = 1 << 16;
        for count in &on_level[..5] {
            assert!((count - expected).abs() <= expected / 4, "{on_level:?}");
            expected /= 4;
        }
        assert_eq!(on_level[16], 0, "none is much higher");
    }

    #[test]
    fn nodes_passed_are_counted() {
        let low: Vec<FrontNode> = (0..100)
            .map(FrontNode::from_rank)
            .filter(|&node| height(node) == 1)
            .take(10)
            .collect();
        let points = [[0.0, 0.0]; 100];
        let mut list = SkipList::counting();
        list.begin(FrontInput::new(&points));
        let mut expected = Work::default();
        // Each node comes after all others.
        for (place, &node) in low.iter().enumerate() {
            list.inserted(node, place as f64);
            expected.comparisons += place as u64;
        }
        list.locate(3.5, &Front::new(100));
        expected.comparisons += 5;
        list.removed(low[0], 0.0);
        expected.comparisons += 1;
        expected.visited = expected.comparisons;
        (expected.updates, expected.rearranged) = (11, 11);
        expected.bytes = 11 * size_of::<Tower>() as u64;
        assert_eq!(list.work(), expected);

        let high = (0..100_000).map(FrontNode::from_rank);
        let high = high.max_by_key(|&node| height(node)).expect("a node");
        list.inserted(high, 20.0);
        expected.rearranged += height(high).min(LEVELS) as u64;
        assert!(height(high) > 4);
        assert_eq!(list.work().rearranged, expected.rearranged);

        list.begin(FrontInput::new(&points));
        assert_eq!(list.work(), Work::default());
    }
}

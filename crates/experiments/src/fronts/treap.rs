//! A treap (Seidel and Aragon 1996): a search tree by x whose nodes have random priorities, greater ones
//! above smaller ones.
//!
//! Why it is right: an update splits a subtree at a key, or joins two of which one is before the other; both
//! keep the order of the keys and that of the priorities.
//!
//! Cost: O(log n) expected for a search and an update. The sweep takes no step. A fixed hash of rank and seed makes the
//! priorities, so the tree is the same in every run; and against points made by who knows the seed both take O(n).

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch, Work};

use super::parts::{Arena, Branch, Key, LEFT, NONE, RIGHT, mixed};
use super::structure::Structure;

/// A search tree with random priorities: O(log n) expected.
#[derive(Clone, Debug)]
pub struct Treap {
    seed: u64,
    arena: Arena,
    work: Work,
}

impl Treap {
    /// The treap whose priorities follow from this seed.
    pub fn new(seed: u64) -> Treap {
        Treap {
            seed,
            arena: Arena::default(),
            work: Work::default(),
        }
    }

    fn priority(&self, place: u32) -> u64 {
        mixed(self.arena.key(place).1, self.seed)
    }

    /// Goes down from the head while `goes_on`, to the right where a key is before the place searched.
    /// Returns where it ended: a node or the head, the side, and the child there, if any.
    fn descend(
        &mut self,
        is_before: impl Fn(Key) -> bool,
        goes_on: impl Fn(&Treap, u32) -> bool,
    ) -> (u32, usize, u32) {
        let (mut at, mut side, mut next) = (NONE, RIGHT, self.arena.root());
        while next != NONE && goes_on(self, next) {
            self.work.visited += 1;
            self.work.comparisons += 1;
            at = next;
            side = usize::from(is_before(self.arena.key(at)));
            next = self.arena.child(at, side);
        }
        (at, side, next)
    }

    /// Links a node or none below another, and counts it.
    fn link(&mut self, (above, side): (u32, usize), child: u32) {
        self.work.rearranged += 1;
        self.arena.set_child(above, side, child);
    }
}

impl FrontSearch for Treap {
    fn begin(&mut self, _: FrontInput<'_>) {
        *self = Treap::new(self.seed);
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        let (mut at, mut last) = (self.arena.root(), None);
        while at != NONE {
            self.work.visited += 1;
            self.work.comparisons += 1;
            let (key, node) = self.arena.key(at);
            let is_before = key <= x;
            if is_before {
                last = Some(node);
            }
            at = self.arena.child(at, usize::from(is_before));
        }
        last.unwrap_or(front.left_end())
    }

    fn inserted(&mut self, node: FrontNode, x: f64) {
        let key = (x, node);
        let priority = mixed(node, self.seed);
        let (above, side, mut rest) = self.descend(
            |other| other < key,
            |treap, place| treap.priority(place) >= priority,
        );
        let place = self.arena.add(key);
        self.link((above, side), place);
        // The subtree that was there is split: what is before the key goes left, what is after it right.
        let mut holes = [(place, LEFT), (place, RIGHT)];
        while rest != NONE {
            self.work.comparisons += 1;
            let from = if self.arena.key(rest) < key {
                LEFT
            } else {
                RIGHT
            };
            self.link(holes[from], rest);
            let inner = 1 - from;
            holes[from] = (rest, inner);
            rest = self.arena.child(rest, inner);
        }
        for hole in holes {
            self.link(hole, NONE);
        }
        self.work.updates += 1;
        self.work.hold::<Branch>(self.arena.len());
    }

    fn removed(&mut self, node: FrontNode, x: f64) {
        let key = (x, node);
        let (above, side, place) = self.descend(
            |other| other < key,
            |treap, place| treap.arena.key(place) != key,
        );
        // Its subtrees are joined: of two roots the one of greater priority comes first.
        let mut parts = [LEFT, RIGHT].map(|side| self.arena.child(place, side));
        let mut hole = (above, side);
        while !parts.contains(&NONE) {
            let upper = usize::from(self.priority(parts[LEFT]) < self.priority(parts[RIGHT]));
            self.link(hole, parts[upper]);
            let inner = 1 - upper;
            hole = (parts[upper], inner);
            parts[upper] = self.arena.child(parts[upper], inner);
        }
        let rest = parts[LEFT].max(parts[RIGHT]);
        self.link(hole, rest);
        self.arena.free(place);
        self.work.updates += 1;
    }
}

impl Structure for Treap {
    fn work(&self) -> Option<Work> {
        Some(self.work)
    }
}

#[cfg(test)]
mod tests {
    use sweep_cdt::front::{Front, FrontNode, FrontSearch};

    use super::super::parts::{LEFT, NONE, RIGHT, mixed};
    use super::Treap;

    /// Who knows the hash can make a tree without branches.
    #[test]
    fn a_front_against_the_hash_is_a_path() {
        const NODES: usize = 500;
        let mut nodes: Vec<FrontNode> = (0..NODES).map(FrontNode::from_rank).collect();
        nodes.sort_by_key(|&node| mixed(node, 3));
        let mut treap = Treap::new(3);
        for (x, &node) in nodes.iter().rev().enumerate() {
            treap.inserted(node, x as f64);
        }
        let before = treap.work.visited;
        treap.locate(NODES as f64, &Front::new(NODES));
        assert_eq!(treap.work.visited - before, NODES as u64);
    }

    /// Priorities fall from every node to its children, whatever joined and left before.
    #[test]
    fn greater_priorities_stay_above() {
        let mut treap = Treap::new(3);
        for rank in 0..500 {
            let x = |rank: usize| (rank * 7919 % 503) as f64;
            treap.inserted(FrontNode::from_rank(rank), x(rank));
            if rank % 3 == 2 {
                let gone = rank / 3 * 2;
                treap.removed(FrontNode::from_rank(gone), x(gone));
            }
            let mut below = vec![treap.arena.root()];
            while let Some(place) = below.pop() {
                for child in [LEFT, RIGHT].map(|side| treap.arena.child(place, side)) {
                    if child != NONE {
                        assert!(treap.priority(place) > treap.priority(child));
                        below.push(child);
                    }
                }
            }
        }
    }
}

//! A splay tree (Sleator and Tarjan 1985) over a random tenth of the front, as Shewchuk's Triangle keeps for
//! Fortune's sweep. From the node found the sweep walks to the right one.
//!
//! Why it is right: splaying keeps the order of the keys. The root is then the last node on the way to the
//! place searched, so it is beside that place among the sampled nodes.
//!
//! Cost: O(log n) for a search and an update, averaged over a run, and O(n) for a single one. Nine of ten updates cost
//! nothing. The sweep walks some ten steps, whatever the front is like; but a fixed hash of rank and seed draws the
//! sample, and against points made by who knows the seed it walks O(n).

use std::cmp::Ordering;

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch, Work};

use super::parts::{Arena, Branch, Key, LEFT, NONE, RIGHT, mixed};
use super::structure::Structure;

/// A splay tree over one in `share` nodes of the front: O(log n) averaged over a run, and a walk.
#[derive(Clone, Debug)]
pub struct SampleTree {
    share: u64,
    seed: u64,
    arena: Arena,
    work: Work,
}

impl SampleTree {
    /// The tree over one in `share` nodes, which the seed draws.
    ///
    /// # Panics
    /// If `share` is zero.
    pub fn new(share: u64, seed: u64) -> SampleTree {
        assert!(share > 0, "one in no nodes");
        SampleTree {
            share,
            seed,
            arena: Arena::default(),
            work: Work::default(),
        }
    }

    fn is_sampled(&self, node: FrontNode) -> bool {
        mixed(node, self.seed).is_multiple_of(self.share)
    }

    /// Makes the last node on the way to a place the root, top down. `order` says where a key lies as seen
    /// from that place. Returns how the root lies; `None` if there is no node.
    fn splay(&mut self, order: impl Fn(Key) -> Ordering) -> Option<Ordering> {
        let mut at = self.arena.root();
        if at == NONE {
            return None;
        }
        // The head holds what is after the place as its left child, what is before it as its right one.
        self.arena.set_child(NONE, LEFT, NONE);
        self.arena.set_child(NONE, RIGHT, NONE);
        let mut ends = [NONE; 2];
        let mut found = self.look(at, &order);
        while let Some(side) = way(found) {
            let mut next = self.arena.child(at, side);
            if next == NONE {
                break;
            }
            let mut beyond = self.look(next, &order);
            if way(beyond) == Some(side) {
                // Two steps to one side: turn them round first.
                let inner = self.arena.child(next, 1 - side);
                self.link(at, side, inner);
                self.link(next, 1 - side, at);
                (at, found) = (next, beyond);
                next = self.arena.child(at, side);
                if next == NONE {
                    break;
                }
                beyond = self.look(next, &order);
            }
            self.link(ends[side], side, at);
            ends[side] = at;
            (at, found) = (next, beyond);
        }
        let parts = [LEFT, RIGHT].map(|side| self.arena.child(at, side));
        self.link(ends[RIGHT], RIGHT, parts[LEFT]);
        self.link(ends[LEFT], LEFT, parts[RIGHT]);
        let outer = [LEFT, RIGHT].map(|side| self.arena.child(NONE, side));
        self.link(at, LEFT, outer[RIGHT]);
        self.link(at, RIGHT, outer[LEFT]);
        self.arena.set_root(at);
        Some(found)
    }

    fn look(&mut self, place: u32, order: impl Fn(Key) -> Ordering) -> Ordering {
        self.work.visited += 1;
        self.work.comparisons += 1;
        order(self.arena.key(place))
    }

    /// Links a node or none below another, and counts it.
    fn link(&mut self, above: u32, side: usize, child: u32) {
        self.work.rearranged += 1;
        self.arena.set_child(above, side, child);
    }
}

/// The side on which to go on from a node that lies so; `None` at the place itself.
fn way(found: Ordering) -> Option<usize> {
    match found {
        Ordering::Less => Some(RIGHT),
        Ordering::Greater => Some(LEFT),
        Ordering::Equal => None,
    }
}

/// How one key lies as seen from another.
fn compare(key: Key, from: Key) -> Ordering {
    key.0.total_cmp(&from.0).then(key.1.cmp(&from.1))
}

impl FrontSearch for SampleTree {
    fn begin(&mut self, _: FrontInput<'_>) {
        *self = SampleTree::new(self.share, self.seed);
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        let found = self.splay(|(key, _)| {
            if key <= x {
                Ordering::Less
            } else {
                Ordering::Greater
            }
        });
        found.map_or(front.left_end(), |_| self.arena.key(self.arena.root()).1)
    }

    fn inserted(&mut self, node: FrontNode, x: f64) {
        if !self.is_sampled(node) {
            return;
        }
        let key = (x, node);
        let found = self.splay(|other| compare(other, key));
        let place = self.arena.add(key);
        if let Some(side) = found.and_then(way) {
            // The root goes to one side with all beyond it, its subtree next to the key to the other.
            let root = self.arena.root();
            let inner = self.arena.child(root, side);
            self.link(place, side, inner);
            self.link(root, side, NONE);
            self.link(place, 1 - side, root);
        }
        self.arena.set_root(place);
        self.work.updates += 1;
        self.work.hold::<Branch>(self.arena.len());
    }

    fn removed(&mut self, node: FrontNode, x: f64) {
        if !self.is_sampled(node) {
            return;
        }
        let key = (x, node);
        let found = self.splay(|other| compare(other, key));
        assert_eq!(found, Some(Ordering::Equal), "the node is in the tree");
        let place = self.arena.root();
        let [left, right] = [LEFT, RIGHT].map(|side| self.arena.child(place, side));
        self.arena.set_root(left);
        if left == NONE {
            self.arena.set_root(right);
        } else {
            // The last node of the left part becomes its root, which has none to its right.
            self.splay(|_| Ordering::Less);
            let root = self.arena.root();
            self.link(root, RIGHT, right);
        }
        self.arena.free(place);
        self.work.updates += 1;
    }
}

impl Structure for SampleTree {
    fn work(&self) -> Option<Work> {
        Some(self.work)
    }
}

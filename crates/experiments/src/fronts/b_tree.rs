//! The standard library's B-tree, keyed by x and then by rank.
//!
//! Cost: O(log n) for a search and an update, whatever the front is like. The sweep takes no step. A key counts the
//! comparisons itself, in a counter of the thread; so one run at a time can be counted on a thread.

use std::cell::Cell;
use std::cmp::Ordering;
use std::collections::BTreeSet;

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch, Work};

use super::structure::Structure;

thread_local! {
    static COMPARISONS: Cell<u64> = const { Cell::new(0) };
}

/// A node with its x; without a node, the end of all nodes of this x.
#[derive(Clone, Copy, Debug)]
struct Key(f64, Option<FrontNode>);

impl Ord for Key {
    fn cmp(&self, other: &Key) -> Ordering {
        COMPARISONS.set(COMPARISONS.get() + 1);
        let rank = |key: &Key| key.1.map_or(usize::MAX, FrontNode::rank);
        let by_x = self.0.total_cmp(&other.0);
        by_x.then_with(|| rank(self).cmp(&rank(other)))
    }
}

impl PartialOrd for Key {
    fn partial_cmp(&self, other: &Key) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Key {
    fn eq(&self, other: &Key) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Key {}

/// The standard library's B-tree: O(log n).
#[derive(Clone, Debug, Default)]
pub struct BTree {
    keys: BTreeSet<Key>,
    work: Work,
}

impl FrontSearch for BTree {
    fn begin(&mut self, _: FrontInput<'_>) {
        self.keys.clear();
        self.work = Work::default();
        COMPARISONS.set(0);
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        let last = self.keys.range(..=Key(x, None)).next_back();
        last.and_then(|key| key.1).unwrap_or(front.left_end())
    }

    fn inserted(&mut self, node: FrontNode, x: f64) {
        self.keys.insert(Key(x, Some(node)));
        self.work.updates += 1;
        self.work.hold::<Key>(self.keys.len());
    }

    fn removed(&mut self, node: FrontNode, x: f64) {
        self.keys.remove(&Key(x, Some(node)));
        self.work.updates += 1;
    }
}

impl Structure for BTree {
    fn work(&self) -> Option<Work> {
        let comparisons = COMPARISONS.get();
        Some(Work {
            comparisons,
            visited: comparisons,
            ..self.work
        })
    }
}

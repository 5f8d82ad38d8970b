//! Tables over intervals of x, each of which remembers the node that joined in it last. The tables differ in how they
//! find the interval of an x: [`super::rank_table`], [`super::learned_table`], [`super::fixed_table`].
//!
//! If the node of an interval has left the front, the nearest interval on either side that has one is taken.
//!
//! Why it is right: intervals are in the order of x, so the node found is near. The front itself says whether the
//! node is still on it.
//!
//! Cost: a search finds its interval, and looks through the empty intervals around it, O(sqrt(n)) where there are so
//! many. An update finds its interval if no search has. The sweep walks over the
//! nodes between: one or two where each interval has a node, O(n) at worst.

use std::fmt::Debug;

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch, Work};

use super::structure::Structure;

/// How a table finds the interval of an x.
pub trait Intervals: Clone + Debug + Default + 'static {
    /// A run begins. Returns how many intervals there are, one at least.
    fn begin(&mut self, input: FrontInput<'_>, work: &mut Work) -> usize;
    /// The interval of this x among `count`.
    fn of(&self, x: f64, count: usize, work: &mut Work) -> usize;
    /// A node has joined the front.
    fn joined(&mut self, node: FrontNode) {
        let _ = node;
    }
}

/// A table over intervals of x.
#[derive(Clone, Debug, Default)]
pub struct IntervalTable<I> {
    intervals: I,
    /// The node that joined last, by interval.
    table: Vec<Option<FrontNode>>,
    /// The last search and its interval.
    searched: (f64, usize),
    work: Work,
}

impl<I: Intervals> FrontSearch for IntervalTable<I> {
    fn begin(&mut self, input: FrontInput<'_>) {
        self.work = Work::default();
        let count = self.intervals.begin(input, &mut self.work);
        self.table.clear();
        self.table.resize(count, None);
        self.searched = (f64::NAN, 0);
        self.work.bytes += size_of_val(&self.table[..]) as u64;
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        let at = self.intervals.of(x, self.table.len(), &mut self.work);
        self.searched = (x, at);
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

    fn inserted(&mut self, node: FrontNode, x: f64) {
        // A new vertex has just been located.
        let at = match self.searched {
            (searched, at) if searched == x => at,
            _ => self.intervals.of(x, self.table.len(), &mut self.work),
        };
        self.intervals.joined(node);
        self.table[at] = Some(node);
        self.work.updates += 1;
    }
}

impl<I: Intervals> Structure for IntervalTable<I> {
    fn work(&self) -> Option<Work> {
        Some(self.work)
    }
}

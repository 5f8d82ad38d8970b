//! The paper's hash table over intervals of x (section 3.4.1, after Žalik 2005). Each interval remembers the node
//! inserted in it last. A search looks into the interval of x and, if that is empty or its node has left the front,
//! into those on either side. The node found is usually near: most nodes leave when one beside them joins the front.
//!
//! Cost: O(1) expected for a search. There are sqrt(n) intervals, about as many as the front has vertices if points are
//! spread evenly, and a single one for a few points. If points swept one after another crowd in some intervals, as
//! those of clusters do, there are up to eight times as many. If the sample of the points is badly skewed, as by a
//! dense cluster in a wide domain, the intervals end at quantiles of the sample, and finding one takes O(log n). At worst
//! the sweep walks over O(n) nodes in every search: where nodes have left the intervals around, and the one inserted last
//! is far (`towers` of `sweep-cdt-generate`), or where the points know the sample. The sweep's budget bounds such walks.
//!
//! A front may be far longer than sqrt(n): that of a row, or of edges that hang down from one vertex. So the table
//! grows: when the front has more than eight nodes for each equal interval, each interval is cut into four, which
//! inherit its node. Nodes are counted each time that half as many vertices again have joined the front, O(n) in all.
//!
//! Differs from the paper: an entry outlives its node, as the search notices; intervals are cut, or end at quantiles.

use alloc::vec::Vec;
use core::iter::successors;

use super::intervals::Intervals;
use super::list::{Front, FrontNode};
use super::search::{FrontInput, FrontSearch};
use super::work::{Tally, Work};
use crate::bucket::sampled;
use crate::tuning::{
    INTERVALS_SEARCHED, NODES_IN_INTERVAL, ONE_INTERVAL, PARTS_OF_INTERVAL, SAMPLE_OF_X, Tuning,
};

/// Intervals of x that remember their last insertion: O(1) expected. The default.
/// [`HashTable::counting`] makes a `HashTable<true>`, which counts its work.
#[derive(Clone, Debug)]
pub struct HashTable<const COUNTS: bool = false> {
    intervals: Intervals,
    /// The node inserted last in each interval; if there is none, the left end of the front, which is never inserted.
    table: Vec<FrontNode>,
    last: FrontNode,
    /// Once the node inserted last has this rank or a later one, the nodes of the front are counted.
    look: usize,
    searched: (f64, usize),
    tuning: &'static Tuning,
    tally: Tally<COUNTS>,
}

impl Default for HashTable {
    fn default() -> HashTable {
        HashTable::new()
    }
}

impl HashTable {
    /// A hash table that counts its work.
    pub fn counting() -> HashTable<true> {
        HashTable::new()
    }

    /// Uses these thresholds from the next run on.
    pub(crate) fn tune(&mut self, tuning: &'static Tuning) {
        self.tuning = tuning;
    }
}

impl HashTable<true> {
    /// The work since the run began.
    pub fn work(&self) -> Work {
        self.tally.0
    }
}

impl<const COUNTS: bool> HashTable<COUNTS> {
    fn new() -> HashTable<COUNTS> {
        HashTable {
            intervals: Intervals::default(),
            table: Vec::new(),
            last: FrontNode::from_rank(0),
            look: 0,
            searched: (f64::NAN, 0),
            tuning: &Tuning::REAL,
            tally: Tally::default(),
        }
    }

    /// Counts the nodes of the front, and cuts equal intervals until there are enough. Quantiles stay.
    #[cold]
    #[inline(never)]
    fn grow(&mut self, front: &Front) {
        let rank = self.last.rank();
        self.look = rank + rank / 2;
        let length = successors(front.after(front.left_end()), |&node| front.after(node)).count();
        while length > NODES_IN_INTERVAL * self.table.len() {
            if !self.intervals.divide(PARTS_OF_INTERVAL) {
                self.look = usize::MAX;
                return;
            }
            let parts = self
                .table
                .iter()
                .flat_map(|&node| [node; PARTS_OF_INTERVAL]);
            self.table = parts.collect();
        }
        self.hold();
    }

    fn hold(&mut self) {
        let bytes = size_of_val(&self.table[..]) + self.intervals.bytes();
        self.tally.count(|work| work.hold::<u8>(bytes));
    }
}

impl<const COUNTS: bool> FrontSearch for HashTable<COUNTS> {
    fn begin(&mut self, input: FrontInput<'_>) {
        let n = input.len();
        let count = if n < ONE_INTERVAL { 1 } else { n.isqrt() + 1 };
        let [of_each, most] = SAMPLE_OF_X;
        let most = if count > 1 {
            most.min(of_each * count)
        } else {
            0
        };
        let sample = sampled(n, most).collect();
        let (intervals, count) = Intervals::new(sample, |v| input.x(v), count, self.tuning);
        self.intervals = intervals;
        self.tally = Tally::default();
        self.table.clear();
        let none = FrontNode::from_rank(n);
        self.table.resize(count, none);
        self.last = FrontNode::from_rank(0);
        self.look = NODES_IN_INTERVAL * count;
        self.searched = (f64::NAN, 0);
        self.hold();
    }

    #[inline(always)]
    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        if self.last.rank() >= self.look {
            self.grow(front);
        }
        let tally = &mut self.tally;
        let at = self.intervals.number(x, self.table.len(), tally);
        self.searched = (x, at);
        let live = |node: FrontNode, tally: &mut Tally<COUNTS>| {
            tally.count(|work| work.visited += 1);
            (node != front.left_end() && front.contains(node)).then_some(node)
        };
        if let Some(node) = live(self.table[at], tally) {
            return node;
        }
        let around = (1..=INTERVALS_SEARCHED).flat_map(|i| [at.checked_sub(i), Some(at + i)]);
        around
            .filter_map(|i| live(*self.table.get(i?)?, tally))
            .next()
            .or_else(|| live(self.last, &mut self.tally))
            .unwrap_or(front.left_end())
    }

    #[inline(always)]
    fn inserted(&mut self, node: FrontNode, x: f64) {
        let tally = &mut self.tally;
        tally.count(|work| work.updates += 1);
        // A new vertex has just been located.
        let at = match self.searched {
            (searched, at) if searched.total_cmp(&x).is_eq() => at,
            _ => self.intervals.number(x, self.table.len(), tally),
        };
        self.table[at] = node;
        self.last = node;
    }
}

#[cfg(test)]
mod tests {
    use super::{Front, FrontInput, FrontNode, FrontSearch, HashTable, Work};

    /// Twenty-four vertices begin the intervals 0, 1, 2 and 4 of five. Four join the front; each look is counted.
    #[test]
    fn looks_are_counted() {
        let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [4.0, 0.0]].repeat(6);
        let mut table = HashTable::counting();
        table.begin(FrontInput::new(&points));
        let mut front = Front::new(points.len());
        let nodes = [0, 1, 2, 3].map(FrontNode::from_rank);
        let mut left = front.left_end();
        for node in nodes {
            front.insert(node, left);
            table.inserted(node, points[node.rank()][0]);
            left = node;
        }
        let entries = 5 * size_of::<FrontNode>() as u64;
        let mut expected = Work {
            updates: 4,
            bytes: entries,
            ..Work::default()
        };
        assert_eq!(table.work(), expected, "equal intervals are computed");
        assert_eq!(table.locate(1.0, &front), nodes[1]);
        expected.visited += 1;
        assert_eq!(table.work(), expected);
        // The node has left: its left neighbour is looked at.
        front.remove(nodes[1]);
        assert_eq!(table.locate(1.0, &front), nodes[0]);
        expected.visited += 2;
        assert_eq!(table.work(), expected);

        table.begin(FrontInput::new(&points));
        let begun = Work {
            bytes: entries,
            ..Work::default()
        };
        assert_eq!(table.work(), begun, "another run");
    }

    /// A front of 10,000 nodes in a row has 201 intervals at first, which are cut twice; each node that joined later is
    /// found near its place. If every other node leaves, the intervals are cut once.
    #[test]
    fn a_long_front_has_more_intervals() {
        const NODES: usize = 10_000;
        let points: Vec<_> = (0..4 * NODES).map(|i| [(i % NODES) as f64, 0.0]).collect();
        for (some_leave, cuts) in [(false, 2), (true, 1)] {
            let (mut table, mut front) = (HashTable::counting(), Front::new(points.len()));
            table.begin(FrontInput::new(&points));
            let mut left = front.left_end();
            for node in (0..NODES).map(FrontNode::from_rank) {
                let x = points[node.rank()][0];
                table.locate(x, &front);
                front.insert(node, left);
                table.inserted(node, x);
                left = node;
                if some_leave && node.rank() % 2 == 1 {
                    left = front.before(node).expect("it is not the first one");
                    front.remove(node);
                }
            }
            let intervals = 201 * super::PARTS_OF_INTERVAL.pow(cuts);
            let bytes = (intervals * size_of::<FrontNode>()) as u64;
            assert_eq!((table.table.len(), table.work().bytes), (intervals, bytes));
            for rank in 7_000..9_900 {
                let found = table.locate(rank as f64, &front).rank();
                assert!(
                    found.abs_diff(rank) <= 201 / 4_usize.pow(cuts),
                    "{found} for {rank}"
                );
            }
        }
    }
}

//! The paper's structure (section 3.4.1, after Žalik 2005): a hash table over intervals of x.
//!
//! Every interval remembers the node that was inserted in it last. A search looks into the interval of x.
//! If that is empty or its node has left the front, the search looks into the intervals on either side. The
//! node found is usually near: most nodes leave the front when one beside them joins it.
//!
//! Cost: O(1) expected for a search. There are sqrt(n) intervals, about as many as the front has vertices
//! where the points are spread evenly, and a single one for a few points. Points that are swept one after
//! another may crowd in some of them, as those of clusters do; then there are up to eight times as many. A dense
//! cluster in a wide domain would crowd a few of many equal intervals all the way; then the intervals end at
//! quantiles of the points, and finding one takes O(log n). A sample of the points shows both beforehand. Where
//! walks are long nevertheless, they are told to the table. When they add up to more than a few steps a vertex, it
//! asks for the places of all vertices from left to right and searches among these ([`Places`]). So a search costs
//! O(log n) at worst, averaged over a run.
//!
//! Differs from the paper: the table is not updated when a node leaves the front; the search notices it.
//! Intervals may be quantiles or places.

use super::intervals::{Intervals, Places};
use super::list::{Front, FrontNode};
use super::search::{Domain, FrontSearch, Patience};
use super::work::{Tally, Work};
use crate::bucket::sampled;

/// Intervals of x that remember their last insertion: O(1) expected, O(log n) at worst. The default.
///
/// `HashTable<Work>` counts its work, and is made by [`HashTable::counting`].
#[derive(Clone, Debug)]
pub struct HashTable<T = ()> {
    intervals: Intervals,
    /// The node inserted last in each interval; the left end of the front, which is never inserted, for none.
    table: Vec<FrontNode>,
    last: FrontNode,
    /// The x that was searched last, and its interval.
    searched: (f64, usize),
    patience: Patience,
    tally: T,
}

/// Fewer vertices have one interval, for their front is short.
const FEW: usize = 24;
/// How many intervals are searched on either side before the last node inserted is taken.
const REACH: usize = 16;
/// How many points a sample has for each interval, and at most.
const SAMPLE: [usize; 2] = [2, 4096];

impl Default for HashTable {
    fn default() -> HashTable {
        HashTable::with(())
    }
}

impl HashTable {
    /// One that counts its work.
    pub fn counting() -> HashTable<Work> {
        HashTable::with(Work::default())
    }
}

impl HashTable<Work> {
    /// The work since the run began.
    pub fn work(&self) -> Work {
        self.tally
    }
}

impl<T: Tally> HashTable<T> {
    fn with(tally: T) -> HashTable<T> {
        HashTable {
            intervals: Intervals::default(),
            table: Vec::new(),
            last: FrontNode::from_rank(0),
            searched: (f64::NAN, 0),
            patience: Patience::default(),
            tally,
        }
    }
}

impl<T: Tally> FrontSearch for HashTable<T> {
    fn begin(&mut self, domain: Domain<'_>) {
        let n = domain.len();
        let count = if self.patience.has_ended() {
            self.intervals = Intervals::Places(Places::new(n));
            n
        } else {
            let count = if n < FEW { 1 } else { n.isqrt() + 1 };
            let [of_each, most] = SAMPLE;
            let most = if count > 1 {
                most.min(of_each * count)
            } else {
                0
            };
            let sample = sampled(n, most).collect();
            let (intervals, count) = Intervals::new(sample, |v| domain.x(v), count);
            self.intervals = intervals;
            self.tally = T::default();
            count
        };
        self.table.clear();
        let none = FrontNode::from_rank(n);
        self.table.resize(count, none);
        self.last = none;
        self.searched = (f64::NAN, 0);
        self.patience = Patience::with(n);
        self.tally.count(|work| {
            work.hold::<u8>(size_of_val(&self.table[..]) + self.intervals.bytes());
        });
    }

    fn strayed(&mut self, steps: usize) -> bool {
        self.patience.ends(steps)
    }

    #[inline]
    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        let tally = &mut self.tally;
        let at = self.intervals.number(x, self.table.len(), tally);
        self.searched = (x, at);
        let live = |node: FrontNode, tally: &mut T| {
            tally.count(|work| work.visited += 1);
            (node != front.left_end() && front.contains(node)).then_some(node)
        };
        if let Some(node) = live(self.table[at], tally) {
            return node;
        }
        if let Intervals::Places(places) = &mut self.intervals {
            // What has left the front is forgotten on the way.
            while let Some(place) = places.last_up_to(at, tally) {
                if let Some(node) = live(self.table[place], tally) {
                    return node;
                }
                places.remove(place, tally);
            }
            return front.left_end();
        }
        let around = (1..=REACH).flat_map(|i| [at.checked_sub(i), Some(at + i)]);
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
        // The place of a new vertex has just been searched.
        let at = match self.searched {
            (searched, at) if searched.total_cmp(&x).is_eq() => at,
            _ => self.intervals.number(x, self.table.len(), tally),
        };
        if let Intervals::Places(places) = &mut self.intervals {
            places.insert(at, tally);
        }
        self.table[at] = node;
        self.last = node;
    }
}

#[cfg(test)]
mod tests {
    use super::{Domain, Front, FrontNode, FrontSearch, HashTable, Work};

    /// Places that were asked for lead to the very node, and an entry of a node that has left is passed.
    #[test]
    fn with_places_no_step_is_left() {
        const COUNT: usize = 200;
        let equal = [[7.0, 0.0]; COUNT];
        let mut table = HashTable::default();
        table.begin(Domain::new(&equal));
        assert!(!table.strayed(4 * COUNT), "as many steps are borne");
        assert!(table.strayed(1));

        // Every other vertex is on the front, at the place of its rank.
        let places: Vec<[f64; 2]> = (0..COUNT).map(|place| [place as f64, 0.0]).collect();
        table.begin(Domain::new(&places));
        let mut front = Front::new(COUNT);
        let mut left = front.left_end();
        for node in (0..COUNT).step_by(2).map(FrontNode::from_rank) {
            front.insert(node, left);
            table.inserted(node, places[node.rank()][0]);
            left = node;
        }
        for gone in (2..COUNT).filter(|rank| rank % 6 == 2) {
            front.remove(FrontNode::from_rank(gone));
        }
        for place in 0..COUNT {
            let is_on_front = |rank: &usize| rank.is_multiple_of(2) && rank % 6 != 2;
            let last = (0..=place)
                .rev()
                .find(is_on_front)
                .map(FrontNode::from_rank);
            assert_eq!(table.locate(place as f64, &front), last.expect("0 is"));
        }

        // The next run begins with x again.
        table.begin(Domain::new(&equal));
        assert_eq!(format!("{table:?}"), {
            let mut new = HashTable::default();
            new.begin(Domain::new(&equal));
            format!("{new:?}")
        });
    }

    /// Twenty-four vertices at the left ends of the intervals 0, 1, 2 and 4 of five, four of which join the front;
    /// each entry looked at is counted.
    #[test]
    fn looks_are_counted() {
        let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [4.0, 0.0]].repeat(6);
        let mut table = HashTable::counting();
        table.begin(Domain::new(&points));
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
        // Its node has left: then the neighbour on the left is looked at.
        front.remove(nodes[1]);
        assert_eq!(table.locate(1.0, &front), nodes[0]);
        expected.visited += 2;
        assert_eq!(table.work(), expected);

        // With places the words of the set count, one for up to 64 places, and so does what was counted before.
        assert!(table.strayed(1000));
        table.begin(Domain::new(&points));
        table.inserted(nodes[2], 2.0);
        assert_eq!(table.locate(3.0, &front), nodes[2]);
        expected.updates += 1;
        // The word changed; the empty entry of the place, the word, and the entry found.
        expected.visited += 1 + 3;
        expected.bytes = entries.max(24 * size_of::<FrontNode>() as u64 + 8);
        assert_eq!(table.work(), expected);

        table.begin(Domain::new(&points));
        let begun = Work {
            bytes: entries,
            ..Work::default()
        };
        assert_eq!(table.work(), begun, "another run");
    }

    /// Twenty clusters side by side, one above the other: each slab of the sample crowds one or two of them, though all
    /// together they spread evenly.
    #[test]
    fn clusters_have_more_intervals() {
        const COUNT: u32 = 40_000;
        let bytes = |x: fn(u32) -> f64| {
            let points: Vec<[f64; 2]> = (0..COUNT).map(|i| [x(i), f64::from(i)]).collect();
            let mut table = HashTable::counting();
            table.begin(Domain::new(&points));
            table.work().bytes
        };
        let even = |i: u32| (f64::from(i) * 0.618_034).fract();
        let clustered = |i: u32| f64::from(i / 2000 * 7 % 20) + (f64::from(i) * 0.618_034).fract();
        let entries = 201 * size_of::<FrontNode>() as u64;
        assert_eq!([bytes(even), bytes(clustered)], [entries, 3 * entries]);
    }

    /// Two clusters need quantiles, whose ends are compared by halves.
    #[test]
    fn comparisons_of_quantiles_are_counted() {
        let cluster = |from: f64| (0..128).map(move |i| [from + f64::from(i) * 1e-9, 0.0]);
        let points: Vec<[f64; 2]> = cluster(0.0).chain(cluster(1.0)).collect();
        let mut table = HashTable::counting();
        table.begin(Domain::new(&points));
        table.inserted(FrontNode::from_rank(0), 0.0);
        let work = table.work();
        // Sixteen ends are between seventeen intervals.
        assert!((4..=5).contains(&work.comparisons), "{work:?}");
        assert_eq!(work.bytes, 17 * size_of::<FrontNode>() as u64 + 8 * 16);
    }
}

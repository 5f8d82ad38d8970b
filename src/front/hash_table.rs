//! The paper's structure (section 3.4.1, after Žalik 2005): a hash table over intervals of x.
//!
//! Every interval remembers the node that was inserted in it last. A search looks into the interval of x.
//! If that is empty or its node has left the front, the search looks into the intervals on either side. The
//! node found is usually near: most nodes leave the front when one beside them joins it.
//!
//! Cost: O(1) expected for a search. There are 2 sqrt(n) intervals, about as many as the front has vertices
//! where the points are spread evenly. A dense cluster in a wide domain would crowd a few of many equal
//! intervals. A sample of the points shows this beforehand; then the intervals end at quantiles of the
//! sample, and finding one takes O(log n). Where walks are long nevertheless, they are told to the table.
//! When they add up to more than a few steps a vertex, it asks for the places of all vertices from left to
//! right and searches among these ([`Places`]). So a search costs O(log n) at worst, averaged over a run.
//!
//! Differs from the paper: the table is not updated when a node leaves the front; the search notices it.
//! Intervals may be quantiles or places.

use std::iter::successors;

use super::intervals::{Intervals, Places};
use super::list::{Front, FrontNode};
use super::search::{Domain, FrontSearch, Patience};

/// Intervals of x that remember their last insertion: O(1) expected, O(log n) at worst. The default.
#[derive(Clone, Debug, Default)]
pub struct HashTable {
    intervals: Intervals,
    table: Vec<Option<FrontNode>>,
    last: Option<FrontNode>,
    patience: Patience,
    /// Whether it has asked for places, and they are not given yet.
    has_asked: bool,
}

/// How many intervals are searched on either side before the last node inserted is taken.
const REACH: usize = 16;
/// How many points a sample has for each interval, and at most.
const SAMPLE: [usize; 2] = [2, 4096];

/// So many of `n` vertices, or all if there are fewer. They are at multiples of the golden ratio, which fall into
/// no step with the rows of a lattice.
fn sampled(n: usize, size: usize) -> impl Iterator<Item = usize> {
    let fractions = successors(Some(0_u32), |at| Some(at.wrapping_add(0x9E37_79B9)));
    let spread = fractions.map(move |at| ((u64::from(at) * n as u64) >> 32) as usize);
    (0..n.min(size))
        .zip(spread)
        .map(move |(i, spread)| if n <= size { i } else { spread })
}

impl FrontSearch for HashTable {
    fn begin(&mut self, domain: Domain<'_>) {
        let n = domain.len();
        let count = if std::mem::take(&mut self.has_asked) {
            self.intervals = Intervals::Places(Places::new(n));
            n
        } else {
            let count = 2 * n.isqrt() + 1;
            let [of_each, most] = SAMPLE;
            let mut sample: Vec<f64> = sampled(n, most.min(of_each * count))
                .map(|v| domain.x(v))
                .collect();
            sample.sort_unstable_by(f64::total_cmp);
            // Only one of equal x is on the front.
            sample.dedup();
            self.intervals = Intervals::new(&sample, count);
            count
        };
        self.table.clear();
        self.table.resize(count, None);
        self.last = None;
        self.patience = Patience::with(n);
    }

    fn strayed(&mut self, steps: usize) -> bool {
        self.has_asked = self.patience.ends(steps);
        self.has_asked
    }

    #[inline]
    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        let live = |entry: &Option<FrontNode>| entry.filter(|&node| front.contains(node));
        let at = self.intervals.number(x, self.table.len());
        if let Some(node) = live(&self.table[at]) {
            return node;
        }
        if let Intervals::Places(places) = &mut self.intervals {
            // What has left the front is forgotten on the way.
            while let Some(place) = places.last_up_to(at) {
                if let Some(node) = live(&self.table[place]) {
                    return node;
                }
                places.remove(place);
            }
            return front.left_end();
        }
        let around = (1..=REACH).flat_map(|i| [at.checked_sub(i), Some(at + i)]);
        around
            .filter_map(|i| self.table.get(i?).and_then(live))
            .next()
            .or_else(|| live(&self.last))
            .unwrap_or(front.left_end())
    }

    #[inline(always)]
    fn inserted(&mut self, node: FrontNode, x: f64) {
        let at = self.intervals.number(x, self.table.len());
        if let Intervals::Places(places) = &mut self.intervals {
            places.insert(at);
        }
        self.table[at] = Some(node);
        self.last = Some(node);
    }
}

#[cfg(test)]
mod tests {
    use super::{Domain, Front, FrontNode, FrontSearch, HashTable};

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
}

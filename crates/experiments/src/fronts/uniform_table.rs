//! The paper's structure (section 3.4.1): the front's list "combined with a hash table", here with equal
//! intervals of x.
//!
//! The paper does not say what an entry holds. Here it holds all nodes of its interval, so that a search
//! ends at the right one: it looks through the interval of x, and then through those to the left of it
//! until one has a node.
//!
//! Why it is right: an interval to the left holds smaller x only.
//!
//! Cost: O(1) expected for a search where x spreads evenly and there are about as many intervals as nodes
//! on the front; O(n) where all nodes crowd in one interval, or nearly all intervals are empty. A node that leaves is
//! looked for in its interval, O(n) where all crowd in one. The sweep takes no step.

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch, Work};

use super::parts::EqualIntervals;
use super::structure::Structure;

/// A hash table with equal intervals of x: O(1) expected, O(n) at worst. How many is a parameter.
#[derive(Clone, Debug)]
pub struct UniformTable {
    entries: fn(vertices: usize) -> usize,
    intervals: EqualIntervals,
    table: Vec<Vec<(f64, FrontNode)>>,
    nodes: usize,
    work: Work,
}

impl UniformTable {
    /// The table with so many entries for so many vertices; with one at least.
    pub fn new(entries: fn(vertices: usize) -> usize) -> UniformTable {
        UniformTable {
            entries,
            intervals: EqualIntervals::default(),
            table: Vec::new(),
            nodes: 0,
            work: Work::default(),
        }
    }
}

impl FrontSearch for UniformTable {
    fn begin(&mut self, input: FrontInput<'_>) {
        let count = (self.entries)(input.len()).max(1);
        *self = UniformTable::new(self.entries);
        self.intervals = EqualIntervals::new(input, count);
        self.table.resize(count, Vec::new());
        self.work.hold::<Vec<(f64, FrontNode)>>(count);
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        for interval in (0..=self.intervals.number(x)).rev() {
            self.work.visited += 1;
            let mut last: Option<(f64, FrontNode)> = None;
            for &entry in &self.table[interval] {
                self.work.comparisons += 1;
                if entry.0 <= x && last.is_none_or(|last| last.0 <= entry.0) {
                    last = Some(entry);
                }
            }
            if let Some((_, node)) = last {
                return node;
            }
        }
        front.left_end()
    }

    fn inserted(&mut self, node: FrontNode, x: f64) {
        let interval = self.intervals.number(x);
        self.table[interval].push((x, node));
        self.nodes += 1;
        self.work.updates += 1;
        let table = self.table.len() * size_of::<Vec<(f64, FrontNode)>>();
        let nodes = self.nodes * size_of::<(f64, FrontNode)>();
        self.work.hold::<u8>(table + nodes);
    }

    fn removed(&mut self, node: FrontNode, x: f64) {
        let interval = self.intervals.number(x);
        let nodes = &mut self.table[interval];
        let place = nodes.iter().position(|entry| entry.1 == node);
        let place = place.expect("the node is in the interval of its x");
        self.work.visited += place as u64 + 1;
        nodes.swap_remove(place);
        self.nodes -= 1;
        self.work.updates += 1;
    }
}

impl Structure for UniformTable {
    fn work(&self) -> Option<Work> {
        Some(self.work)
    }
}

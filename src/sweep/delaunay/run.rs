//! Runs: stretches of a chain whose corners are inserted in random order, each between the two that are its neighbours
//! at that moment.
//!
//! To find these, all corners are first taken out of the run in reverse order, and each keeps the two neighbours that it
//! has then (Chew 1990). A long convex run is inserted in rounds, each as large as all before it and from left to right
//! (Amenta, Choi and Rote 2003): a round has random corners, but visits memory in order.
//!
//! The numbers are the same in every run of the program. So *random* and *expected* speak of the order in which the
//! input happens to meet them, and the result depends on no order at all (the canonical rule).
//!
//! Cost: O(k) for k corners, but a sort of each long round.

use alloc::vec::Vec;

use super::fan::Fan;
use crate::ids::{BorderId, narrow};
use crate::tuning::{IN_ONE_ROUND, MOST_DRAWS};

/// Marsaglia's xorshift: the same numbers in every run and on every machine.
#[derive(Debug)]
pub(in crate::sweep) struct Random(u32);

impl Random {
    pub(in crate::sweep) fn new() -> Random {
        Random(0x2545_F491)
    }

    /// A number below `n`.
    pub(in crate::sweep) fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0 as usize % n
    }

    pub(in crate::sweep) fn shuffle<T>(&mut self, list: &mut [T]) {
        for i in (1..list.len()).rev() {
            list.swap(i, self.below(i + 1));
        }
    }
}

/// A run. A position is an index into the run.
#[derive(Debug, Default)]
pub(in crate::sweep) struct Run {
    /// The inner positions in order of insertion.
    pub(super) order: Vec<u32>,
    /// For each position its neighbours among the positions inserted before it.
    prev: Vec<u32>,
    next: Vec<u32>,
    /// The border half-edge from each position inserted to its next one.
    pub(super) borders: Vec<BorderId>,
    /// Buffers of [`super::fan`].
    pub(super) fan: Fan,
}

impl Run {
    /// Draws an order for a convex run of `corners` corners; it depends on their number alone.
    pub(super) fn draw(&mut self, corners: usize) {
        self.begin(corners);
        Random::new().shuffle(&mut self.order);
        // The last half from left to right, then the half before, and so on.
        let mut end = self.order.len();
        while end > IN_ONE_ROUND {
            self.order[end / 2..end].sort_unstable();
            end /= 2;
        }
        for k in (0..self.order.len()).rev() {
            self.take_out(self.order[k]);
        }
    }

    /// Draws an order in which each position is one of those that `may_go` from between its neighbours of the moment.
    /// Returns whether there is one.
    pub(super) fn draw_those(
        &mut self,
        corners: usize,
        mut may_go: impl FnMut(u32, [u32; 2]) -> bool,
    ) -> bool {
        self.begin(corners);
        let mut random = Random::new();
        random.shuffle(&mut self.order);
        // The first corner inserted is the last one taken out, and lies between the ends.
        for last in (1..self.order.len()).rev() {
            let mut draws = 0;
            while !may_go(self.order[last], self.neighbors(self.order[last])) {
                if draws == MOST_DRAWS {
                    return false;
                }
                draws += 1;
                self.order.swap(last, random.below(last));
            }
            self.take_out(self.order[last]);
        }
        true
    }

    /// Begins with all positions, of which all but the ends are to be inserted, from left to right.
    fn begin(&mut self, corners: usize) {
        let len = narrow(corners);
        self.order.clear();
        self.order.extend(1..len - 1);
        self.prev.clear();
        self.prev.extend((0..len).map(|i| i.saturating_sub(1)));
        self.next.clear();
        self.next.extend(1..=len);
        self.borders.clear();
        self.borders.resize(corners, BorderId::new(0));
    }

    /// Makes the neighbours of a position each other's. The position keeps them.
    fn take_out(&mut self, u: u32) {
        let [v, w] = self.neighbors(u);
        self.next[v as usize] = w;
        self.prev[w as usize] = v;
    }

    /// The neighbours of position `u` when it is inserted.
    pub(super) fn neighbors(&self, u: u32) -> [u32; 2] {
        [self.prev[u as usize], self.next[u as usize]]
    }
}

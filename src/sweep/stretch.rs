//! A convex run of a chain while it is closed: the random order in which its corners are inserted (Chew
//! 1990).
//!
//! Which triangle does a corner make when it is inserted? To find out, the corners are first taken out of
//! the polygon in reverse order, and each one keeps its two neighbours among those left. Inserted in
//! order, each corner makes a triangle with these two.
//!
//! A long stretch is inserted in rounds, each as large as all before it and from left to right (Amenta, Choi
//! and Rote 2003): what is chosen in a round is random, and corners near each other in memory follow each
//! other.
//!
//! Cost: O(k) for k corners; the sorts of long rounds are a small part of the time.

use crate::ids::{BorderId, narrow};

/// So few corners are near each other in any order.
const FEW: usize = 4096;

/// Marsaglia's xorshift: the same numbers in every run and on every machine.
#[derive(Debug)]
pub(super) struct Random(u32);

impl Random {
    pub(super) fn new() -> Random {
        Random(0x2545_F491)
    }

    /// A number below `n`.
    pub(super) fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0 as usize % n
    }

    /// Puts a list into random order.
    pub(super) fn shuffle<T>(&mut self, list: &mut [T]) {
        for i in (1..list.len()).rev() {
            list.swap(i, self.below(i + 1));
        }
    }
}

/// Positions are those in the stretch.
#[derive(Debug, Default)]
pub(super) struct ConvexRun {
    /// The inner positions in order of insertion.
    pub(super) order: Vec<u32>,
    /// For each position its neighbours among those inserted before it.
    prev: Vec<u32>,
    next: Vec<u32>,
    /// The border half-edge from each position inserted to its next one.
    pub(super) borders: Vec<BorderId>,
}

impl ConvexRun {
    /// Draws a random order of insertion for the inner ones of so many positions; it depends on their number
    /// alone.
    pub(super) fn draw(&mut self, corners: usize) {
        let len = narrow(corners);
        self.order.clear();
        self.order.extend(1..len - 1);
        Random::new().shuffle(&mut self.order);
        // The last half of them from left to right, then the half before, and so on.
        let mut end = self.order.len();
        while end > FEW {
            self.order[end / 2..end].sort_unstable();
            end /= 2;
        }
        self.prev.clear();
        self.prev.extend((0..len).map(|i| i.saturating_sub(1)));
        self.next.clear();
        self.next.extend(1..=len);
        // Taken out in reverse order, each corner keeps the neighbours that it had last.
        for &u in self.order.iter().rev() {
            let [v, w] = [self.prev[u as usize], self.next[u as usize]];
            self.next[v as usize] = w;
            self.prev[w as usize] = v;
        }
        self.borders.clear();
        self.borders.resize(len as usize, BorderId::new(0));
    }

    /// The neighbours of position `u` when it is inserted.
    pub(super) fn neighbors(&self, u: u32) -> [u32; 2] {
        [self.prev[u as usize], self.next[u as usize]]
    }
}

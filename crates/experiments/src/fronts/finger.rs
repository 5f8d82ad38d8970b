//! A finger: exponential steps from the last place (Bentley and Yao 1976), in a sorted array.
//!
//! The search looks 1, 2, 4, 8, ... entries away from where the last one ended, until it has passed its
//! place, and then halves the last step.
//!
//! Why it is right: as the sorted array ([`super::sorted_array`]); only the order of the probes differs.
//!
//! Cost: O(log d) comparisons for a place at distance d from the last one; an update moves all entries
//! behind its place.

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch, Work};

use super::structure::Structure;

/// A sorted array searched from the last place: O(log d) at distance d, O(n) for an update.
#[derive(Clone, Debug, Default)]
pub struct Finger {
    entries: Vec<(f64, FrontNode)>,
    /// Where the last search or update was.
    last: usize,
    work: Work,
}

impl Finger {
    /// The place of the first entry that is not before, which all entries up to there are.
    fn place(&mut self, is_before: impl Fn(&(f64, FrontNode)) -> bool) -> usize {
        let Finger {
            entries,
            last,
            work,
        } = self;
        let mut test = |place: usize| {
            work.comparisons += 1;
            entries.get(place).map(&is_before)
        };
        // All entries up to `low` are before, that at `high` is not.
        let (mut low, mut high) = (0, entries.len());
        let mut step = 1;
        if test(*last) == Some(true) {
            low = *last + 1;
            while let Some(is_before) = test(*last + step) {
                if !is_before {
                    high = *last + step;
                    break;
                }
                low = *last + step + 1;
                step *= 2;
            }
        } else {
            high = high.min(*last);
            while let Some(place) = last.checked_sub(step) {
                if test(place) == Some(true) {
                    low = place + 1;
                    break;
                }
                high = high.min(place);
                step *= 2;
            }
        }
        while low < high {
            let middle = low.midpoint(high);
            if test(middle) == Some(true) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        *last = low;
        low
    }

    /// Counts an update at a place.
    fn count(&mut self, place: usize) {
        self.work.updates += 1;
        self.work.rearranged += (self.entries.len() - place) as u64;
        self.work.hold::<(f64, FrontNode)>(self.entries.len());
    }
}

impl FrontSearch for Finger {
    fn begin(&mut self, _: FrontInput<'_>) {
        *self = Finger::default();
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        let place = self.place(|entry| entry.0 <= x);
        let last = place.checked_sub(1);
        last.map_or(front.left_end(), |last| self.entries[last].1)
    }

    fn inserted(&mut self, node: FrontNode, x: f64) {
        let place = self.place(|entry| *entry < (x, node));
        self.entries.insert(place, (x, node));
        self.count(place);
    }

    fn removed(&mut self, node: FrontNode, x: f64) {
        let place = self.place(|entry| *entry < (x, node));
        self.entries.remove(place);
        self.count(place);
    }
}

impl Structure for Finger {
    fn work(&self) -> Option<Work> {
        let comparisons = self.work.comparisons;
        Some(Work {
            visited: comparisons,
            ..self.work
        })
    }
}

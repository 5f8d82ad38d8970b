//! A sorted array with binary search.
//!
//! Why it is right: the nodes stand in order of x, equal ones in order of their ranks; the last one whose x
//! is at most that of the search is before the first one of which that is not true.
//!
//! Cost: O(log n) comparisons for a search. An update moves all entries behind its place: O(n), but 16 bytes
//! each and in one piece.

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch, Work};

use super::structure::Structure;

/// A sorted array with binary search: O(log n) for a search, O(n) for an update.
#[derive(Clone, Debug, Default)]
pub struct SortedArray {
    entries: Vec<(f64, FrontNode)>,
    work: Work,
}

impl SortedArray {
    /// The place of the first entry that is not before, which all entries up to there are.
    fn place(&mut self, is_before: impl Fn(&(f64, FrontNode)) -> bool) -> usize {
        let comparisons = &mut self.work.comparisons;
        self.entries.partition_point(|entry| {
            *comparisons += 1;
            is_before(entry)
        })
    }

    /// Counts an update at a place.
    fn count(&mut self, place: usize) {
        self.work.updates += 1;
        self.work.rearranged += (self.entries.len() - place) as u64;
        self.work.hold::<(f64, FrontNode)>(self.entries.len());
    }
}

impl FrontSearch for SortedArray {
    fn begin(&mut self, _: FrontInput<'_>) {
        self.entries.clear();
        self.work = Work::default();
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

impl Structure for SortedArray {
    fn work(&self) -> Option<Work> {
        let comparisons = self.work.comparisons;
        Some(Work {
            visited: comparisons,
            ..self.work
        })
    }
}

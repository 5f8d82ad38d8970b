//! A sorted array, searched by halves or with fingers: exponential steps from the last place (Bentley and Yao 1976,
//! doi:10.1016/0020-0190(76)90071-5).
//!
//! With a finger the search looks 1, 2, 4, 8, ... entries away from where the last one ended, until it has passed its
//! place, and then halves the last step. With two fingers it starts from the nearer one, as a look at the middle between
//! them tells, and that one moves. So where searches go from side to side, a finger stays at the last place on either
//! side.
//!
//! Why it is right: the nodes stand in order of x, equal ones in order of their ranks; the last one whose x is at most
//! that of the search is before the first one of which that is not true. The searches differ in their probes alone.
//!
//! Cost: O(log n) comparisons for a search by halves; O(log d) with a finger for a place at distance d from it, so
//! O(log n) at worst. An update moves all entries behind its place: O(n), but 16 bytes each and in one piece. The sweep
//! takes no step.

use std::fmt::Debug;

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch, Work};

use super::structure::Structure;

/// A sorted array with binary search: O(log n) for a search, O(n) for an update.
pub type SortedArray = Sorted<Halves>;

/// A sorted array searched from the last place: O(log d) at distance d, O(n) for an update.
pub type Finger = Sorted<FromLast>;

/// A sorted array searched from the nearer of the last places on either side: as with one finger.
pub type TwoFingers = Sorted<FromEither>;

/// A sorted array with a way to search it.
#[derive(Clone, Debug, Default)]
pub struct Sorted<Search> {
    entries: Vec<Entry>,
    search: Search,
    work: Work,
}

/// A node with its x.
type Entry = (f64, FrontNode);

/// A way to find a place in the sorted list.
pub trait Search: Clone + Debug + Default + Send + 'static {
    /// The place of the first entry of which `is_before` is false. It is true of all entries up to there.
    fn place(&mut self, entries: &[Entry], is_before: impl FnMut(&Entry) -> bool) -> usize;
}

/// Binary search.
#[derive(Clone, Debug, Default)]
pub struct Halves;

/// Exponential search from where the last search or update was.
#[derive(Clone, Debug, Default)]
pub struct FromLast(usize);

impl Search for Halves {
    fn place(&mut self, entries: &[Entry], is_before: impl FnMut(&Entry) -> bool) -> usize {
        entries.partition_point(is_before)
    }
}

/// Exponential search from the nearer of two places.
#[derive(Clone, Debug, Default)]
pub struct FromEither([usize; 2]);

impl Search for FromLast {
    fn place(&mut self, entries: &[Entry], is_before: impl FnMut(&Entry) -> bool) -> usize {
        self.0 = gallop(self.0, entries, is_before);
        self.0
    }
}

impl Search for FromEither {
    fn place(&mut self, entries: &[Entry], mut is_before: impl FnMut(&Entry) -> bool) -> usize {
        // What is before the middle of the two is nearer to the left one.
        let middle = entries.get(self.0[0].midpoint(self.0[1]));
        let side = usize::from(middle.is_some_and(&mut is_before));
        self.0[side] = gallop(self.0[side], entries, is_before);
        self.0[side]
    }
}

/// The place of the first entry of which `is_before` is false, by exponential steps from another place.
fn gallop(last: usize, entries: &[Entry], mut is_before: impl FnMut(&Entry) -> bool) -> usize {
    let mut test = |place: usize| entries.get(place).map(&mut is_before);
    // All entries up to `low` are before, that at `high` is not.
    let (mut low, mut high) = (0, entries.len());
    let mut step = 1;
    if test(last) == Some(true) {
        low = last + 1;
        while let Some(is_before) = test(last + step) {
            if !is_before {
                high = last + step;
                break;
            }
            low = last + step + 1;
            step *= 2;
        }
    } else {
        high = high.min(last);
        while let Some(place) = last.checked_sub(step) {
            if test(place) == Some(true) {
                low = place + 1;
                break;
            }
            high = high.min(place);
            step *= 2;
        }
    }
    low + entries[low..high].partition_point(is_before)
}

impl<P: Search> Sorted<P> {
    /// The place of the first entry that is not before, which all entries up to there are.
    fn place(&mut self, is_before: impl Fn(&Entry) -> bool) -> usize {
        let comparisons = &mut self.work.comparisons;
        self.search.place(&self.entries, |entry| {
            *comparisons += 1;
            is_before(entry)
        })
    }

    /// Counts an update at a place.
    fn count(&mut self, place: usize) {
        self.work.updates += 1;
        self.work.rearranged += (self.entries.len() - place) as u64;
        self.work.hold::<Entry>(self.entries.len());
    }
}

impl<P: Search> FrontSearch for Sorted<P> {
    fn begin(&mut self, _: FrontInput<'_>) {
        *self = Sorted::default();
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

impl<P: Search> Structure for Sorted<P> {
    fn work(&self) -> Option<Work> {
        let comparisons = self.work.comparisons;
        Some(Work {
            visited: comparisons,
            ..self.work
        })
    }
}

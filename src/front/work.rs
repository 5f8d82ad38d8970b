//! The work inside a search structure, which the sweep does not see: it sees the steps along the front that follow a
//! search. Structures to compare count their work in a [`Work`]. Cost: an addition for each count, or nothing:
//! the structures of the crate are compiled without counts unless asked for.

/// The work of a search structure in a run, without the steps along the front that the sweep takes afterwards.
///
/// ```
/// use sweep_cdt::front::SkipList;
/// use sweep_cdt::{Triangulator, Watch};
///
/// let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0]];
/// let mut front = SkipList::counting();
/// Triangulator::new().run(&points, &[], Watch::new().front(&mut front))?;
/// let work = front.work();
/// // Each vertex joins the list. The place of the second one is compared with the first, and so on.
/// assert!(work.updates >= 3 && work.comparisons >= 3);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Comparisons of numbers: x or ranks.
    pub comparisons: u64,
    /// Nodes, entries or words looked at.
    pub visited: u64,
    /// Nodes put into the structure or taken out.
    pub updates: u64,
    /// Entries moved and links changed, by insertion and removal, rotations, splits and joins.
    pub rearranged: u64,
    /// The most bytes of entries and tables held at one time.
    pub bytes: u64,
}

impl Work {
    /// Raises [`bytes`](Work::bytes) to the size of so many entries of type `T`, if that is more: to be called whenever
    /// the structure has grown. Structures of your own may keep a `Work` too.
    pub fn hold<T>(&mut self, entries: usize) {
        self.bytes = self.bytes.max((entries * size_of::<T>()) as u64);
    }
}

/// Where a search structure of the crate counts, if `COUNTS`.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tally<const COUNTS: bool>(pub(super) Work);

impl<const COUNTS: bool> Tally<COUNTS> {
    #[inline(always)]
    pub(super) fn count(&mut self, add: impl FnOnce(&mut Work)) {
        if COUNTS {
            add(&mut self.0);
        }
    }
}

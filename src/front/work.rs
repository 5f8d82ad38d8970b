//! The work inside a search structure, which the sweep does not see: it sees the steps along the front that follow a
//! search. Structures to compare count their work in a [`Work`]. Cost: an addition for each count, or nothing:
//! structures generic over [`Tally`], like those of the crate, are compiled without counts unless asked for.

use core::fmt;

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

/// Where a search structure counts: [`Work`] keeps the counts, `()` keeps none and compiles to nothing.
pub trait Tally: Copy + Default + fmt::Debug + 'static {
    /// Adds to the counts.
    fn count(&mut self, add: impl FnOnce(&mut Work));
}

impl Tally for () {
    #[inline(always)]
    fn count(&mut self, _: impl FnOnce(&mut Work)) {}
}

impl Tally for Work {
    fn count(&mut self, add: impl FnOnce(&mut Work)) {
        add(self);
    }
}

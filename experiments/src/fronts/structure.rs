//! What the experiments ask of a search structure beyond [`FrontSearch`]: the work it has done.

use sweep_cdt::front::{FrontSearch, HashTable, Linear, SkipList};

/// What a structure did in a run, as it counts it itself. The steps along the front that the sweep takes
/// afterwards are not in it.
///
/// The numbers are counted while time is measured: each is an addition to a field.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Comparisons of numbers: x, ranks or places.
    pub comparisons: u64,
    /// Nodes, entries or words looked at.
    pub visited: u64,
    /// Nodes put into the structure or taken out.
    pub updates: u64,
    /// Entries moved, and links changed by rotations, splits and joins.
    pub rearranged: u64,
    /// Bytes of the entries and tables held at one time, at most.
    pub bytes: u64,
}

impl Work {
    /// Notes that this many entries of this type are held.
    pub fn hold<T>(&mut self, entries: usize) {
        self.bytes = self.bytes.max((entries * size_of::<T>()) as u64);
    }
}

/// A search structure for the front that can be compared with the others.
///
/// A structure of your own needs [`FrontSearch`] and an empty implementation of this trait:
/// `examples/own_structure.rs`.
pub trait Structure: FrontSearch + Clone + 'static {
    /// The work since the run began, if it is counted.
    fn work(&self) -> Option<Work> {
        None
    }
}

impl Structure for HashTable {}
impl Structure for SkipList {}

impl Structure for Linear {
    fn work(&self) -> Option<Work> {
        // It looks at nothing but the node that it names.
        Some(Work::default())
    }
}

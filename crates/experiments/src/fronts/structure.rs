//! The experiments ask more of a search structure than [`FrontSearch`]: the work it has done.
//!
//! The simplest structure, the walk from the left end, is here too, and one that holds another one and forgets
//! its type.

use std::fmt;

use sweep_cdt::front::{
    Front, FrontInput, FrontNode, FrontSearch, HashTable, Linear, SkipList, Work,
};

/// A search structure for the front that can be compared with the others.
///
/// A structure of your own needs [`FrontSearch`] and an empty implementation of this trait:
/// `examples/own_structure.rs`.
pub trait Structure: FrontSearch + Clone + 'static {
    /// The work since the run began, if it is counted. It is counted while time is measured, too: that is an
    /// addition to a field.
    fn work(&self) -> Option<Work> {
        None
    }
}

impl Structure for HashTable {}
impl Structure for SkipList {}

impl Structure for HashTable<true> {
    fn work(&self) -> Option<Work> {
        Some(HashTable::work(self))
    }
}

impl Structure for SkipList<true> {
    fn work(&self) -> Option<Work> {
        Some(SkipList::work(self))
    }
}

impl Structure for Linear {
    fn work(&self) -> Option<Work> {
        // It looks at nothing but the node that it names.
        Some(Work::default())
    }
}

/// The walk from the left end: no structure at all, and no memory of the last place either.
///
/// Cost: O(1) for a search and nothing for an update; the sweep walks over the whole front, O(n), and half of it on
/// average.
#[derive(Clone, Copy, Debug, Default)]
pub struct FromEnd;

impl FrontSearch for FromEnd {
    fn begin(&mut self, _: FrontInput<'_>) {}

    fn locate(&mut self, _: f64, front: &Front) -> FrontNode {
        front.left_end()
    }
}

impl Structure for FromEnd {
    fn work(&self) -> Option<Work> {
        Some(Work::default())
    }
}

/// Any [`Structure`]: its type is chosen when the program runs.
///
/// With it one compiled sweep serves all structures where time does not matter: to count, and in tests.
pub struct AnyFront(Box<dyn Object>);

impl AnyFront {
    /// The structure with its type forgotten.
    pub fn new(structure: impl Structure) -> AnyFront {
        AnyFront(Box::new(structure))
    }
}

impl Clone for AnyFront {
    fn clone(&self) -> AnyFront {
        AnyFront(self.0.copy())
    }
}

impl fmt::Debug for AnyFront {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("AnyFront").field(&self.0.work()).finish()
    }
}

impl FrontSearch for AnyFront {
    fn begin(&mut self, input: FrontInput<'_>) {
        self.0.front().begin(input);
    }

    fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        self.0.front().locate(x, front)
    }

    fn inserted(&mut self, node: FrontNode, x: f64) {
        self.0.front().inserted(node, x);
    }

    fn removed(&mut self, node: FrontNode, x: f64) {
        self.0.front().removed(node, x);
    }
}

impl Structure for AnyFront {
    fn work(&self) -> Option<Work> {
        self.0.work()
    }
}

/// A structure whose type is forgotten.
trait Object {
    fn front(&mut self) -> &mut dyn FrontSearch;
    fn work(&self) -> Option<Work>;
    fn copy(&self) -> Box<dyn Object>;
}

impl<S: Structure> Object for S {
    fn front(&mut self) -> &mut dyn FrontSearch {
        self
    }

    fn work(&self) -> Option<Work> {
        Structure::work(self)
    }

    fn copy(&self) -> Box<dyn Object> {
        Box::new(self.clone())
    }
}

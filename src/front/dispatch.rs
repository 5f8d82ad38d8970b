//! How the sweep calls its search structure: the caller's through `dyn`, the default hash table directly. The table is
//! moved into the sweep for a run, so that its searches are inlined and no pointer to it must be followed. Cost: a branch
//! for each call, and an indirect call for a structure of the caller.

use core::fmt;

use super::hash_table::HashTable;
use super::list::{Front, FrontNode};
use super::search::{FrontInput, FrontSearch};

/// The search structure of one run.
pub(crate) enum Search<'a> {
    Default(HashTable),
    Given(&'a mut dyn FrontSearch),
}

impl<'a> Search<'a> {
    /// The structure that the caller gives, or else this table.
    pub(crate) fn with(given: Option<&'a mut dyn FrontSearch>, table: HashTable) -> Search<'a> {
        given.map_or(Search::Default(table), Search::Given)
    }

    /// The memory of the table, for another run.
    pub(crate) fn into_table(self) -> HashTable {
        match self {
            Search::Default(table) => table,
            Search::Given(_) => HashTable::default(),
        }
    }

    pub(crate) fn begin(&mut self, input: FrontInput<'_>) {
        match self {
            Search::Default(table) => table.begin(input),
            Search::Given(structure) => structure.begin(input),
        }
    }

    #[inline(always)]
    pub(crate) fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        match self {
            Search::Default(table) => table.locate(x, front),
            Search::Given(structure) => structure.locate(x, front),
        }
    }

    #[inline(always)]
    pub(crate) fn inserted(&mut self, node: FrontNode, x: f64) {
        match self {
            Search::Default(table) => table.inserted(node, x),
            Search::Given(structure) => structure.inserted(node, x),
        }
    }

    #[inline(always)]
    pub(crate) fn removed(&mut self, node: FrontNode, x: impl FnOnce() -> f64) {
        if let Search::Given(structure) = self {
            structure.removed(node, x());
        }
    }
}

impl fmt::Debug for Search<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Search::Default(table) => f.debug_tuple("Default").field(table).finish(),
            Search::Given(_) => f.debug_tuple("Given").finish_non_exhaustive(),
        }
    }
}

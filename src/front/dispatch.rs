//! How the sweep calls its search structure, whose type it does not know: through `dyn`. Only the default hash table is
//! called directly, and is moved into the sweep for a run, so that its searches are inlined and no pointer to it must be
//! followed. Cost: a branch for each call, and an indirect call for every structure but the default hash table.

use core::fmt;
use core::mem::{swap, take};

use super::hash_table::HashTable;
use super::list::{Front, FrontNode};
use super::search::{FrontInput, FrontSearch};

/// The search structure of one run, which the caller holds.
pub(crate) enum Search<'a> {
    HashTable(HashTable, &'a mut HashTable),
    Other(&'a mut dyn FrontSearch),
}

impl<'a> Search<'a> {
    /// Uses this structure, which may turn out to be the default hash table.
    pub(crate) fn with(structure: &'a mut dyn FrontSearch) -> Search<'a> {
        let is_default = structure
            .as_any()
            .is_some_and(|structure| structure.is::<HashTable>());
        if !is_default {
            return Search::Other(structure);
        }
        let table = structure.as_any().and_then(|any| any.downcast_mut());
        let home: &mut HashTable = table.expect("it has just been one");
        Search::HashTable(take(home), home)
    }

    pub(crate) fn begin(&mut self, input: FrontInput<'_>) {
        match self {
            Search::HashTable(table, _) => table.begin(input),
            Search::Other(structure) => structure.begin(input),
        }
    }

    #[inline(always)]
    pub(crate) fn locate(&mut self, x: f64, front: &Front) -> FrontNode {
        match self {
            Search::HashTable(table, _) => table.locate(x, front),
            Search::Other(structure) => structure.locate(x, front),
        }
    }

    pub(crate) fn wants_ranks(&mut self, steps: usize) -> bool {
        match self {
            Search::HashTable(table, _) => table.wants_ranks(steps),
            Search::Other(structure) => structure.wants_ranks(steps),
        }
    }

    #[inline(always)]
    pub(crate) fn inserted(&mut self, node: FrontNode, x: f64) {
        match self {
            Search::HashTable(table, _) => table.inserted(node, x),
            Search::Other(structure) => structure.inserted(node, x),
        }
    }

    #[inline(always)]
    pub(crate) fn removed(&mut self, node: FrontNode, x: impl FnOnce() -> f64) {
        if let Search::Other(structure) = self {
            structure.removed(node, x());
        }
    }
}

impl Drop for Search<'_> {
    /// The hash table goes back.
    fn drop(&mut self) {
        if let Search::HashTable(table, home) = self {
            swap(table, home);
        }
    }
}

impl fmt::Debug for Search<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Search::HashTable(table, _) => f.debug_tuple("HashTable").field(table).finish(),
            Search::Other(_) => f.debug_tuple("Other").finish_non_exhaustive(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{FrontSearch, HashTable, Search};
    use crate::front::{AnyFront, Linear, SkipList};

    /// The speed of the default call needs the direct calls, of the hash table alone and in an [`AnyFront`].
    #[test]
    fn only_the_default_is_called_directly() {
        let is_direct = |structure: &mut dyn FrontSearch| {
            matches!(Search::with(structure), Search::HashTable(..))
        };
        assert!(is_direct(&mut HashTable::default()));
        assert!(!is_direct(&mut HashTable::counting()));
        assert!(!is_direct(&mut SkipList::default()));
        assert!(!is_direct(&mut Linear::default()));
        assert_eq!(
            AnyFront::all().each_mut().map(|front| is_direct(front)),
            [true, false, false]
        );
    }
}

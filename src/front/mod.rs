//! The advancing front (sections 3.1 and 3.4.1): a list of vertices from P-1 to P-2, doubly linked, and its searches.
//!
//! A search structure ([`FrontSearch`]) names *some* vertex of the front, good or bad. The sweep walks on from there by
//! exact comparisons until it stands on the segment under the new point. So a structure cannot make a result wrong,
//! only slow, and all structures give the same trace.
//!
//! | structure | finds a place in | good for |
//! |---|---|---|
//! | [`HashTable`] | O(1) expected, O(log n) at worst | everything measured; the default |
//! | [`SkipList`] | O(log n) expected | comparison |
//! | [`Linear`] | O(n) | points that come next to the one before |
//!
//! A structure knows x as a double, which may tell too little: crowded, equal or infinite. If its answers lead to long
//! walks, it may ask for *x-ranks* instead: the numbers of the vertices from left to right, by exact comparison
//! ([`FrontSearch::wants_ranks`]). [`HashTable`] and [`SkipList`] do; their costs above are averages over a run.
//!
//! [`AnyFront`] is one of the three, chosen by name at run time. `HashTable::counting` and `SkipList::counting` count
//! their work ([`Work`]). To test a structure without a sweep, make a [`Front`] and a [`FrontInput`] by hand.
//!
//! Differs from the paper: the paper has the hash table only; the others are for comparison.

mod any;
mod dispatch;
mod hash_table;
mod intervals;
mod linear;
mod list;
mod search;
mod skip_list;
mod work;
mod x_rank_set;

pub use any::AnyFront;
pub(crate) use dispatch::Search;
pub use hash_table::HashTable;
pub use linear::Linear;
pub(crate) use list::Direction;
pub use list::{Front, FrontNode};
pub use search::{FrontInput, FrontSearch, LONG_WALK};
pub use skip_list::SkipList;
pub use work::{Tally, Work};

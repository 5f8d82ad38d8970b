//! The advancing front (sections 3.1 and 3.4.1): a list of vertices from P-1 to P-2, doubly linked, and its searches.
//!
//! A search structure ([`FrontSearch`]) names *some* vertex of the front, good or bad. The sweep walks on from there by
//! exact comparisons until it stands on the segment under the new point. So a structure cannot make a result wrong,
//! only slow, and all structures give the same trace.
//!
//! | structure | finds a place in | good for |
//! |---|---|---|
//! | [`HashTable`] | O(1) expected | everything measured; the default |
//! | [`SkipList`] | O(log n) expected | comparison |
//! | [`Linear`] | O(n) | points that come next to the one before |
//!
//! A structure knows x as a double, which may tell too little: crowded, equal or infinite. Then walks are long. They spend
//! the budget that flips spend, too, and divide and conquer takes over where it ends ([`crate::Algorithm::Auto`]).
//!
//! `HashTable::counting` and `SkipList::counting` count their work ([`Work`]). To test a structure without a sweep, make
//! a [`Front`] and a [`FrontInput`] by hand.
//!
//! Differs from the paper: the paper has the hash table only; the others are for comparison.

mod dispatch;
mod hash_table;
mod intervals;
mod linear;
mod list;
mod search;
mod skip_list;
mod work;

pub(crate) use dispatch::Search;
pub use hash_table::HashTable;
pub use linear::Linear;
pub(crate) use list::Direction;
pub use list::{Front, FrontNode};
pub use search::{FrontInput, FrontSearch};
pub use skip_list::SkipList;
pub use work::Work;

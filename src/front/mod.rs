//! The advancing front (sections 3.1 and 3.4.1): a doubly linked list of vertices from P-1 to P-2, and
//! the search structures that find a place in it.
//!
//! A search structure ([`FrontSearch`]) names *some* vertex of the front, good or bad. The sweep walks
//! on from there by exact comparisons until it stands on the segment under the new point. So a
//! structure cannot make a result wrong, only slow, and all structures give the same trace.
//!
//! | structure | finds a place in | good for |
//! |---|---|---|
//! | [`HashTable`] | O(1) expected, O(log n) at worst | everything measured; the default |
//! | [`SkipList`] | O(log n) expected | comparison |
//! | [`Linear`] | O(n) | showing what a structure must do |
//!
//! Structures know x as a double, which may tell too little: crowded, equal or infinite. One whose answers
//! lead to long walks may ask for *x-ranks* instead: the numbers of the vertices from left to right, by exact
//! comparison ([`FrontSearch::wants_ranks`]). The first two do; the costs above are averages over a run.
//!
//! [`AnyFront`] is one of the three, chosen by name when the program runs.
//!
//! `HashTable::counting` and `SkipList::counting` are the same structures with counts of their work ([`Work`]).
//!
//! A structure can be tested without a sweep: [`Front`], [`FrontNode`] and [`FrontInput`] can be made and
//! changed by hand.
//!
//! Differs from the paper: the paper's structure is the hash table; the others are for comparison.

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

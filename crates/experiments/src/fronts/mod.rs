//! Search structures for the advancing front (section 3.4.1); a file of one may be copied as a start.
//!
//! | structure | a search costs | file |
//! |---|---|---|
//! | [`UniformTable`] | O(1) expected where x spreads evenly, O(n) at worst | the paper's, with equal intervals |
//! | [`FromEnd`] | O(n) | the walk from the left end |
//! | [`SortedArray`] | O(log n); an update O(n) | binary search |
//! | [`Finger`] | O(log d) at distance d from the last place; an update O(n) | exponential steps |
//! | [`BTree`] | O(log n) | the standard library's B-tree |
//! | [`Treap`] | O(log n) expected | a search tree with random priorities |
//! | [`SampleTree`] | O(log n) on average, and a walk of some ten steps | a splay tree over a tenth of the nodes |
//! | [`BitSet`] | O(log n) with 64 ways at each level | the ranks of x as bits |
//! | [`RankTable`] | O(1) expected, whatever the coordinates | a hash table over ranks of x |
//!
//! The crate's own are [`HashTable`](sweep_cdt::front::HashTable), [`SkipList`](sweep_cdt::front::SkipList)
//! and [`Linear`](sweep_cdt::front::Linear), the walk from the last node.
//!
//! Why they are right: a structure only says where the sweep's exact walk begins (see
//! [`FrontSearch`](sweep_cdt::front::FrontSearch)). Each is compared with a list in `tests/all/structures.rs`.

mod b_tree;
mod bit_set;
mod parts;
mod rank_table;
mod sample_tree;
mod sorted_array;
mod structure;
mod treap;
mod uniform_table;

pub use b_tree::BTree;
pub use bit_set::BitSet;
pub use rank_table::RankTable;
pub use sample_tree::SampleTree;
pub use sorted_array::{Finger, SortedArray};
pub use structure::{AnyFront, FromEnd, Structure};
pub use treap::Treap;
pub use uniform_table::UniformTable;

//! Search structures for the advancing front (section 3.4.1); a file of one may be copied as a start.
//!
//! | structure | a search costs | file |
//! |---|---|---|
//! | [`UniformTable`] | O(1) expected where x spreads evenly, O(n) at worst | the paper's, with equal intervals |
//! | [`FixedTable`] | O(1) while the front is short, O(n) | equal intervals, the same number for all inputs |
//! | [`FromEnd`] | O(n) | the walk from the left end |
//! | [`SortedArray`] | O(log n); an update O(n) | binary search |
//! | [`Finger`], [`TwoFingers`] | O(log d) at distance d from a last place; an update O(n) | exponential steps |
//! | [`BTree`] | O(log n) | the standard library's B-tree |
//! | [`Treap`] | O(log n) expected | a search tree with random priorities |
//! | [`SampleTree`] | O(log n) on average, and a walk of some ten steps | a splay tree over a tenth of the nodes |
//! | [`BitSet`] | O(log n) with 64 ways at each level | the ranks of x as bits |
//! | [`VanEmdeBoas`] | O(log log n) | the ranks of x in a tree that halves their bits |
//! | [`SampledUniverse`] | O(1) expected, O(sqrt(n)) at worst | the ranks of x in buckets |
//! | [`RankTable`] | O(1) expected, whatever the coordinates | a hash table over ranks of x |
//! | [`LearnedTable`] | O(log m) for m lines | the same, with lines that tell the rank of an x |
//!
//! The crate's own are [`HashTable`](sweep_cdt::front::HashTable), [`SkipList`](sweep_cdt::front::SkipList)
//! and [`Linear`](sweep_cdt::front::Linear), the walk from the last node.
//!
//! What each costs at worst says its file; `tests/all/growth.rs` has the data that reaches it, and measures.
//!
//! Why they are right: a structure only says where the sweep's exact walk begins (see
//! [`FrontSearch`](sweep_cdt::front::FrontSearch)). Each is compared with a list in `tests/all/structures.rs`.

mod b_tree;
mod bit_set;
mod fixed_table;
mod interval_table;
mod learned_table;
mod number_set;
mod parts;
mod rank_table;
mod sample_tree;
mod sampled_universe;
mod sorted_array;
mod structure;
mod treap;
mod uniform_table;
mod van_emde_boas;

pub use b_tree::BTree;
pub use bit_set::BitSet;
pub use fixed_table::FixedTable;
pub use learned_table::LearnedTable;
pub use rank_table::RankTable;
pub use sample_tree::SampleTree;
pub use sampled_universe::SampledUniverse;
pub use sorted_array::{Finger, SortedArray, TwoFingers};
pub use structure::{AnyFront, FromEnd, Structure};
pub use treap::Treap;
pub use uniform_table::UniformTable;
pub use van_emde_boas::VanEmdeBoas;

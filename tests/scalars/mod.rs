//! Every predicate of every scalar against plain determinants of big integers.

#![expect(clippy::cast_possible_truncation, reason = "chosen to fit")]

mod approximation;
mod crude;
mod frames;
mod predicates;
mod reference;
mod rounded;

//! Properties of every triangulation, as functions of bytes: the bodies of the fuzz targets.
//!
//! Each module named as a fuzz target in `fuzz/fuzz_targets` is one property, a function that panics where
//! the property does not hold. `sweep_cdt_testing` turns the bytes into degenerate inputs and judges the
//! results. [`crossings`] is a part of `valid`. All of this runs without a fuzzer too: the crate's own tests give
//! each property its [`seeds`] and random bytes. [`reached`] counts for a campaign what the inputs provoke, [`shown`]
//! shows what the bytes of a finding stand for, and [`target!`] makes a fuzz target.

pub mod bits;
pub mod bytes;
pub mod canonical;
pub mod crossings;
pub mod differential;
pub mod edits;
pub mod file;
pub mod formats;
pub mod fronts;
pub mod reached;
pub mod replay;
pub mod scalars;
pub mod seeds;
mod share;
pub mod shown;
pub mod stream;
mod targets;
pub mod valid;
pub mod verify;

pub use targets::{Lead, TARGETS, Target, fuzz, named};

//! The report of a run on itself: counters, times and steps.
//!
//! [`stats`] is what the caller gets, [`recorder`] records it, and [`probe`] is how the sweep reports: to nobody, which
//! costs nothing, or to an observer of counts and steps.

pub(crate) mod probe;
pub(crate) mod recorder;
pub(crate) mod stats;

//! Drawings: compared with snapshots, and details of larger ones.

mod details;
pub(crate) mod pictures;
pub(crate) mod story;

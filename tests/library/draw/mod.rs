//! Drawings, compared with snapshots.

pub(crate) mod pictures;
pub(crate) mod story;

//! What the caller chooses, beside the search structure.

use crate::settings::{Algorithm, Heuristics};

/// Called as `progress(swept, vertices)` at intervals.
pub(crate) type Progress<'p> = Option<&'p dyn Fn(usize, usize)>;

/// The choices.
#[derive(Clone, Copy)]
pub(crate) struct Settings<'p> {
    pub(crate) algorithm: Algorithm,
    pub(crate) heuristics: Heuristics,
    pub(crate) progress: Progress<'p>,
}

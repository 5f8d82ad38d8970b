//! Which of the planted faults this process has: the number in the environment, or none.

use std::sync::OnceLock;

/// Whether this process has this fault.
#[inline(always)]
pub(crate) fn has(fault: usize) -> bool {
    static CHOICE: OnceLock<Option<usize>> = OnceLock::new();
    *CHOICE.get_or_init(|| std::env::var("SWEEP_CDT_FAULT").ok()?.parse().ok()) == Some(fault)
}

//! The same work on many parts, with the feature `parallel` on all cores.

/// The results in the order of the parts.
pub(super) fn map<P: Send, T: Send>(parts: Vec<P>, work: impl Fn(P) -> T + Sync + Send) -> Vec<T> {
    #[cfg(feature = "parallel")]
    if parts.len() > 1 && crate::threads::has_threads() {
        use rayon::prelude::*;
        return parts.into_par_iter().map(work).collect();
    }
    parts.into_iter().map(work).collect()
}

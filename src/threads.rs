//! Work on all cores with the feature `parallel`; on one without it, or where the system gives no threads.

use alloc::vec::Vec;
#[cfg(feature = "parallel")]
use core::error::Error;
#[cfg(feature = "parallel")]
use std::sync::OnceLock;

/// Does the same work on many parts. The results are in the order of the parts.
pub fn on_all_cores<P: Send, T: Send>(
    parts: Vec<P>,
    work: impl Fn(P) -> T + Sync + Send,
) -> Vec<T> {
    #[cfg(feature = "parallel")]
    if parts.len() > 1 && has_threads() {
        use rayon::prelude::*;
        return parts.into_par_iter().map(work).collect();
    }
    parts.into_iter().map(work).collect()
}

/// Whether there is a pool, or the global one can be made: rayon panics where it cannot start its threads.
#[cfg(feature = "parallel")]
pub fn has_threads() -> bool {
    static GLOBAL: OnceLock<bool> = OnceLock::new();
    let make = || {
        // The global pool can be tried once only. Where there are no threads at all it is left alone, so that others
        // get the one that rayon makes without any.
        let one = std::thread::Builder::new().spawn(|| ());
        let has_one = one.is_ok_and(|thread| thread.join().is_ok());
        // An error without a source says that there is a pool already.
        let has_all = || match rayon::ThreadPoolBuilder::new().build_global() {
            Ok(()) => true,
            Err(error) => error.source().is_none(),
        };
        has_one && has_all()
    };
    rayon::current_thread_index().is_some() || *GLOBAL.get_or_init(make)
}

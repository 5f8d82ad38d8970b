//! Whether rayon has threads to work on (feature `parallel`).

use std::error::Error;
use std::sync::OnceLock;

/// Whether there is a pool, or the global one can be made: rayon panics where it cannot start its threads.
pub(crate) fn has_threads() -> bool {
    static GLOBAL: OnceLock<bool> = OnceLock::new();
    let make = || {
        // The global pool can be tried once only. Where there are no threads at all it is left alone, so
        // that others get the one that rayon makes without any.
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

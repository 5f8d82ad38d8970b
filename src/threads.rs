//! Work on all cores with the feature `parallel`; on one without it, or where the system gives no threads.
//!
//! What a caller wants done is passed to the pool through `dyn`, a part at a time: so this crate compiles the pool's code
//! once, and not once more for each kind of work in each crate that uses it.

use alloc::vec::Vec;
#[cfg(feature = "parallel")]
use core::error::Error;
#[cfg(feature = "parallel")]
use std::sync::{Mutex, OnceLock};

/// Does the same work on many parts. The results are in the order of the parts.
pub fn on_all_cores<P: Send, T: Send>(parts: Vec<P>, work: impl Fn(P) -> T + Sync) -> Vec<T> {
    #[cfg(feature = "parallel")]
    if parts.len() > 1 && has_threads() {
        // Each part, and then its result.
        let slots: Vec<Mutex<(Option<P>, Option<T>)>> = parts
            .into_iter()
            .map(|part| Mutex::new((Some(part), None)))
            .collect();
        each(slots.len(), &|i| {
            let lock = || slots[i].lock().expect("only one thread has this part");
            let part = lock().0.take();
            let done = part.map(&work);
            lock().1 = done;
        });
        let results = slots.into_iter().map(|slot| slot.into_inner().ok()?.1);
        return results
            .map(|result| result.expect("the work on each part is done"))
            .collect();
    }
    parts.into_iter().map(work).collect()
}

/// Calls `work` with each number below `count`, on all threads of the current pool.
#[cfg(feature = "parallel")]
fn each(count: usize, work: &(dyn Fn(usize) + Sync)) {
    use rayon::prelude::*;
    (0..count).into_par_iter().for_each(work);
}

/// Does two pieces of work at the same time, the first on this thread. Without a second thread it does one after the
/// other.
pub fn beside(here: &mut dyn FnMut(), other: &mut (dyn FnMut() + Send)) {
    #[cfg(feature = "parallel")]
    if has_threads() && rayon::current_num_threads() > 1 {
        rayon::in_place_scope(|scope| {
            scope.spawn(|_| other());
            here();
        });
        return;
    }
    here();
    other();
}

/// Does work on a thread of the current pool.
#[cfg(feature = "parallel")]
pub(crate) fn in_pool(work: &mut (dyn FnMut() + Send)) {
    rayon::scope(|_| work());
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

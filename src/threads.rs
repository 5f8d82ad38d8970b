//! Work on all cores, with the feature `parallel`; on this one without it, or where the system gives no threads.

#[cfg(feature = "parallel")]
use std::error::Error;
#[cfg(feature = "parallel")]
use std::sync::OnceLock;

/// The same work on many parts. The results are in the order of the parts.
pub(crate) fn on_all_cores<P: Send, T: Send>(
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

/// The same work on many parts, a few at a time. `take` gets the results here, in the order of the parts, while the
/// next ones are made. The first error ends it.
#[cfg(feature = "formats")]
pub(crate) fn in_turn<P: Send, T: Send, E>(
    parts: impl IntoIterator<Item = P>,
    work: impl Fn(P) -> T + Sync + Send,
    mut take: impl FnMut(T) -> Result<(), E>,
) -> Result<(), E> {
    const AT_A_TIME: usize = 16;
    let mut parts = parts.into_iter();
    let mut some = || parts.by_ref().take(AT_A_TIME).collect::<Vec<P>>();
    let mut made = on_all_cores(some(), &work);
    loop {
        let next = some();
        let taken = || made.into_iter().try_for_each(&mut take);
        if next.is_empty() {
            return taken();
        }
        let (taken, next) = beside(taken, || on_all_cores(next, &work));
        taken?;
        made = next;
    }
}

/// Two pieces of work at a time, the first on this thread; one after the other if the pool has one thread.
#[cfg(feature = "formats")]
pub(crate) fn beside<A, B: Send>(
    here: impl FnOnce() -> A,
    other: impl FnOnce() -> B + Send,
) -> (A, B) {
    #[cfg(feature = "parallel")]
    if has_threads() && rayon::current_num_threads() > 1 {
        let mut made = None;
        let done = rayon::in_place_scope(|scope| {
            scope.spawn(|_| made = Some(other()));
            here()
        });
        return (done, made.expect("the scope waits for it"));
    }
    (here(), other())
}

/// Whether there is a pool, or the global one can be made: rayon panics where it cannot start its threads.
#[cfg(feature = "parallel")]
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

#[cfg(all(test, feature = "formats"))]
mod tests {
    use super::in_turn;

    /// No result is lost, all come in order, and the first error ends it.
    #[test]
    fn results_are_taken_in_order() {
        for count in [0, 1, 15, 16, 17, 100] {
            let mut taken = Vec::new();
            let take = |square| -> Result<(), ()> {
                taken.push(square);
                Ok(())
            };
            assert_eq!(in_turn(0..count, |part| part * part, take), Ok(()));
            let expected: Vec<usize> = (0..count).map(|part| part * part).collect();
            assert_eq!(taken, expected);
        }
        let mut taken = 0;
        let take = |part| {
            taken += 1;
            if part < 40 { Ok(()) } else { Err(part) }
        };
        assert_eq!(in_turn(0..100, |part| part, take), Err(40));
        assert_eq!(taken, 41);
    }
}

//! Work on all cores in the order of a file: blocks of parts are made on all threads while this one reads or writes.

use sweep_cdt::threads::{beside, on_all_cores};

/// Parts in a block: enough for many cores, few enough that their results need little memory.
const BLOCK: usize = 64;

/// Does the same work on many parts, a block of them at a time. On this thread `take` gets the results, in the order
/// of the parts, while the next ones are made. The first error ends it.
pub(crate) fn in_turn<P: Send, T: Send, E>(
    parts: impl IntoIterator<Item = P, IntoIter: Send>,
    work: impl Fn(P) -> T + Sync + Send,
    take: impl FnMut(T) -> Result<(), E>,
) -> Result<(), E> {
    let mut parts = parts.into_iter();
    let block = || {
        let some: Vec<P> = parts.by_ref().take(BLOCK).collect();
        let goes_on = some.len() == BLOCK;
        (on_all_cores(some, &work), goes_on)
    };
    in_blocks(block, take)
}

/// Makes results block by block. On this thread `take` gets those of one block, in order, while the next block is
/// made. `block` also tells whether another one may follow. The first error ends it.
pub(crate) fn in_blocks<T: Send, E>(
    mut block: impl FnMut() -> (Vec<T>, bool) + Send,
    mut take: impl FnMut(T) -> Result<(), E>,
) -> Result<(), E> {
    let (mut made, mut goes_on) = block();
    while goes_on {
        let (mut taken, mut next) = (Ok(()), None);
        beside(
            &mut || taken = made.drain(..).try_for_each(&mut take),
            &mut || next = Some(block()),
        );
        taken?;
        (made, goes_on) = next.expect("both pieces of work are done");
    }
    made.into_iter().try_for_each(take)
}

#[cfg(test)]
mod tests {
    use super::{BLOCK, in_turn};

    /// No result is lost, all come in order, and the first error ends it.
    #[test]
    fn results_are_taken_in_order() {
        for count in [0, 1, BLOCK - 1, BLOCK, BLOCK + 1, 3 * BLOCK, 7 * BLOCK + 3] {
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
            if part < 3 * BLOCK + 5 {
                Ok(())
            } else {
                Err(part)
            }
        };
        let all = in_turn(0..9 * BLOCK, |part| part, take);
        assert_eq!(all, Err(3 * BLOCK + 5));
        assert_eq!(taken, 3 * BLOCK + 6);
    }
}

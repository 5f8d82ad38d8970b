//! Chunks of triangles, worked through on one thread or on all threads of a rayon pool.
//! Two checks take nearly all the time: turns and Delaunay. Both look at one triangle after the other and change
//! nothing, so chunks can be checked in any order, or at the same time.

use alloc::vec::Vec;
use core::ops::Range;
use core::sync::atomic::{AtomicUsize, Ordering};

use super::soup::Soup;
#[cfg(feature = "parallel")]
use crate::threads::on_all_cores;

/// Triangles in a chunk.
const CHUNK: usize = 1 << 14;

/// A way to work through the chunks.
pub(super) trait Schedule<S> {
    /// Calls `check` for each chunk and returns the results in the order of the chunks. `check` is given the soup and
    /// need not capture it, so that only [`Parallel`] demands `S: Sync`.
    fn run<T: Send>(
        soup: &Soup<'_, S>,
        progress: &Progress<'_>,
        check: impl Fn(&Soup<'_, S>, Range<usize>) -> T + Sync,
    ) -> Vec<T>;
}

/// Works through one chunk after the other.
#[derive(Debug)]
pub(super) enum Serial {}

impl<S> Schedule<S> for Serial {
    fn run<T: Send>(
        soup: &Soup<'_, S>,
        progress: &Progress<'_>,
        check: impl Fn(&Soup<'_, S>, Range<usize>) -> T + Sync,
    ) -> Vec<T> {
        let count = soup.triangles.len();
        (0..count.div_ceil(CHUNK))
            .map(|i| progress.after(chunk(i, count), |range| check(soup, range)))
            .collect()
    }
}

/// Works on all threads of the current rayon pool; on the caller's where the system gives no more.
#[cfg(feature = "parallel")]
#[derive(Debug)]
pub(super) enum Parallel {}

#[cfg(feature = "parallel")]
impl<S: Sync> Schedule<S> for Parallel {
    fn run<T: Send>(
        soup: &Soup<'_, S>,
        progress: &Progress<'_>,
        check: impl Fn(&Soup<'_, S>, Range<usize>) -> T + Sync,
    ) -> Vec<T> {
        let count = soup.triangles.len();
        on_all_cores((0..count.div_ceil(CHUNK)).collect(), |i| {
            progress.after(chunk(i, count), |range| check(soup, range))
        })
    }
}

fn chunk(i: usize, count: usize) -> Range<usize> {
    i * CHUNK..count.min((i + 1) * CHUNK)
}

/// The progress that is reported after each chunk. Each triangle counts twice: for its turn, and for its sides.
pub(super) struct Progress<'a> {
    report: Option<&'a (dyn Fn(usize, usize) + Sync)>,
    done: AtomicUsize,
    total: usize,
}

impl<'a> Progress<'a> {
    /// No progress yet, in two passes over all triangles.
    pub(super) fn new(
        report: Option<&'a (dyn Fn(usize, usize) + Sync)>,
        triangles: usize,
    ) -> Progress<'a> {
        Progress {
            report,
            done: AtomicUsize::new(0),
            total: 2 * triangles,
        }
    }

    /// Calls `check` for a chunk, then reports that it is done.
    fn after<T>(&self, chunk: Range<usize>, check: impl FnOnce(Range<usize>) -> T) -> T {
        let length = chunk.len();
        let result = check(chunk);
        if let Some(report) = self.report {
            let before = self.done.fetch_add(length, Ordering::Relaxed);
            report(before + length, self.total);
        }
        result
    }
}

//! What the work ahead takes: whether there is memory for it, how many threads it gets, and the progress bar, on a
//! terminal, for work that takes some time.
//!
//! An allocation that fails ends a process without a word of its own. So before much is allocated its size
//! is compared with what the limit of the address space (`ulimit -v`) leaves, where Linux tells. The size
//! is that of measured runs: what takes more can still fail.

use std::num::NonZeroUsize;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};
use rayon::ThreadPoolBuilder;

use super::failure::Failure;

/// Bytes that the sweep takes for a point and for an edge.
const POINT: u64 = 96;
const EDGE: u64 = 24;

/// The bytes that a triangulation of so many points and edges takes beside them, on one thread.
pub(crate) fn memory_of_triangulation(points: usize, edges: usize) -> u64 {
    points as u64 * POINT + edges as u64 * EDGE
}

/// The same on many threads.
pub(crate) fn memory_of_bands(points: usize, edges: usize) -> u64 {
    memory_of_triangulation(points, edges) * 3 / 2
}

/// Whether so many bytes can be allocated.
pub(crate) fn has_room(bytes: u64) -> bool {
    room().is_none_or(|room| bytes <= room)
}

/// The bytes that the limit leaves, if there is one.
#[cfg(target_os = "linux")]
fn room() -> Option<u64> {
    use rustix::process::{Resource, getrlimit};
    let limit = getrlimit(Resource::As).current?;
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let used = status
        .lines()
        .find_map(|line| line.strip_prefix("VmSize:"))?;
    let kilobytes: u64 = used.trim().strip_suffix(" kB")?.trim().parse().ok()?;
    Some(limit.saturating_sub(kilobytes * 1024))
}

#[cfg(not(target_os = "linux"))]
fn room() -> Option<u64> {
    None
}

/// Starts so many threads for all that follows. Nothing may have been done on several threads yet.
pub(crate) fn limit_threads(threads: NonZeroUsize) -> Result<(), Failure> {
    let pool = ThreadPoolBuilder::new().num_threads(threads.get());
    pool.build_global()
        .map_err(|error| Failure::Error(format!("--threads {threads}: {error}")))
}

/// Work that takes less time shows no bar.
const MOMENT: Duration = Duration::from_millis(500);

/// A bar that appears late and leaves nothing behind. Where standard error is no terminal it stays
/// hidden.
pub(crate) struct Progress {
    work: &'static str,
    since: Instant,
    bar: Option<ProgressBar>,
}

impl Progress {
    /// `work` names the work in front of the bar.
    pub(crate) fn new(work: &'static str) -> Progress {
        Progress {
            work,
            since: Instant::now(),
            bar: None,
        }
    }

    /// Shows that `done` parts of `all` are done.
    pub(crate) fn show(&mut self, done: usize, all: usize) {
        if self.since.elapsed() >= MOMENT {
            let bar = self.bar.get_or_insert_with(|| {
                let template = format!("{} {{bar:40}} {{percent:>3}} %, {{eta}} to go", self.work);
                let style = ProgressStyle::with_template(&template).expect("a valid template");
                ProgressBar::new(all as u64).with_style(style)
            });
            bar.set_position(done as u64);
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

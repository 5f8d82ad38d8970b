//! The needs of the work ahead: whether there is memory for it, how many threads it gets, and the progress bar, on a
//! terminal, for work that takes some time.
//!
//! An allocation that fails ends a process without a word of its own. So before much is allocated its size
//! is compared with what the limit of the address space (`ulimit -v`) leaves, where Linux tells. The size
//! is that of measured runs: what takes more can still fail.

use std::io::{self, IsTerminal, Write};
use std::num::NonZeroUsize;
use std::time::{Duration, Instant};

use rayon::ThreadPoolBuilder;

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

/// The most threads that are started: there are no more bands than this, and idle threads take time from the others.
const MOST_THREADS: usize = 256;

/// Starts so many threads for all that follows, or the most that are of use. Nothing may have been done on several
/// threads yet. Where the system gives none, one does the work.
pub(crate) fn limit_threads(threads: NonZeroUsize) {
    let pool = ThreadPoolBuilder::new().num_threads(threads.get().min(MOST_THREADS));
    drop(pool.build_global());
}

/// Work that takes less time shows no bar.
const MOMENT: Duration = Duration::from_millis(500);
/// A bar is drawn no sooner than this after the last time.
const PAUSE: Duration = Duration::from_millis(50);
/// The characters of the longest bar.
const LENGTH: usize = 30;
/// Room for a line with a bar, in characters; no terminal is taken to be narrower.
const LINE: usize = 64;

/// A bar that appears late and leaves nothing behind. Where standard error is no terminal it stays
/// hidden.
pub(crate) struct Progress {
    work: &'static str,
    since: Instant,
    drawn: Option<Instant>,
}

impl Progress {
    /// `work` names the work in front of the bar.
    pub(crate) fn new(work: &'static str) -> Progress {
        Progress {
            work,
            since: Instant::now(),
            drawn: None,
        }
    }

    /// Shows that `done` parts of `all` are done.
    pub(crate) fn show(&mut self, done: usize, all: usize) {
        let elapsed = self.since.elapsed();
        let is_due = match self.drawn {
            None => elapsed >= MOMENT,
            Some(drawn) => drawn.elapsed() >= PAUSE,
        };
        if is_due && io::stderr().is_terminal() {
            self.drawn = Some(Instant::now());
            draw(&bar(self.work, elapsed, done, all));
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.drawn.is_some() {
            draw("");
        }
    }
}

/// The line: the work, a bar, how much is done, and how long the rest will take if it goes on so.
fn bar(work: &str, elapsed: Duration, done: usize, all: usize) -> String {
    let share = done as f64 / all.max(1) as f64;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "it is at most the length"
    )]
    let length = (share.min(1.0) * LENGTH as f64) as usize;
    let bar = "#".repeat(length);
    let percent = 100.0 * share;
    let left = elapsed.as_secs_f64() * (1.0 / share.max(1e-9) - 1.0);
    format!("{work} {bar:-<LENGTH$} {percent:>3.0} %, {left:.0} s to go")
}

/// Draws a line over the one before, and leaves the cursor behind it.
fn draw(line: &str) {
    // If standard error is closed, nobody watches.
    let _ = write!(io::stderr(), "\r{line:LINE$}\r{line}");
}

//! Time and memory of the calls that triangulate.

use std::fs;
use std::time::{Duration, Instant};

/// Adds up the time of all calls and takes the memory of the first one.
#[derive(Default)]
pub(crate) struct Stopwatch {
    /// How long all calls took.
    pub(crate) time: Duration,
    /// By how many bytes the resident set grew at its peak in the first call; none where the system does
    /// not say.
    pub(crate) memory: Option<u64>,
    has_run: bool,
}

impl Stopwatch {
    /// Times a call.
    pub(crate) fn time<T>(&mut self, call: impl FnOnce() -> T) -> T {
        if self.has_run {
            return self.timed(call);
        }
        self.has_run = true;
        // Sets the peak to what is resident now.
        let is_reset = fs::write("/proc/self/clear_refs", "5").is_ok();
        let before = peak();
        let result = self.timed(call);
        if is_reset {
            self.memory = peak().zip(before).map(|(after, before)| after - before);
        }
        result
    }

    fn timed<T>(&mut self, call: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = call();
        self.time += start.elapsed();
        result
    }
}

/// The largest resident set so far, in bytes.
fn peak() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: u64 = line.trim().trim_end_matches(" kB").parse().ok()?;
    Some(1024 * kilobytes)
}

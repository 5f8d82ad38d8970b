//! The time that the processor spends on this thread. Unlike the time on the clock it does not count what other
//! programs take of a shared machine.

use std::time::Duration;

/// The processor's time of this thread so far; `None` where the system does not tell.
#[cfg(unix)]
pub(super) fn processor() -> Option<Duration> {
    use rustix::time::{ClockId, clock_gettime};

    Duration::try_from(clock_gettime(ClockId::ThreadCPUTime)).ok()
}

/// The processor's time of this thread so far; `None` where the system does not tell.
#[cfg(not(unix))]
pub(super) fn processor() -> Option<Duration> {
    None
}

#[cfg(all(test, unix))]
mod tests {
    use std::thread::sleep;
    use std::time::Duration;

    use super::processor;

    #[test]
    fn sleep_is_not_counted_and_work_is() {
        let now = || processor().expect("a clock");
        let start = now();
        sleep(Duration::from_millis(50));
        assert!(now() - start < Duration::from_millis(25));
        while now() - start < Duration::from_millis(30) {}
    }
}

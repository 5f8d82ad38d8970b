//! The progress bar: on a terminal, for work that takes some time.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

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

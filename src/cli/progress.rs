//! The progress bar: on a terminal, for work that takes longer than a moment.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

/// Work that takes less shows no bar.
const MOMENT: Duration = Duration::from_millis(500);

/// A bar that appears late and leaves nothing behind. Where standard error is no terminal it stays
/// hidden.
pub(crate) struct Progress {
    since: Instant,
    bar: Option<ProgressBar>,
}

impl Progress {
    pub(crate) fn new() -> Progress {
        Progress {
            since: Instant::now(),
            bar: None,
        }
    }

    /// Shows that `swept` of `points` points are done.
    pub(crate) fn show(&mut self, swept: usize, points: usize) {
        if self.since.elapsed() >= MOMENT {
            let bar = self.bar.get_or_insert_with(|| {
                let template = "sweeping {bar:40} {percent:>3} %, {eta} to go";
                let style = ProgressStyle::with_template(template).expect("a valid template");
                ProgressBar::new(points as u64).with_style(style)
            });
            bar.set_position(swept as u64);
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

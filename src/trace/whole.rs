//! A run's events as one value, and why one is refused.

use std::fmt;

use super::Event;

/// The version of both formats.
pub(super) const VERSION: u32 = 2;

/// The events of a run, or a stretch of them.
///
/// ```
/// use sweep_cdt::Triangulator;
/// use sweep_cdt::trace::Trace;
///
/// let mut trace = Trace::default();
/// let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
/// let result = Triangulator::new()
///     .triangulate_observed(&points, &[[0, 2]], |event| trace.events.push(event))?;
///
/// let mut text = Vec::new();
/// trace.write_text(&mut text)?;
/// let text = String::from_utf8(text)?;
/// assert!(text.starts_with("sweep-cdt trace 2\nsorted 0\nsorted 1\nsorted 3\nsorted 2\n"));
///
/// let read = Trace::parse(&text)?;
/// assert_eq!(read, trace);
/// assert_eq!(read.replay()?, result.canonical_triangles());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Trace {
    /// How many steps of the run are left out before the first one here.
    pub skipped: usize,
    /// The steps.
    pub events: Vec<Event>,
}

/// A line that cannot stand in a trace, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BadTrace {
    /// The line; the header is line 1, so that step `k` is line `k + 1`.
    pub line: usize,
    /// What is wrong with it.
    pub message: String,
}

impl BadTrace {
    /// For a line that tells no step; a long one is not shown whole.
    pub(super) fn no_step(line: usize, text: &str) -> BadTrace {
        let start: String = text.chars().take(80).collect();
        let message = format!("is no step: {start:?}");
        BadTrace { line, message }
    }
}

impl fmt::Display for BadTrace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.message)
    }
}

impl std::error::Error for BadTrace {}

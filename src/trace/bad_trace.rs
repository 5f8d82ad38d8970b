//! Why a text is not a trace, or a trace is not that of a run.

use std::fmt;

/// A line that cannot stand in a trace, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BadTrace {
    /// The line; the header is line 1, so that step `k` is line `k + 1`.
    pub line: usize,
    /// What is wrong with it.
    pub message: String,
}

impl BadTrace {
    /// For a line that is no step; of a long one only the start is shown.
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

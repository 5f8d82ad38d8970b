//! Why a text is no trace, or a trace that of no run.

use std::fmt;

/// The version of the events and of their text.
pub const VERSION: u32 = 3;

/// Why a text is no trace, or a trace not that of a run: the line that cannot stand in it, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BadTrace {
    /// The line. The header is line 1, so step `k` is line `k + 1`.
    pub line: usize,
    /// The fault of the line.
    pub message: String,
}

impl BadTrace {
    /// The error for a line that is no step; of a long line only the start is shown.
    pub fn no_step(line: usize, text: &str) -> BadTrace {
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

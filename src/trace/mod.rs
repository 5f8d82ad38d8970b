//! Step traces: every step of the paper as an [`Event`]; a whole run as a [`Trace`], written, read back and replayed.
//!
//! The text of a trace is made to be read beside the paper: a header line with the version, then one line a step. The
//! header of a part of a trace says at which step it begins: `from step 120`.
//!
//! ```text
//! sweep-cdt trace 3                                   the header
//! sorted 4                                            the sweep order, one vertex a line
//! point 7: middle case, projected on segment 3 5      or `left case`
//! triangle 7 3 5 (point)                              or first, narrow corner, basin, pocket,
//!                                                     pseudo-polygon, upper hull
//! test 3 5 against 7 2: illegal                       or legal, fixed
//! flip 3 5 to 7 2
//! front gains 7 after 3
//! front loses 5
//! edge 0: from 7 down to 1
//! switch to the front at 3 5                          or to triangles
//! part 7 1: mixed                                     or there already, below the front, front only
//! pierced 3 1 5
//! border 3 (upper pseudo-polygon)                     or lower
//! fixed 7 1
//! finalization
//! removed P-1 P-2 4
//! finished: 12 triangles
//! ```

mod event;
mod replay;
mod text;
mod whole;

pub use event::{EdgePosition, Event, Outcome, PointCase, PseudoPolygon, Vertex, Why};
pub use whole::Trace;

use alloc::format;
use alloc::string::String;
use core::fmt;

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

impl core::error::Error for BadTrace {}

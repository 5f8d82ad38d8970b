//! Step traces: every step of the paper as an [`Event`]; a whole run as a [`Trace`], written, read back
//! and replayed.
//!
//! A trace is written in one of two formats, both with a header line that gives the version and then
//! one line a step: as text, made to be read beside the paper, or as JSON Lines for programs.
//!
//! Text (`sweep-cdt trace 3`):
//!
//! ```text
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
//!
//! JSON Lines: the header is `{"format":"sweep-cdt trace","version":3}`; each step is an object whose
//! `event` is the name of the variant of [`Event`] in lower case with hyphens, and whose other members
//! are its fields; words are written the same way. Vertices are numbers, or `"P-1"` and `"P-2"`. A part
//! of a trace says at which step it begins: `from step 120` in the header, or `"from":120`.

mod event;
#[cfg(feature = "formats")]
mod json_lines;
mod replay;
mod text;
mod whole;

pub use event::{EdgePosition, Event, Outcome, PointCase, PseudoPolygon, Vertex, Why};
pub use whole::Trace;

use std::fmt;

/// The version of both formats.
const VERSION: u32 = 3;

/// Why a text is not a trace, or a trace is not that of a run: a line that cannot stand in it, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BadTrace {
    /// The line; the header is line 1, so that step `k` is line `k + 1`.
    pub line: usize,
    /// What is wrong with it.
    pub message: String,
}

impl BadTrace {
    /// For a line that is no step; of a long one only the start is shown.
    fn no_step(line: usize, text: &str) -> BadTrace {
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

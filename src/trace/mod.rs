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

mod bad_trace;
mod event;
#[cfg(feature = "formats")]
mod json_lines;
mod replay;
mod text;
mod whole;

pub use bad_trace::BadTrace;
pub use event::{EdgePosition, Event, Outcome, PointCase, PseudoPolygon, Vertex, Why};
pub use whole::Trace;

/// The version of both formats.
const VERSION: u32 = 3;

//! Step traces: every step of the paper as an [`Event`]; a whole run as a [`Trace`], written, read back
//! and replayed.
//!
//! A trace is written in one of two formats, both with a header line that gives the version and then
//! one line a step: as text, made to be read beside the paper, or as JSON Lines for programs.
//!
//! Text (`sweep-cdt trace 2`):
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
//! JSON Lines: the header is `{"format":"sweep-cdt trace","version":2}`; each step is an object whose
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

impl Trace {
    /// Writes it as text.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_text(&self, mut out: impl Write) -> io::Result<()> {
        text::write(self, &mut out)
    }

    /// Writes it as JSON Lines.
    ///
    /// # Errors
    /// Those of `out`.
    #[cfg(feature = "formats")]
    pub fn write_lines(&self, mut out: impl Write) -> io::Result<()> {
        json_lines::write(self, &mut out)
    }

    /// Reads what was written, in either format.
    ///
    /// # Errors
    /// [`BadTrace`] names the first line that is no line of a trace.
    pub fn parse(text: &str) -> Result<Trace, BadTrace> {
        #[cfg(feature = "formats")]
        if text.starts_with('{') {
            return json_lines::read(text);
        }
        text::read(text)
    }

    /// Rebuilds the result on an empty mesh, triangle by triangle, without any geometry.
    ///
    /// Returns the triangles as
    /// [`canonical_triangles`](crate::Triangulation::canonical_triangles) does. Every step must be one
    /// that the sweep could take on the mesh and the front that the steps before it made:
    ///
    /// - vertices are swept in the order that is told first, each once, on a segment of the front;
    /// - the triangles of a point event and of the pi/2 heuristic are those that the front dictates, and
    ///   so is what joins and leaves the front; no other triangle has a side that another one has, and
    ///   what it covers of the front leaves it;
    /// - a test names a side with the vertices opposite; the flip follows on an illegal one, on no other
    ///   one and never on a fixed one;
    /// - an edge begins at the vertex swept last, its parts lead down to its lower end and each is
    ///   fixed; pierced triangles are a strip from end to end, the borders are those of the strip, and
    ///   the pseudo-polygons are filled;
    /// - in the end all artificial triangles are gone, the others are as many as is told, they fill one
    ///   simple polygon, every vertex is a corner and every fixed edge a side.
    ///
    /// Not to be told without geometry, and so not noticed: that a test is missing or comes at another
    /// time, except the one just before a flip; that a switch of a mixed part is missing; the number of
    /// an input edge (but that it is new); which pseudo-polygon is the upper one; for which of the two
    /// heuristics a triangle is made that both may ask for; and the order of steps of one kind that do not
    /// touch each other. None of these changes a triangle.
    ///
    /// # Errors
    /// [`BadTrace`] names the first line that contradicts those before it, or says that lines are
    /// missing at the end.
    pub fn replay(&self) -> Result<Vec<[usize; 3]>, BadTrace> {
        if self.skipped > 0 {
            let message = format!("the trace lacks its first {} steps", self.skipped);
            return Err(BadTrace { line: 1, message });
        }
        replay::replay(&self.events)
    }
}

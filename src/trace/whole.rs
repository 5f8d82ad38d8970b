//! A run's events as one value, and why one is refused.

use std::fmt;
use std::io::{self, Write};

#[cfg(feature = "formats")]
use super::json_lines;
use super::{Event, replay, text};

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

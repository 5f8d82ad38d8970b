//! A run's events as one value.

use std::fmt;
use std::io::{self, Write};

use sweep_cdt::trace::Event;

use crate::bad_trace::BadTrace;
use crate::{replay, text};

/// The events of a run, or of a part of it.
///
/// ```
/// use sweep_cdt::{Algorithm, Triangulator, Watch};
/// use sweep_cdt_trace::Trace;
///
/// let mut trace = Trace::default();
/// let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
/// let mut push = |event| trace.events.push(event);
/// let watch = Watch::new().events(&mut push);
/// let result = Triangulator::new().algorithm(Algorithm::Paper).run(&points, &[[0, 2]], watch)?;
///
/// let mut text = Vec::new();
/// trace.write_text(&mut text)?;
/// let text = String::from_utf8(text)?;
/// assert!(text.starts_with("sweep-cdt trace 3\nsorted 0\nsorted 1\nsorted 3\nsorted 2\n"));
///
/// let read = Trace::parse(&text)?;
/// assert_eq!(read, trace);
/// assert_eq!(read.replay()?, result.canonical_triangles());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Trace {
    /// How many steps of the run come before the first one here.
    pub skipped: usize,
    /// The steps.
    pub events: Vec<Event>,
}

impl fmt::Display for Trace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        text::write(self.skipped, &self.events, f)
    }
}

impl Trace {
    /// Writes the trace as text; `to_string` returns the text.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write_text(&self, mut out: impl Write) -> io::Result<()> {
        write!(out, "{self}")
    }

    /// Reads what [`write_text`](Self::write_text) wrote.
    ///
    /// # Errors
    /// [`BadTrace`] names the first line that is no line of a trace.
    pub fn parse(text: &str) -> Result<Trace, BadTrace> {
        let (skipped, events) = text::read(text)?;
        Ok(Trace { skipped, events })
    }

    /// Rebuilds the result on an empty mesh, triangle by triangle, without any geometry.
    ///
    /// The run must have been one with [`Algorithm::Paper`](sweep_cdt::Algorithm::Paper): others have steps that no event
    /// names, and are refused where such a step is missing. Returns the triangles as [`canonical_triangles`](sweep_cdt::Triangulation::canonical_triangles) does. Every step
    /// must be one that the sweep could take on the mesh and the front that the steps before it made:
    ///
    /// - vertices are swept in the order that the trace begins with, each once, on a segment of the front;
    /// - the front dictates the triangles of a point event and of narrow corners, and what joins and leaves the front;
    ///   no other triangle has a side that has its triangle already, and front vertices that it covers leave the front;
    /// - a test names a side with the vertices opposite; a flip follows every illegal side and no other, and a fixed
    ///   side is never flipped;
    /// - an edge begins at the vertex swept last or, when the hull is complete, where its last part ended; the parts
    ///   lead down to its lower end and each is fixed; pierced triangles are a strip from end to end, the borders are
    ///   those of the strip, and the pseudo-polygons are filled;
    /// - in the end all artificial triangles are gone, the others are as many as the last step says, they fill one
    ///   simple polygon, every vertex is a corner and every fixed edge a side.
    ///
    /// Only [`compare`](Self::compare) notices some changes, none of which changes a triangle:
    ///
    /// - a test is missing or comes at another time, except the one just before a flip;
    /// - a switch of a mixed part is missing;
    /// - an input edge has another number that is new too;
    /// - an edge that is the first part of another one is said to be all of it, or the other way round;
    /// - an edge that equals an earlier one is said to equal another earlier one that has the same first part;
    /// - the names of the upper and the lower pseudo-polygon are swapped;
    /// - a triangle that either heuristic may make is said to be made by the other;
    /// - steps of one kind that do not touch each other come in another order.
    ///
    /// # Errors
    /// [`BadTrace`] names the first line that contradicts those before it, or says that lines are missing at the end.
    pub fn replay(&self) -> Result<Vec<[usize; 3]>, BadTrace> {
        if self.skipped > 0 {
            let message = format!("the trace lacks its first {} steps", self.skipped);
            return Err(BadTrace { line: 1, message });
        }
        replay::replay(&self.events)
    }

    /// Compares the trace, step by step, with `events`: those of a run on the same input with the same heuristics, from
    /// its first step on. Every change is noticed. A trace may begin later than the run and end earlier.
    ///
    /// ```
    /// use sweep_cdt::{Triangulator, Watch};
    /// use sweep_cdt_trace::Trace;
    ///
    /// let mut events = Vec::new();
    /// let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
    /// let mut push = |event| events.push(event);
    /// Triangulator::new().run(&points, &[], Watch::new().events(&mut push))?;
    /// let trace = Trace { skipped: 2, events: events[2..5].to_vec() };
    /// trace.compare(&events)?;
    ///
    /// let trace = Trace { skipped: 2, events: vec![events[2], events[4]] };
    /// assert_eq!(trace.compare(&events).unwrap_err().line, 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`BadTrace`] names the first line that differs, and what the run has in its place.
    pub fn compare(&self, events: &[Event]) -> Result<(), BadTrace> {
        let mut run = events.iter().skip(self.skipped);
        for (line, step) in (2..).zip(&self.events) {
            let message = match run.next() {
                Some(taken) if taken == step => continue,
                Some(taken) => format!("`{step}` is not what the run does: `{taken}`"),
                None => format!("`{step}` is not what the run does: it is over"),
            };
            return Err(BadTrace { line, message });
        }
        Ok(())
    }
}

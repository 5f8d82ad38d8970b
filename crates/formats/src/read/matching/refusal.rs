//! Why a result is refused before it is verified, and what helps.

use std::fmt;

use crate::Coordinate;
use crate::read::source::ReadError;

/// A result that cannot be read, or whose vertices are not those of the input.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt_formats::{Format, ResultError, Source, read_result};
///
/// let points = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
/// let input = Pslg { points, ..Pslg::default() }.into();
/// let bytes = b"v 0 0 0\nv 1 0 0\nv 0 3 0\nf 1 2 3".to_vec();
/// let source = Source::new("a.obj", bytes);
/// let error = read_result(Format::Obj, &source, None, &input).unwrap_err();
/// assert!(matches!(error, ResultError::Stranger { vertex: 3, .. }));
/// let text = "a.obj:3: vertex 3 is at (0, 3), where the input has none: the nearest is vertex 2 at (0, 1), by 2";
/// assert_eq!(error.to_string(), text);
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ResultError {
    /// The file is wrong.
    Unreadable(ReadError),
    /// A vertex of the result has a coordinate that is not finite.
    NonFinite {
        /// The name of the file.
        file: String,
        /// The line, counted from 1, if it is a text.
        line: Option<usize>,
        /// The file's number of the vertex.
        vertex: usize,
    },
    /// A vertex of the result may be none of the input.
    Stranger {
        /// The name of the file.
        file: String,
        /// The line, counted from 1, if it is a text.
        line: Option<usize>,
        /// The file's number of the vertex.
        vertex: usize,
        /// Where it is, in doubles.
        at: [f64; 2],
        /// The vertex of the input that is nearest to it, if there is one.
        nearest: Option<Box<Nearest>>,
        /// Whether the vertices have numbers, and are not the coordinates of triangles alone.
        is_numbered: bool,
        /// The difference that was allowed, if it was not rounding.
        tolerance: Option<f64>,
        /// A tolerance that accepts the result: see [`ResultError::ways_out`].
        accepted: Option<f64>,
    },
    /// A vertex of the result may be two of the input, since its coordinates are rounded, or within the tolerance.
    Ambiguous {
        /// The name of the file.
        file: String,
        /// The line, counted from 1, if it is a text.
        line: Option<usize>,
        /// The file's number of the vertex.
        vertex: usize,
        /// Where it is, in doubles.
        at: [f64; 2],
        /// The input's numbers of the two.
        of_input: [usize; 2],
        /// The difference that was allowed, if it was not rounding.
        tolerance: Option<f64>,
        /// A tolerance that accepts the result: see [`ResultError::ways_out`].
        accepted: Option<f64>,
    },
    /// Two vertices of the result at two places may be only one of the input.
    Shared {
        /// The name of the file.
        file: String,
        /// The line of the second one, counted from 1, if it is a text.
        line: Option<usize>,
        /// The file's numbers of the two.
        vertices: [usize; 2],
        /// The input's number of the one.
        of_input: usize,
        /// The difference that was allowed, if it was not rounding.
        tolerance: Option<f64>,
        /// A tolerance that accepts the result: see [`ResultError::ways_out`].
        accepted: Option<f64>,
    },
}

/// What a user can do about a result that is refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum WayOut {
    /// Allowing for this difference: it is less than half of the least distance of two vertices of the input, and within
    /// it each vertex of the result has one vertex of the input, and no other one.
    Tolerance(f64),
    /// Allowing for vertices that were added.
    Steiner,
    /// Ignoring coordinates.
    ByNumber,
    /// Writing the result with all digits of its coordinates, 17, or without coordinates.
    AllDigits,
}

impl ResultError {
    /// The error, and behind it in brackets the ways out, each in the caller's words.
    pub fn with_ways_out(&self, words: impl Fn(&WayOut) -> String) -> String {
        let ways_out: Vec<String> = self.ways_out().iter().map(words).collect();
        match ways_out.as_slice() {
            [] => self.to_string(),
            _ => format!("{self} ({})", ways_out.join(", ")),
        }
    }

    /// What a user can do, if anything is known.
    pub fn ways_out(&self) -> Vec<WayOut> {
        match *self {
            ResultError::Stranger {
                accepted: Some(tolerance),
                ..
            }
            | ResultError::Ambiguous {
                accepted: Some(tolerance),
                ..
            }
            | ResultError::Shared {
                accepted: Some(tolerance),
                ..
            } => vec![WayOut::Tolerance(tolerance)],
            ResultError::Stranger { is_numbered, .. } => {
                let by_number = is_numbered.then_some(WayOut::ByNumber);
                let ways_out = [WayOut::Steiner].into_iter().chain(by_number);
                ways_out.chain([WayOut::AllDigits]).collect()
            }
            ResultError::Ambiguous { .. } | ResultError::Shared { .. } => vec![WayOut::AllDigits],
            ResultError::Unreadable(_) | ResultError::NonFinite { .. } => Vec::new(),
        }
    }
}

impl fmt::Display for ResultError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ResultError::Unreadable(error) => write!(f, "{error}"),
            ResultError::NonFinite { file, line, vertex } => write!(
                f,
                "{} has a coordinate that is not finite",
                named(file, line, vertex)
            ),
            ResultError::Stranger {
                file,
                line,
                vertex,
                at,
                nearest,
                tolerance,
                ..
            } => {
                let vertex = named(file, line, vertex);
                write!(f, "{vertex} is at {}, where the input has none", place(at))?;
                if let Some(tolerance) = tolerance {
                    write!(f, " within the tolerance {}", tolerance.text())?;
                }
                let Some(nearest) = nearest else {
                    return Ok(());
                };
                let (number, difference) = (nearest.of_input, nearest.difference.text());
                let place = place(&nearest.at);
                write!(
                    f,
                    ": the nearest is vertex {number} at {place}, by {difference}"
                )
            }
            ResultError::Ambiguous {
                file,
                line,
                vertex,
                at,
                of_input: [first, second],
                tolerance,
                ..
            } => write!(
                f,
                "{} at {} may be vertex {first} or {second} of the input, within {}",
                named(file, line, vertex),
                place(at),
                allowed(tolerance)
            ),
            ResultError::Shared {
                file,
                line,
                vertices: [first, second],
                of_input,
                tolerance,
                ..
            } => write!(
                f,
                "{} and vertex {first}, which is elsewhere, may only be vertex {of_input} of the input, within {}",
                named(file, line, second),
                allowed(tolerance)
            ),
        }
    }
}

impl std::error::Error for ResultError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            ResultError::Unreadable(error) => error.source(),
            _ => None,
        }
    }
}

impl From<ReadError> for ResultError {
    fn from(error: ReadError) -> ResultError {
        ResultError::Unreadable(error)
    }
}

/// The vertex of the input that is nearest to one of a result.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Nearest {
    /// The input's number of the vertex.
    pub of_input: usize,
    /// Where it is, in doubles.
    pub at: [f64; 2],
    /// The difference in x or in y, whichever is greater.
    pub difference: f64,
}

/// A vertex of a file, or of a result that stands in none.
fn named(file: &str, line: &Option<usize>, vertex: &usize) -> String {
    let line = line.map_or(String::new(), |line| format!("{line}:"));
    match file {
        "" => format!("vertex {vertex} of the result"),
        file => format!("{file}:{line} vertex {vertex}"),
    }
}

fn place([x, y]: &[f64; 2]) -> String {
    format!("({}, {})", x.text(), y.text())
}

fn allowed(tolerance: &Option<f64>) -> String {
    match tolerance {
        None => "rounding to the digits that are there".to_owned(),
        Some(tolerance) => format!("the tolerance {}", tolerance.text()),
    }
}

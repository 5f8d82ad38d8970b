//! Why a result is refused before it is verified.

use crate::formats::Coordinate;
use crate::formats::read::source::ReadError;

/// A result that cannot be read, or whose vertices are not those of the input.
///
/// ```
/// use sweep_cdt::formats::{Graph, ResultError, ResultFormat, Source, read_result};
///
/// let points = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
/// let input = Graph { points, ..Graph::default() };
/// let bytes = b"v 0 0 0\nv 1 0 0\nv 0 3 0\nf 1 2 3".to_vec();
/// let source = Source { name: "a.obj".to_owned(), bytes };
/// let error = read_result(ResultFormat::Obj, &source, None, &input).unwrap_err();
/// assert!(matches!(error, ResultError::Elsewhere { vertex: 3, .. }));
/// let text = "a.obj:3: vertex 3 is at (0, 3), but vertex 2 of the input at (0, 1), which is more than \
///     rounding to 6 digits";
/// assert_eq!(error.to_string(), text);
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ResultError {
    /// The file is wrong.
    #[error(transparent)]
    Unreadable(#[from] ReadError),
    /// A vertex of the result has a coordinate that is not finite.
    #[error("{file}:{line}: vertex {vertex} has a coordinate that is not finite")]
    NonFinite {
        /// The name of the file.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// The file's number of the vertex.
        vertex: usize,
    },
    /// A vertex of the result is no vertex of the input, and there are not as many of both, so that they
    /// cannot be matched by number either.
    #[error(
        "{file}:{line}: vertex {vertex} is at {}, where the input has none",
        place(.at)
    )]
    Stranger {
        /// The name of the file.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// The file's number of the vertex.
        vertex: usize,
        /// Where it is, in doubles.
        at: [f64; 2],
    },
    /// The vertices of the result are not those of the input, and this one is too far from the one of the
    /// same number.
    #[error(
        "{file}:{line}: vertex {vertex} is at {}, but vertex {of_input} of the input at {}, which is more \
         than {}",
        place(.at), place(.expected), allowed(.tolerance)
    )]
    Elsewhere {
        /// The name of the file.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// The file's number of the vertex.
        vertex: usize,
        /// Where it is, in doubles.
        at: [f64; 2],
        /// The input's number of the vertex with which it would be matched.
        of_input: usize,
        /// Where that is, in doubles.
        expected: [f64; 2],
        /// The difference that was allowed, if it was not rounding.
        tolerance: Option<f64>,
    },
}

fn place([x, y]: &[f64; 2]) -> String {
    format!("({}, {})", x.text(), y.text())
}

fn allowed(tolerance: &Option<f64>) -> String {
    match tolerance {
        None => "rounding to 6 digits".to_owned(),
        Some(tolerance) => format!("the tolerance {}", tolerance.text()),
    }
}

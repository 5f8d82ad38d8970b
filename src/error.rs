//! Why an input is refused: every error names the offenders by the caller's own indices.

use std::fmt;

/// An input that has no constrained Delaunay triangulation, and who is to blame.
///
/// All indices are positions in the slices that the caller passed, counted from 0. Everything that is
/// not listed here is accepted: duplicate points and edges, edges of no length, edges through
/// vertices, edges that overlap, and inputs with no triangle at all.
///
/// ```
/// use sweep_cdt::{triangulate, Error};
///
/// let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
/// let both_diagonals = [[0, 2], [1, 3]];
/// let error = triangulate(&square, &both_diagonals).unwrap_err();
/// assert_eq!(error, Error::CrossingEdges { edges: [0, 1] });
/// assert_eq!(error.to_string(), "edges 0 and 1 cross");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Error {
    /// A coordinate of this point is NaN or infinite.
    NonFiniteCoordinate {
        /// The first such point.
        vertex: usize,
    },
    /// An end of this edge is not the index of a point.
    EdgeOutOfRange {
        /// The first such edge.
        edge: usize,
        /// Its end that is out of range (the first one of two).
        vertex: usize,
    },
    /// Two edges cross at a point inside both of them that is not a vertex.
    CrossingEdges {
        /// The two edges, lower index first.
        edges: [usize; 2],
    },
    /// More points or edges than the index type can number.
    TooManyPoints {
        /// How many there are.
        given: usize,
        /// How many there may be.
        limit: usize,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Error::NonFiniteCoordinate { vertex } => {
                write!(f, "vertex {vertex} has a coordinate that is not finite")
            }
            Error::EdgeOutOfRange { edge, vertex } => {
                write!(
                    f,
                    "edge {edge} ends at vertex {vertex}, which does not exist"
                )
            }
            Error::CrossingEdges { edges: [a, b] } => write!(f, "edges {a} and {b} cross"),
            Error::TooManyPoints { given, limit } => {
                write!(
                    f,
                    "{given} points or edges are more than the {limit} that fit"
                )
            }
        }
    }
}

impl std::error::Error for Error {}

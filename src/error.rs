//! Why an input is refused.

use core::fmt;

/// Why an input is refused, and which of its points and edges are to blame.
///
/// All indices are positions in the caller's slices, from 0. Everything else is accepted: duplicate points and edges,
/// edges of no length, edges through vertices, edges that overlap, and inputs with no triangle at all.
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
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Error {
    /// A coordinate of a point is NaN or infinite.
    NonFiniteCoordinate {
        /// The first such point.
        vertex: usize,
    },
    /// An end of an edge is not the index of a point.
    EdgeOutOfRange {
        /// The first such edge.
        edge: usize,
        /// The end that is out of range (the first one of two).
        vertex: usize,
    },
    /// Two edges cross at a point inside both that is no vertex. [`crossings`](crate::crossings) lists and splits all.
    CrossingEdges {
        /// The two edges, lower index first.
        edges: [usize; 2],
    },
    /// More points than can be numbered.
    TooManyPoints {
        /// How many there are.
        given: usize,
        /// How many there may be.
        limit: usize,
    },
    /// More edges than can be numbered.
    TooManyEdges {
        /// How many there are.
        given: usize,
        /// How many there may be.
        limit: usize,
    },
    /// There is less memory than the triangulation takes. Only runs that take 32 MiB and more are checked, and only for
    /// the greatest part of what they take. Where the rest is missing, the process ends, as after any failed allocation.
    OutOfMemory {
        /// How many bytes it takes, about.
        bytes: usize,
    },
    /// More vertices inside edges than can be held, each counted for each edge; equal edges count once.
    TooManyVerticesOnEdges {
        /// How many there may be.
        limit: usize,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::NonFiniteCoordinate { vertex } => {
                write!(f, "vertex {vertex} has a coordinate that is not finite")
            }
            Error::EdgeOutOfRange { edge, vertex } => write!(
                f,
                "edge {edge} ends at vertex {vertex}, which does not exist"
            ),
            Error::CrossingEdges { edges } => {
                write!(f, "edges {} and {} cross", edges[0], edges[1])
            }
            Error::TooManyPoints { given, limit } => {
                write!(f, "{given} points are more than the limit of {limit}")
            }
            Error::TooManyEdges { given, limit } => {
                write!(f, "{given} edges are more than the limit of {limit}")
            }
            Error::OutOfMemory { bytes } => {
                write!(
                    f,
                    "out of memory: the triangulation takes some {bytes} bytes"
                )
            }
            Error::TooManyVerticesOnEdges { limit } => write!(
                f,
                "the edges pass through more than {limit} vertices, all together"
            ),
        }
    }
}

impl core::error::Error for Error {}

impl Error {
    /// The error with other numbers for vertices and edges, for callers that count otherwise than from 0.
    ///
    /// ```
    /// use sweep_cdt::Error;
    ///
    /// let error = Error::CrossingEdges { edges: [0, 1] };
    /// let from_1 = error.renumbered(|v| v + 1, |e| e + 1);
    /// assert_eq!(from_1.to_string(), "edges 1 and 2 cross");
    /// ```
    #[must_use]
    pub fn renumbered(
        self,
        on_vertex: impl FnOnce(usize) -> usize,
        mut on_edge: impl FnMut(usize) -> usize,
    ) -> Error {
        match self {
            Error::NonFiniteCoordinate { vertex } => Error::NonFiniteCoordinate {
                vertex: on_vertex(vertex),
            },
            Error::EdgeOutOfRange { edge, vertex } => Error::EdgeOutOfRange {
                edge: on_edge(edge),
                vertex: on_vertex(vertex),
            },
            Error::CrossingEdges { edges } => Error::CrossingEdges {
                edges: edges.map(on_edge),
            },
            Error::TooManyPoints { .. }
            | Error::TooManyEdges { .. }
            | Error::OutOfMemory { .. }
            | Error::TooManyVerticesOnEdges { .. } => self,
        }
    }
}

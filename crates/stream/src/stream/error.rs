//! Why a stream ends early.

use std::fmt;

use super::stats::Alive;
use sweep_cdt::Error;

/// Why a stream ends early, by the caller's numbers. What was passed on before is right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum StreamError {
    /// A coordinate of a vertex is NaN or infinite.
    NonFiniteCoordinate {
        /// The vertex.
        vertex: u64,
    },
    /// A vertex comes before its predecessor by y, then by x.
    Unsorted {
        /// The vertex.
        vertex: u64,
    },
    /// A vertex lies beyond the range of x that was given.
    OutsideRange {
        /// The vertex.
        vertex: u64,
    },
    /// An edge follows no vertex, or its upper end is not finite, lies before its lower end or beyond the range of x.
    BadEdge {
        /// The edge.
        edge: u64,
    },
    /// The upper end of an edge is none of the vertices.
    MissingEnd {
        /// The edge; the first one of several with this end.
        edge: u64,
    },
    /// Two edges cross at a point inside both that is no vertex. In memory the pair that is named may be another one.
    CrossingEdges {
        /// The two edges, lower number first.
        edges: [u64; 2],
    },
    /// More vertices are alive than the limit allows.
    TooMuchAlive {
        /// What is alive, and what it waits for.
        alive: Alive,
        /// The limit.
        limit: usize,
    },
    /// A band has no vertices.
    NoVertices,
    /// Two rests do not follow each other.
    NotNext {
        /// The position behind the last vertex of the lower one.
        end: u64,
        /// The position of the first vertex of the upper one.
        next: u64,
    },
    /// Two rests are of different inputs: the number of vertices, the range of x or the edges from one to the other differ.
    OtherInput,
    /// A window is too much for memory, or for the numbers of its vertices.
    Window(Error),
}

impl StreamError {
    /// An error, if more vertices are alive than the limit allows.
    pub(super) fn refuse(alive: Alive, limit: usize) -> Result<(), StreamError> {
        match alive.vertices > limit {
            true => Err(StreamError::TooMuchAlive { alive, limit }),
            false => Ok(()),
        }
    }
}

impl fmt::Display for StreamError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StreamError::NonFiniteCoordinate { vertex } => {
                write!(f, "vertex {vertex} has a coordinate that is not finite")
            }
            StreamError::Unsorted { vertex } => {
                write!(
                    f,
                    "vertex {vertex} comes before its predecessor by y, then x"
                )
            }
            StreamError::OutsideRange { vertex } => {
                write!(
                    f,
                    "vertex {vertex} lies beyond the range of x that was given"
                )
            }
            StreamError::BadEdge { edge } => write!(
                f,
                "edge {edge} has an upper end that is not finite, not above its vertex, or beyond the range of x"
            ),
            StreamError::MissingEnd { edge } => {
                write!(f, "the upper end of edge {edge} is none of the vertices")
            }
            StreamError::CrossingEdges { edges: [e, g] } => write!(f, "edges {e} and {g} cross"),
            StreamError::TooMuchAlive { alive, limit } => write!(
                f,
                "{} vertices are alive, more than the limit of {limit}: {} triangles wait since their circles reach \
                 the sweep line, {} for the ends of edges, {} sides of the hull",
                alive.vertices, alive.circles, alive.edges, alive.hull_sides
            ),
            StreamError::NoVertices => f.write_str("a band has no vertices"),
            StreamError::NotNext { end, next } => write!(
                f,
                "a rest ends before vertex {end} of the order, and the next one begins with vertex {next}"
            ),
            StreamError::OtherInput => f.write_str("two rests are not of one input"),
            StreamError::Window(error) => write!(f, "a window of the stream: {error}"),
        }
    }
}

impl std::error::Error for StreamError {}

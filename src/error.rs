//! Why an input is refused. Every error names the offenders by the caller's own indices.

/// Why an input is refused, and which of its points and edges are to blame.
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
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, thiserror::Error)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Error {
    /// A coordinate of this point is NaN or infinite.
    #[error("vertex {vertex} has a coordinate that is not finite")]
    NonFiniteCoordinate {
        /// The first such point.
        vertex: usize,
    },
    /// An end of this edge is not the index of a point.
    #[error("edge {edge} ends at vertex {vertex}, which does not exist")]
    EdgeOutOfRange {
        /// The first such edge.
        edge: usize,
        /// Its end that is out of range (the first one of two).
        vertex: usize,
    },
    /// Two edges cross at a point inside both of them that is not a vertex. [`crossings`](crate::crossings) lists all
    /// that do, and splits them.
    #[error("edges {} and {} cross", edges[0], edges[1])]
    CrossingEdges {
        /// The two edges, lower index first.
        edges: [usize; 2],
    },
    /// More points than can be numbered.
    #[error("{given} points are more than the limit of {limit}")]
    TooManyPoints {
        /// How many there are.
        given: usize,
        /// How many there may be.
        limit: usize,
    },
    /// More edges than can be numbered.
    #[error("{given} edges are more than the limit of {limit}")]
    TooManyEdges {
        /// How many there are.
        given: usize,
        /// How many there may be.
        limit: usize,
    },
    /// More pairs of edges cross than can be listed.
    #[error("more than {limit} pairs of edges cross")]
    TooManyCrossings {
        /// How many there may be.
        limit: usize,
    },
    /// Edges that are split at their crossings still cross, since rounding bends them each time.
    #[error("edges still cross after {limit} rounds of splitting and rounding")]
    TooManyRounds {
        /// How many rounds there may be.
        limit: usize,
    },
    /// The edges pass through more vertices than can be held, each edge counted with each vertex inside it.
    /// Equal edges count once.
    #[error("the edges pass through more than {limit} vertices, all together")]
    TooManyVerticesOnEdges {
        /// How many there may be.
        limit: usize,
    },
}

//! Why an edit is refused.

use std::fmt;

use sweep_cdt::Error;

/// Why an edit is refused. All numbers are the caller's. After an error nothing has changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EditError {
    /// There is no point of this number: it was removed, or is yet to come.
    NoPoint {
        /// The number.
        point: usize,
    },
    /// There is no edge of this number.
    NoEdge {
        /// The number.
        edge: usize,
    },
    /// An edge that stays ends at a point that is to be removed.
    PointInUse {
        /// The point.
        point: usize,
        /// The edge of the lowest number that ends there.
        edge: usize,
    },
    /// Two edges cross at a point inside both that is no vertex, or is none any more.
    CrossingEdges {
        /// The two edges, lower number first. New edges have the numbers that they would have had.
        edges: [usize; 2],
    },
    /// A coordinate of a point is NaN or infinite.
    NonFiniteCoordinate {
        /// The number that the point would have had.
        point: usize,
    },
    /// The library refuses what is left: too many points or edges, or too little memory.
    Refused {
        /// Why.
        error: Error,
    },
}

impl EditError {
    pub(crate) fn crossing(a: usize, b: usize) -> EditError {
        let edges = [a.min(b), a.max(b)];
        EditError::CrossingEdges { edges }
    }
}

impl fmt::Display for EditError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EditError::NoPoint { point } => write!(f, "there is no point {point}"),
            EditError::NoEdge { edge } => write!(f, "there is no edge {edge}"),
            EditError::PointInUse { point, edge } => {
                write!(
                    f,
                    "point {point} is an end of edge {edge}: remove the edge too"
                )
            }
            EditError::CrossingEdges { edges: [a, b] } => write!(f, "edges {a} and {b} cross"),
            EditError::NonFiniteCoordinate { point } => {
                write!(f, "point {point} has a coordinate that is not finite")
            }
            EditError::Refused { error } => error.fmt(f),
        }
    }
}

impl std::error::Error for EditError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            EditError::Refused { error } => Some(error),
            _ => None,
        }
    }
}

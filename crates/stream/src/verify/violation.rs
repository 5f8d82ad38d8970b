//! What the verifier of streams finds to be wrong.

use std::fmt;

/// The first fault of a stream. All numbers are the caller's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum StreamViolation {
    /// A coordinate of a vertex is NaN or infinite.
    NonFiniteCoordinate {
        /// The vertex.
        vertex: u64,
    },
    /// A vertex has a number that another one has.
    RepeatedVertex {
        /// The number.
        vertex: u64,
    },
    /// A vertex is named that has not come, or whose triangles had gone all the way round before.
    UnknownVertex {
        /// The vertex.
        vertex: u64,
    },
    /// A vertex does not lie where the one lies whose duplicate it is said to be.
    NoDuplicate {
        /// The vertex.
        vertex: u64,
        /// The other one.
        of: u64,
    },
    /// The corners of a triangle do not turn left.
    NotLeft {
        /// The corners.
        corners: [u64; 3],
    },
    /// Two triangles lie on the same side of one side.
    RepeatedSide {
        /// The side, in the direction that both have.
        side: [u64; 2],
    },
    /// Of two triangles at a side one says that it is constrained.
    HalfConstrained {
        /// The side.
        side: [u64; 2],
    },
    /// A side is not locally Delaunay.
    NotDelaunay {
        /// The side.
        side: [u64; 2],
    },
    /// Of four vertices on one circle the diagonal does not end at the first one.
    NotCanonical {
        /// The diagonal.
        side: [u64; 2],
    },
    /// An edge does not end above the vertex at which it begins, or its upper end is not finite.
    BadEdge {
        /// The edge.
        edge: u64,
    },
    /// An edge came when triangles had a corner at its lower end or above.
    LateEdge {
        /// The edge.
        edge: u64,
    },
    /// From a vertex up, an edge is no chain of constrained sides.
    BrokenEdge {
        /// The edge.
        edge: u64,
        /// The last vertex that its sides reach.
        vertex: u64,
    },
    /// A constrained side is no part of an edge.
    NoEdge {
        /// The side.
        side: [u64; 2],
    },
    /// A vertex is no corner.
    UnusedVertex {
        /// The vertex.
        vertex: u64,
    },
    /// The sides with one triangle are no closed chain, or one that turns right, or back, or goes round more than once.
    NotConvex {
        /// A vertex at which that shows.
        vertex: u64,
    },
    /// There is no triangle, but vertices that do not lie on one line.
    NoTriangle {
        /// A vertex beside the line through others.
        vertex: u64,
    },
}

impl fmt::Display for StreamViolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StreamViolation::NonFiniteCoordinate { vertex } => {
                write!(f, "vertex {vertex} has a coordinate that is not finite")
            }
            StreamViolation::RepeatedVertex { vertex } => {
                write!(f, "two vertices are number {vertex}")
            }
            StreamViolation::UnknownVertex { vertex } => write!(
                f,
                "vertex {vertex} is named, but has not come, or triangles went all the way round it before"
            ),
            StreamViolation::NoDuplicate { vertex, of } => {
                write!(f, "vertex {vertex} does not equal vertex {of}")
            }
            StreamViolation::NotLeft { corners: [a, b, c] } => {
                write!(f, "triangle {a} {b} {c} does not turn left")
            }
            StreamViolation::RepeatedSide { side: [u, v] } => {
                write!(f, "two triangles lie left of the side from {u} to {v}")
            }
            StreamViolation::HalfConstrained { side: [u, v] } => {
                write!(
                    f,
                    "the side {u} {v} is constrained in one of its triangles alone"
                )
            }
            StreamViolation::NotDelaunay { side: [u, v] } => {
                write!(f, "the side {u} {v} is not locally Delaunay")
            }
            StreamViolation::NotCanonical { side: [u, v] } => write!(
                f,
                "the side {u} {v} misses the first of four vertices on one circle"
            ),
            StreamViolation::BadEdge { edge } => {
                write!(f, "edge {edge} does not end above its first vertex")
            }
            StreamViolation::LateEdge { edge } => write!(
                f,
                "edge {edge} came after triangles with corners at its lower end or above"
            ),
            StreamViolation::BrokenEdge { edge, vertex } => write!(
                f,
                "edge {edge} is no chain of constrained sides from vertex {vertex} up"
            ),
            StreamViolation::NoEdge { side: [u, v] } => {
                write!(f, "the constrained side {u} {v} is part of no edge")
            }
            StreamViolation::UnusedVertex { vertex } => write!(f, "vertex {vertex} is no corner"),
            StreamViolation::NotConvex { vertex } => write!(
                f,
                "the border is no convex polygon that is passed once, as shows at vertex {vertex}"
            ),
            StreamViolation::NoTriangle { vertex } => write!(
                f,
                "there is no triangle, but vertex {vertex} does not lie on a line with others"
            ),
        }
    }
}

impl std::error::Error for StreamViolation {}

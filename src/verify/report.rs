//! What the verifier answers: counts, and what is wrong, each fault with the indices of the caller.

use std::fmt;

/// What was counted and decided; a result that has one, without [`Violations`], is proven correct.
///
/// A *side* is a side of a triangle, counted once however many triangles have it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Report {
    /// Input points.
    pub points: usize,
    /// Points that differ from all of a lower index.
    pub distinct_points: usize,
    /// Input edges.
    pub edges: usize,
    /// Triangles.
    pub triangles: usize,
    /// Whether the triangles were given clockwise, and accepted so.
    pub clockwise: bool,
    /// Sides with a triangle on one side only.
    pub boundary_sides: usize,
    /// Sides that are input edges or pieces of them.
    pub constrained_sides: usize,
    /// Sides between two triangles that are no pieces of input edges: what must be Delaunay.
    pub free_sides: usize,
    /// How many of the free sides have their two triangles on one circle: where it is a matter of taste
    /// which diagonal is drawn.
    pub cocircular_sides: usize,
    /// How many of the cocircular sides this crate would have drawn otherwise (see
    /// [`is_canonical`](Report::is_canonical)).
    pub uncanonical_sides: usize,
    /// Signs that doubles decided.
    pub filtered: u64,
    /// Signs that took exact arithmetic.
    pub exact: u64,
}

impl Report {
    /// Whether a correct result is the canonical one, which [`triangulate`](crate::triangulate)
    /// returns: of four vertices on one circle the diagonal has the leftmost (of two, the upper one)
    /// for an end. There is only one such triangulation of an input.
    pub fn is_canonical(&self) -> bool {
        self.uncanonical_sides == 0
    }
}

/// What is wrong with a triangulation.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Violations {
    /// The first ones, in the order of the checks, up to the limit.
    pub list: Vec<Violation>,
    /// How many there are, beyond the limit too.
    pub found: usize,
    /// The counts as far as they were made.
    pub report: Box<Report>,
}

impl fmt::Display for Violations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no constrained Delaunay triangulation: ")?;
        match self.list.first() {
            Some(first) if self.found == 1 => write!(f, "{first}"),
            Some(first) => write!(f, "{first}, and {} more violations", self.found - 1),
            None => write!(f, "{} violations", self.found),
        }
    }
}

impl std::error::Error for Violations {}

/// One fault. All numbers are indices into what the caller gave; of equal points the lowest is named.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Violation {
    /// More points or corners of triangles than the verifier can number.
    TooLarge {
        /// How many there are.
        given: usize,
        /// How many there may be.
        limit: usize,
    },
    /// A coordinate of this point is NaN or infinite.
    NonFiniteCoordinate {
        /// The point.
        vertex: usize,
    },
    /// An end of this input edge is not the index of a point.
    EdgeOutOfRange {
        /// The edge.
        edge: usize,
        /// Its end (the first one of two).
        vertex: usize,
    },
    /// A corner of this triangle is not the index of a point.
    TriangleOutOfRange {
        /// The triangle.
        triangle: usize,
        /// Its corner (the first one of several).
        vertex: usize,
    },
    /// The corners of this triangle lie on one line.
    FlatTriangle {
        /// The triangle.
        triangle: usize,
    },
    /// The corners of this triangle run clockwise (or against all others, where a clockwise file was
    /// accepted).
    ReversedTriangle {
        /// The triangle.
        triangle: usize,
    },
    /// Two triangles lie on the same side of one side.
    RepeatedSide {
        /// The side, in the direction that both have.
        side: [usize; 2],
        /// The two triangles.
        triangles: [usize; 2],
    },
    /// There are no triangles although three points are not on one line.
    NoTriangles {
        /// Three such points.
        vertices: [usize; 3],
    },
    /// The boundary meets itself in a vertex.
    PinchedBoundary {
        /// The vertex.
        vertex: usize,
    },
    /// The boundary has one more closed chain than the hull: a hole, or a second piece.
    ExtraBoundary {
        /// A side of it, with a triangle on its left.
        side: [usize; 2],
        /// How many sides it has.
        sides: usize,
    },
    /// The boundary turns right, or back.
    ConcaveBoundary {
        /// Three vertices that follow each other on it; it turns in the middle.
        vertices: [usize; 3],
    },
    /// The boundary turns left all the time, but goes round more than once.
    WindingBoundary {
        /// How often it goes round.
        times: usize,
    },
    /// A side of the boundary is not in the chains that the caller gave.
    UndeclaredBoundary {
        /// The side, with a triangle on its left.
        side: [usize; 2],
        /// The triangle.
        triangle: usize,
    },
    /// Two vertices that follow each other in a chain of the caller are no side of the boundary.
    MissingBoundary {
        /// The two vertices.
        side: [usize; 2],
    },
    /// No triangle has this point, or one that equals it, for a corner.
    UnusedPoint {
        /// The point.
        vertex: usize,
    },
    /// The number of triangles is not what Euler's formula asks for.
    WrongCount {
        /// How many there are.
        triangles: usize,
        /// How many there must be.
        expected: usize,
    },
    /// An input edge is not a chain of sides.
    MissingEdge {
        /// The edge.
        edge: usize,
        /// The vertex on it from which no side leads on along it.
        after: usize,
    },
    /// A side that is no input edge is not locally Delaunay.
    NotDelaunay {
        /// The side, in the direction that the first triangle has.
        side: [usize; 2],
        /// The two triangles that have it.
        triangles: [usize; 2],
        /// Their corners opposite to it; each lies inside the other triangle's circumcircle.
        opposite: [usize; 2],
    },
}

impl Violation {
    /// The name of the class of fault: the variant in lower case with hyphens.
    pub fn name(&self) -> &'static str {
        match self {
            Violation::TooLarge { .. } => "too-large",
            Violation::NonFiniteCoordinate { .. } => "non-finite-coordinate",
            Violation::EdgeOutOfRange { .. } => "edge-out-of-range",
            Violation::TriangleOutOfRange { .. } => "triangle-out-of-range",
            Violation::FlatTriangle { .. } => "flat-triangle",
            Violation::ReversedTriangle { .. } => "reversed-triangle",
            Violation::RepeatedSide { .. } => "repeated-side",
            Violation::NoTriangles { .. } => "no-triangles",
            Violation::PinchedBoundary { .. } => "pinched-boundary",
            Violation::ExtraBoundary { .. } => "extra-boundary",
            Violation::ConcaveBoundary { .. } => "concave-boundary",
            Violation::WindingBoundary { .. } => "winding-boundary",
            Violation::UndeclaredBoundary { .. } => "undeclared-boundary",
            Violation::MissingBoundary { .. } => "missing-boundary",
            Violation::UnusedPoint { .. } => "unused-point",
            Violation::WrongCount { .. } => "wrong-count",
            Violation::MissingEdge { .. } => "missing-edge",
            Violation::NotDelaunay { .. } => "not-delaunay",
        }
    }
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Violation::TooLarge { given, limit } => {
                write!(
                    f,
                    "{given} points or corners are more than the {limit} that fit"
                )
            }
            Violation::NonFiniteCoordinate { vertex } => {
                write!(f, "vertex {vertex} has a coordinate that is not finite")
            }
            Violation::EdgeOutOfRange { edge, vertex } => {
                write!(
                    f,
                    "edge {edge} ends at vertex {vertex}, which does not exist"
                )
            }
            Violation::TriangleOutOfRange { triangle, vertex } => {
                write!(
                    f,
                    "triangle {triangle} has vertex {vertex}, which does not exist"
                )
            }
            Violation::FlatTriangle { triangle } => {
                write!(f, "triangle {triangle} has its corners on one line")
            }
            Violation::ReversedTriangle { triangle } => {
                write!(f, "triangle {triangle} runs the wrong way round")
            }
            Violation::RepeatedSide {
                side: [a, b],
                triangles: [t, u],
            } => {
                write!(
                    f,
                    "triangles {t} and {u} both lie to the left of side {a}-{b}"
                )
            }
            Violation::NoTriangles {
                vertices: [a, b, c],
            } => {
                write!(
                    f,
                    "there are no triangles, but vertices {a}, {b}, {c} are not on a line"
                )
            }
            Violation::PinchedBoundary { vertex } => {
                write!(f, "the boundary meets itself in vertex {vertex}")
            }
            Violation::ExtraBoundary {
                side: [a, b],
                sides,
            } => {
                write!(
                    f,
                    "side {a}-{b} is on another boundary than the hull, of {sides} sides"
                )
            }
            Violation::ConcaveBoundary {
                vertices: [a, b, c],
            } => {
                write!(
                    f,
                    "the boundary does not turn left at vertex {b}, between {a} and {c}"
                )
            }
            Violation::WindingBoundary { times } => {
                write!(f, "the boundary goes round {times} times")
            }
            Violation::UndeclaredBoundary {
                side: [a, b],
                triangle,
            } => {
                write!(
                    f,
                    "side {a}-{b} of triangle {triangle} is on no given boundary"
                )
            }
            Violation::MissingBoundary { side: [a, b] } => {
                write!(f, "side {a}-{b} of a given boundary bounds no triangle")
            }
            Violation::UnusedPoint { vertex } => write!(f, "vertex {vertex} is in no triangle"),
            Violation::WrongCount {
                triangles,
                expected,
            } => {
                write!(f, "there are {triangles} triangles and not {expected}")
            }
            Violation::MissingEdge { edge, after } => {
                write!(
                    f,
                    "edge {edge} is no chain of sides: none follows it from vertex {after}"
                )
            }
            Violation::NotDelaunay {
                side: [a, b],
                triangles: [t, u],
                opposite: [c, d],
            } => write!(
                f,
                "side {a}-{b} of triangles {t} and {u} is not Delaunay: \
                 the circle of one holds vertex {c} or {d} of the other"
            ),
        }
    }
}

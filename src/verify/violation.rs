//! The violations of a triangulation, each with its sentence; and their indices, collected or renumbered as in a file.

use alloc::vec::Vec;
use core::fmt;
use core::slice::from_mut;

use super::depth::Depth;

/// One fault. All numbers are indices into the caller's arrays; of equal points the lowest is named.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize),
    serde(rename_all = "kebab-case")
)]
#[non_exhaustive]
pub enum Violation {
    /// More points or corners of triangles than the verifier can number.
    TooLarge {
        /// The number of points or corners given.
        given: usize,
        /// The greatest number that fits.
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
        /// The end (the first one of two).
        vertex: usize,
    },
    /// A corner of this triangle is not the index of a point.
    TriangleOutOfRange {
        /// The triangle.
        triangle: usize,
        /// The corner (the first one of several).
        vertex: usize,
    },
    /// The corners of this triangle lie on one line.
    FlatTriangle {
        /// The triangle.
        triangle: usize,
    },
    /// The corners of this triangle run clockwise (or against all others, where a clockwise file was accepted).
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
        /// Three points that are not on one line.
        vertices: [usize; 3],
    },
    /// The boundary meets itself in a vertex.
    PinchedBoundary {
        /// The vertex.
        vertex: usize,
    },
    /// The boundary has one more closed chain than the hull: a hole, or a second piece.
    ExtraBoundary {
        /// A side of the chain, with a triangle on its left.
        side: [usize; 2],
        /// How many sides the chain has.
        sides: usize,
    },
    /// The boundary turns right, or back.
    ConcaveBoundary {
        /// Three vertices that follow each other on the boundary; it turns in the middle.
        vertices: [usize; 3],
        /// The depth of the turn, where that was measured.
        depth: Option<Depth>,
    },
    /// The boundary turns left all the time, but goes round more than once.
    WindingBoundary {
        /// How often the boundary goes round.
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
    /// The caller's chains bound no domain: two sides cross, or they go round a place more than once or the wrong way.
    TangledBoundary {
        /// A side of the chains where that is seen.
        side: [usize; 2],
    },
    /// No triangle has this point, or one that equals it, for a corner.
    UnusedPoint {
        /// The point.
        vertex: usize,
    },
    /// A corner that is an added point lies outside the hull of the input's points.
    AddedOutside {
        /// The point.
        vertex: usize,
    },
    /// The number of triangles is not what Euler's formula asks for.
    WrongCount {
        /// The number of triangles.
        triangles: usize,
        /// The number that Euler's formula asks for.
        expected: usize,
    },
    /// An input edge is not a chain of sides.
    MissingEdge {
        /// The edge.
        edge: usize,
        /// The vertex on it from which no side leads on along it.
        after: usize,
    },
    /// An input edge is a chain of sides with added points beside it.
    BentEdge {
        /// The edge.
        edge: usize,
        /// The vertex of the chain that is farthest from the edge.
        vertex: usize,
        /// Its distance from the edge, in units of the length of the edge.
        depth: Option<Depth>,
    },
    /// The boundary passes added points beside a side of the hull, or of a chain that the caller gave.
    BentBoundary {
        /// The ends of the side.
        side: [usize; 2],
        /// The vertex on the boundary that is farthest from the side; without a depth one that the boundary goes round.
        vertex: usize,
        /// Its distance from the side, in units of the length of the side.
        depth: Option<Depth>,
    },
    /// A triangle has not the attribute of the region that it lies in, or has one and lies in none.
    WrongRegion {
        /// The triangle.
        triangle: usize,
    },
    /// A side that is no input edge is not locally Delaunay.
    NotDelaunay {
        /// The side, in the direction that the first triangle has.
        side: [usize; 2],
        /// The two triangles at the side.
        triangles: [usize; 2],
        /// The corners opposite to the side; each lies inside the other triangle's circumcircle.
        opposite: [usize; 2],
        /// The depth of the corner that lies deeper, where that was measured.
        depth: Option<Depth>,
    },
    /// Cocircular sides that are not canonical, which only [`Level::Canonical`](super::Level::Canonical) asks for.
    NotCanonical {
        /// The number of these sides.
        sides: usize,
    },
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Violation::TooLarge { given, limit } => write!(
                f,
                "{given} points or corners are more than the {limit} that fit"
            ),
            Violation::NonFiniteCoordinate { vertex } => {
                write!(f, "vertex {vertex} has a coordinate that is not finite")
            }
            Violation::EdgeOutOfRange { edge, vertex } => write!(
                f,
                "edge {edge} ends at vertex {vertex}, which does not exist"
            ),
            Violation::TriangleOutOfRange { triangle, vertex } => write!(
                f,
                "triangle {triangle} has vertex {vertex}, which does not exist"
            ),
            Violation::FlatTriangle { triangle } => {
                write!(f, "triangle {triangle} has its corners on one line")
            }
            Violation::ReversedTriangle { triangle } => {
                write!(f, "triangle {triangle} runs the wrong way round")
            }
            Violation::RepeatedSide { side, triangles } => write!(
                f,
                "triangles {} and {} both lie to the left of side {}-{}",
                triangles[0], triangles[1], side[0], side[1]
            ),
            Violation::NoTriangles { vertices } => write!(
                f,
                "there are no triangles, but vertices {}, {}, {} are not on a line",
                vertices[0], vertices[1], vertices[2]
            ),
            Violation::PinchedBoundary { vertex } => {
                write!(f, "the boundary meets itself at vertex {vertex}")
            }
            Violation::ExtraBoundary { side, sides } => write!(
                f,
                "side {}-{} is on a boundary of {sides} sides that is not the hull",
                side[0], side[1]
            ),
            Violation::ConcaveBoundary { vertices, .. } => write!(
                f,
                "the boundary does not turn left at vertex {}, between {} and {}",
                vertices[1], vertices[0], vertices[2]
            ),
            Violation::WindingBoundary { times } => {
                write!(f, "the boundary goes round {times} times")
            }
            Violation::UndeclaredBoundary { side, triangle } => write!(
                f,
                "side {}-{} of triangle {triangle} is on no given boundary",
                side[0], side[1]
            ),
            Violation::MissingBoundary { side } => write!(
                f,
                "side {}-{} of a given boundary bounds no triangle",
                side[0], side[1]
            ),
            Violation::TangledBoundary { side } => write!(
                f,
                "the given boundary crosses or covers itself at side {}-{}",
                side[0], side[1]
            ),
            Violation::UnusedPoint { vertex } => write!(f, "vertex {vertex} is in no triangle"),
            Violation::AddedOutside { vertex } => {
                write!(f, "vertex {vertex} was added outside of the hull")
            }
            Violation::WrongCount {
                triangles,
                expected,
            } => write!(f, "there are {triangles} triangles, not {expected}"),
            Violation::MissingEdge { edge, after } => write!(
                f,
                "edge {edge} is no chain of sides: none follows it from vertex {after}"
            ),
            Violation::BentEdge { edge, vertex, .. } => write!(
                f,
                "edge {edge} is a chain of sides that is not straight: vertex {vertex} is beside it"
            ),
            Violation::BentBoundary { side, vertex, .. } => write!(
                f,
                "the boundary from vertex {} to {} is not straight: vertex {vertex} is beside it",
                side[0], side[1]
            ),
            Violation::WrongRegion { triangle } => write!(
                f,
                "triangle {triangle} has another attribute than the region that it lies in"
            ),
            Violation::NotDelaunay {
                side,
                triangles,
                opposite,
                ..
            } => write!(
                f,
                "side {}-{} of triangles {} and {} is not Delaunay: the circle of one holds vertex {} or {} of the other",
                side[0], side[1], triangles[0], triangles[1], opposite[0], opposite[1]
            ),
            Violation::NotCanonical { sides } => write!(
                f,
                "diagonals between vertices on one circle that do not end at the leftmost one: {sides}"
            ),
        }
    }
}

impl core::error::Error for Violation {}

impl Violation {
    /// The name of the class of violation: the variant in lower case with hyphens.
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
            Violation::TangledBoundary { .. } => "tangled-boundary",
            Violation::UnusedPoint { .. } => "unused-point",
            Violation::AddedOutside { .. } => "added-outside",
            Violation::WrongCount { .. } => "wrong-count",
            Violation::MissingEdge { .. } => "missing-edge",
            Violation::BentEdge { .. } => "bent-edge",
            Violation::BentBoundary { .. } => "bent-boundary",
            Violation::WrongRegion { .. } => "wrong-region",
            Violation::NotDelaunay { .. } => "not-delaunay",
            Violation::NotCanonical { .. } => "not-canonical",
        }
    }

    /// The depth of the fault; `None` if it has none, or none that was measured.
    ///
    /// ```
    /// use sweep_cdt::verify::verify;
    ///
    /// // One corner of a square is a little off, so that the diagonal is the wrong one.
    /// let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0 - 1e-12], [0.0, 1.0]];
    /// let violations = verify(&points, &[], &[[0, 1, 3], [1, 2, 3]]).unwrap_err();
    /// let depth = violations.list[0].depth().expect("it was measured");
    /// assert_eq!(depth.to_string(), "2.0e-12");
    /// ```
    pub fn depth(&self) -> Option<Depth> {
        match *self {
            Violation::ConcaveBoundary { depth, .. }
            | Violation::BentEdge { depth, .. }
            | Violation::BentBoundary { depth, .. }
            | Violation::NotDelaunay { depth, .. } => depth,
            _ => None,
        }
    }
}

/// The things that a [`Violation`] names, each once, in the order of its text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Offenders {
    /// Vertices.
    pub vertices: Vec<usize>,
    /// Input edges.
    pub edges: Vec<usize>,
    /// Triangles.
    pub triangles: Vec<usize>,
}

/// The kind of thing that a number in a violation is the index of.
#[derive(Clone, Copy)]
enum Kind {
    Vertex,
    Edge,
    Triangle,
}

impl Violation {
    /// The vertices, edges and triangles that the violation names.
    ///
    /// ```
    /// use sweep_cdt::verify::Violation;
    ///
    /// let violation = Violation::MissingEdge { edge: 7, after: 2 };
    /// let offenders = violation.offenders();
    /// assert_eq!((offenders.edges, offenders.vertices), (vec![7], vec![2]));
    /// ```
    pub fn offenders(mut self) -> Offenders {
        let mut found = Offenders::default();
        self.each_index(|kind, index| {
            let list = match kind {
                Kind::Vertex => &mut found.vertices,
                Kind::Edge => &mut found.edges,
                Kind::Triangle => &mut found.triangles,
            };
            if !list.contains(index) {
                list.push(*index);
            }
        });
        found
    }

    /// The violation with other numbers for vertices, edges and triangles.
    ///
    /// ```
    /// use sweep_cdt::verify::Violation;
    ///
    /// let violation = Violation::MissingEdge { edge: 7, after: 2 };
    /// let from_1 = violation.renumbered(|v| v + 1, |e| e + 1, |t| t + 1);
    /// assert_eq!(from_1, Violation::MissingEdge { edge: 8, after: 3 });
    /// ```
    #[must_use]
    pub fn renumbered(
        mut self,
        mut on_vertex: impl FnMut(usize) -> usize,
        mut on_edge: impl FnMut(usize) -> usize,
        mut on_triangle: impl FnMut(usize) -> usize,
    ) -> Violation {
        self.each_index(|kind, index| {
            *index = match kind {
                Kind::Vertex => on_vertex(*index),
                Kind::Edge => on_edge(*index),
                Kind::Triangle => on_triangle(*index),
            };
        });
        self
    }

    /// Visits the indices in the violation; counts are not indices.
    fn each_index(&mut self, mut visit: impl FnMut(Kind, &mut usize)) {
        use Violation as V;
        let (vertices, edges, triangles): (&mut [usize], &mut [usize], &mut [usize]) = match self {
            V::TooLarge { .. }
            | V::WindingBoundary { .. }
            | V::WrongCount { .. }
            | V::NotCanonical { .. } => return,
            V::NonFiniteCoordinate { vertex }
            | V::PinchedBoundary { vertex }
            | V::UnusedPoint { vertex }
            | V::AddedOutside { vertex } => (from_mut(vertex), &mut [], &mut []),
            V::FlatTriangle { triangle }
            | V::ReversedTriangle { triangle }
            | V::WrongRegion { triangle } => (&mut [], &mut [], from_mut(triangle)),
            V::EdgeOutOfRange { edge, vertex }
            | V::BentEdge { edge, vertex, .. }
            | V::MissingEdge {
                edge,
                after: vertex,
            } => (from_mut(vertex), from_mut(edge), &mut []),
            V::TriangleOutOfRange { triangle, vertex } => {
                (from_mut(vertex), &mut [], from_mut(triangle))
            }
            V::NoTriangles { vertices } | V::ConcaveBoundary { vertices, .. } => {
                (vertices, &mut [], &mut [])
            }
            V::ExtraBoundary { side, .. }
            | V::MissingBoundary { side }
            | V::TangledBoundary { side } => (side, &mut [], &mut []),
            V::BentBoundary { side, vertex, .. } => {
                side.iter_mut().for_each(|v| visit(Kind::Vertex, v));
                (from_mut(vertex), &mut [], &mut [])
            }
            V::UndeclaredBoundary { side, triangle } => (side, &mut [], from_mut(triangle)),
            V::RepeatedSide { side, triangles } => (side, &mut [], triangles),
            V::NotDelaunay {
                side,
                triangles,
                opposite,
                ..
            } => {
                side.iter_mut().for_each(|v| visit(Kind::Vertex, v));
                (opposite, &mut [], triangles)
            }
        };
        vertices.iter_mut().for_each(|v| visit(Kind::Vertex, v));
        edges.iter_mut().for_each(|e| visit(Kind::Edge, e));
        triangles.iter_mut().for_each(|t| visit(Kind::Triangle, t));
    }
}

//! The violations of a triangulation, each with its sentence; and their indices, collected or renumbered as in a file.

use alloc::vec::Vec;
use core::fmt;

use super::depth::Depth;

/// Writes the violations, each with its name, its fields and what these are numbers of, and its sentence.
macro_rules! violations {
    ($(#[$about:meta])* pub enum Violation {
        $($(#[$what:meta])* $variant:ident = $name:literal {
            $($(#[$doc:meta])* $field:ident: $type:ty = $kind:ident,)+
        } => $sentence:literal $(, $argument:expr)*;)+
    }) => {
        $(#[$about])*
        pub enum Violation {
            $($(#[$what])* $variant { $($(#[$doc])* $field: $type,)+ },)+
        }

        impl fmt::Display for Violation {
            #[expect(unused_variables, reason = "a sentence leaves out the depth")]
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    $(Violation::$variant { $($field),+ } => write!(f, $sentence $(, $argument)*),)+
                }
            }
        }

        impl Violation {
            /// The name of the class of violation: the variant in lower case with hyphens.
            pub fn name(&self) -> &'static str {
                match self {
                    $(Violation::$variant { .. } => $name,)+
                }
            }

            /// Visits the indices in the violation; counts are not indices.
            fn each_index(&mut self, mut visit: impl FnMut(Kind, &mut usize)) {
                match self {
                    $(Violation::$variant { $($field),+ } => {
                        $(violations!(@visit $kind, $field, visit);)+
                    })+
                }
            }
        }
    };
    (@visit Vertex, $field:ident, $visit:ident) => { $visit(Kind::Vertex, $field) };
    (@visit Vertices, $field:ident, $visit:ident) => { $field.iter_mut().for_each(|v| $visit(Kind::Vertex, v)) };
    (@visit Edge, $field:ident, $visit:ident) => { $visit(Kind::Edge, $field) };
    (@visit Triangle, $field:ident, $visit:ident) => { $visit(Kind::Triangle, $field) };
    (@visit Triangles, $field:ident, $visit:ident) => { $field.iter_mut().for_each(|t| $visit(Kind::Triangle, t)) };
    (@visit $other:ident, $field:ident, $visit:ident) => { let _ = $field; };
}

violations! {
    /// One fault. All numbers are indices into the caller's arrays; of equal points the lowest is named.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "kebab-case"))]
    #[non_exhaustive]
    pub enum Violation {
        /// More points or corners of triangles than the verifier can number.
        TooLarge = "too-large" {
            /// The number of points or corners given.
            given: usize = Number,
            /// The greatest number that fits.
            limit: usize = Number,
        } => "{given} points or corners are more than the {limit} that fit";
        /// A coordinate of this point is NaN or infinite.
        NonFiniteCoordinate = "non-finite-coordinate" {
            /// The point.
            vertex: usize = Vertex,
        } => "vertex {vertex} has a coordinate that is not finite";
        /// An end of this input edge is not the index of a point.
        EdgeOutOfRange = "edge-out-of-range" {
            /// The edge.
            edge: usize = Edge,
            /// The end (the first one of two).
            vertex: usize = Vertex,
        } => "edge {edge} ends at vertex {vertex}, which does not exist";
        /// A corner of this triangle is not the index of a point.
        TriangleOutOfRange = "triangle-out-of-range" {
            /// The triangle.
            triangle: usize = Triangle,
            /// The corner (the first one of several).
            vertex: usize = Vertex,
        } => "triangle {triangle} has vertex {vertex}, which does not exist";
        /// The corners of this triangle lie on one line.
        FlatTriangle = "flat-triangle" {
            /// The triangle.
            triangle: usize = Triangle,
        } => "triangle {triangle} has its corners on one line";
        /// The corners of this triangle run clockwise (or against all others, where a clockwise file was accepted).
        ReversedTriangle = "reversed-triangle" {
            /// The triangle.
            triangle: usize = Triangle,
        } => "triangle {triangle} runs the wrong way round";
        /// Two triangles lie on the same side of one side.
        RepeatedSide = "repeated-side" {
            /// The side, in the direction that both have.
            side: [usize; 2] = Vertices,
            /// The two triangles.
            triangles: [usize; 2] = Triangles,
        } => "triangles {} and {} both lie to the left of side {}-{}", triangles[0], triangles[1], side[0], side[1];
        /// There are no triangles although three points are not on one line.
        NoTriangles = "no-triangles" {
            /// Three points that are not on one line.
            vertices: [usize; 3] = Vertices,
        } => "there are no triangles, but vertices {}, {}, {} are not on a line", vertices[0], vertices[1], vertices[2];
        /// The boundary meets itself in a vertex.
        PinchedBoundary = "pinched-boundary" {
            /// The vertex.
            vertex: usize = Vertex,
        } => "the boundary meets itself at vertex {vertex}";
        /// The boundary has one more closed chain than the hull: a hole, or a second piece.
        ExtraBoundary = "extra-boundary" {
            /// A side of the chain, with a triangle on its left.
            side: [usize; 2] = Vertices,
            /// How many sides the chain has.
            sides: usize = Number,
        } => "side {}-{} is on a boundary of {sides} sides that is not the hull", side[0], side[1];
        /// The boundary turns right, or back.
        ConcaveBoundary = "concave-boundary" {
            /// Three vertices that follow each other on the boundary; it turns in the middle.
            vertices: [usize; 3] = Vertices,
            /// The depth of the turn, where that was measured.
            depth: Option<Depth> = Depth,
        } => "the boundary does not turn left at vertex {}, between {} and {}", vertices[1], vertices[0], vertices[2];
        /// The boundary turns left all the time, but goes round more than once.
        WindingBoundary = "winding-boundary" {
            /// How often the boundary goes round.
            times: usize = Number,
        } => "the boundary goes round {times} times";
        /// A side of the boundary is not in the chains that the caller gave.
        UndeclaredBoundary = "undeclared-boundary" {
            /// The side, with a triangle on its left.
            side: [usize; 2] = Vertices,
            /// The triangle.
            triangle: usize = Triangle,
        } => "side {}-{} of triangle {triangle} is on no given boundary", side[0], side[1];
        /// Two vertices that follow each other in a chain of the caller are no side of the boundary.
        MissingBoundary = "missing-boundary" {
            /// The two vertices.
            side: [usize; 2] = Vertices,
        } => "side {}-{} of a given boundary bounds no triangle", side[0], side[1];
        /// The caller's chains bound no domain: two sides cross, or they go round a place more than once or the wrong way.
        TangledBoundary = "tangled-boundary" {
            /// A side of the chains where that is seen.
            side: [usize; 2] = Vertices,
        } => "the given boundary crosses or covers itself at side {}-{}", side[0], side[1];
        /// No triangle has this point, or one that equals it, for a corner.
        UnusedPoint = "unused-point" {
            /// The point.
            vertex: usize = Vertex,
        } => "vertex {vertex} is in no triangle";
        /// A corner that is an added point lies outside the hull of the input's points.
        AddedOutside = "added-outside" {
            /// The point.
            vertex: usize = Vertex,
        } => "vertex {vertex} was added outside of the hull";
        /// The number of triangles is not what Euler's formula asks for.
        WrongCount = "wrong-count" {
            /// The number of triangles.
            triangles: usize = Number,
            /// The number that Euler's formula asks for.
            expected: usize = Number,
        } => "there are {triangles} triangles, not {expected}";
        /// An input edge is not a chain of sides.
        MissingEdge = "missing-edge" {
            /// The edge.
            edge: usize = Edge,
            /// The vertex on it from which no side leads on along it.
            after: usize = Vertex,
        } => "edge {edge} is missing: no side leads along it from vertex {after}";
        /// An input edge is a chain of sides with added points beside it.
        BentEdge = "bent-edge" {
            /// The edge.
            edge: usize = Edge,
            /// The vertex of the chain that is farthest from the edge.
            vertex: usize = Vertex,
            /// The distance of the vertex from the edge, in units of the length of the edge.
            depth: Option<Depth> = Depth,
        } => "edge {edge} is a chain of sides that is not straight: vertex {vertex} is beside it";
        /// The boundary passes added points beside a side of the hull, or of a chain that the caller gave.
        BentBoundary = "bent-boundary" {
            /// The ends of the side.
            side: [usize; 2] = Vertices,
            /// The vertex on the boundary that is farthest from the side; without a depth one that the boundary goes round.
            vertex: usize = Vertex,
            /// The distance of the vertex from the side, in units of the length of the side.
            depth: Option<Depth> = Depth,
        } => "the boundary from vertex {} to {} is not straight: vertex {vertex} is beside it", side[0], side[1];
        /// A triangle has not the attribute of the region that it lies in, or has one and lies in none.
        WrongRegion = "wrong-region" {
            /// The triangle.
            triangle: usize = Triangle,
        } => "triangle {triangle} has another attribute than the region that it lies in";
        /// A side that is no input edge is not locally Delaunay.
        NotDelaunay = "not-delaunay" {
            /// The side, in the direction that the first triangle has.
            side: [usize; 2] = Vertices,
            /// The two triangles at the side.
            triangles: [usize; 2] = Triangles,
            /// The corners opposite to the side; each lies inside the other triangle's circumcircle.
            opposite: [usize; 2] = Vertices,
            /// The depth of the corner that lies deeper, where that was measured.
            depth: Option<Depth> = Depth,
        } => "side {}-{} of triangles {} and {} is not Delaunay: the circle of one holds vertex {} or {} of the other",
            side[0], side[1], triangles[0], triangles[1], opposite[0], opposite[1];
        /// Cocircular sides that are not canonical, which only [`Level::Canonical`](super::Level::Canonical) asks for.
        NotCanonical = "not-canonical" {
            /// The number of these sides.
            sides: usize = Number,
        } => "diagonals between vertices on one circle that do not end at the leftmost one: {sides}";
    }
}

impl core::error::Error for Violation {}

impl Violation {
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
}

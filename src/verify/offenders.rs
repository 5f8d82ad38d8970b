//! The numbers in a violation: collected, or replaced by those of another numbering.

use super::report::Violation;

/// What a [`Violation`] names, each thing once, in the order of its text.
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

impl Violation {
    /// What it names.
    ///
    /// ```
    /// use sweep_cdt::verify::Violation;
    ///
    /// let violation = Violation::MissingEdge { edge: 7, after: 2 };
    /// let offenders = violation.offenders();
    /// assert_eq!((offenders.edges, offenders.vertices), (vec![7], vec![2]));
    /// ```
    pub fn offenders(self) -> Offenders {
        let mut found = Offenders::default();
        let note = |list: &mut Vec<usize>, number| {
            if !list.contains(&number) {
                list.push(number);
            }
            number
        };
        self.renumbered(
            |vertex| note(&mut found.vertices, vertex),
            |edge| note(&mut found.edges, edge),
            |triangle| note(&mut found.triangles, triangle),
        );
        found
    }

    /// The same violation with other numbers for vertices, edges and triangles.
    ///
    /// ```
    /// use sweep_cdt::verify::Violation;
    ///
    /// let violation = Violation::MissingEdge { edge: 7, after: 2 };
    /// let from_1 = violation.renumbered(|v| v + 1, |e| e + 1, |t| t + 1);
    /// assert_eq!(from_1, Violation::MissingEdge { edge: 8, after: 3 });
    /// ```
    pub fn renumbered(
        self,
        mut on_vertex: impl FnMut(usize) -> usize,
        mut on_edge: impl FnMut(usize) -> usize,
        mut on_triangle: impl FnMut(usize) -> usize,
    ) -> Violation {
        use Violation as V;
        match self {
            V::TooLarge { .. } | V::WindingBoundary { .. } | V::WrongCount { .. } => self,
            V::NonFiniteCoordinate { vertex } => V::NonFiniteCoordinate {
                vertex: on_vertex(vertex),
            },
            V::EdgeOutOfRange { edge, vertex } => V::EdgeOutOfRange {
                edge: on_edge(edge),
                vertex: on_vertex(vertex),
            },
            V::TriangleOutOfRange { triangle, vertex } => V::TriangleOutOfRange {
                triangle: on_triangle(triangle),
                vertex: on_vertex(vertex),
            },
            V::FlatTriangle { triangle } => V::FlatTriangle {
                triangle: on_triangle(triangle),
            },
            V::ReversedTriangle { triangle } => V::ReversedTriangle {
                triangle: on_triangle(triangle),
            },
            V::RepeatedSide { side, triangles } => V::RepeatedSide {
                side: side.map(on_vertex),
                triangles: triangles.map(on_triangle),
            },
            V::NoTriangles { vertices } => V::NoTriangles {
                vertices: vertices.map(on_vertex),
            },
            V::PinchedBoundary { vertex } => V::PinchedBoundary {
                vertex: on_vertex(vertex),
            },
            V::ExtraBoundary { side, sides } => V::ExtraBoundary {
                side: side.map(on_vertex),
                sides,
            },
            V::ConcaveBoundary { vertices } => V::ConcaveBoundary {
                vertices: vertices.map(on_vertex),
            },
            V::UndeclaredBoundary { side, triangle } => V::UndeclaredBoundary {
                side: side.map(on_vertex),
                triangle: on_triangle(triangle),
            },
            V::MissingBoundary { side } => V::MissingBoundary {
                side: side.map(on_vertex),
            },
            V::UnusedPoint { vertex } => V::UnusedPoint {
                vertex: on_vertex(vertex),
            },
            V::MissingEdge { edge, after } => V::MissingEdge {
                edge: on_edge(edge),
                after: on_vertex(after),
            },
            V::NotDelaunay {
                side,
                triangles,
                opposite,
            } => V::NotDelaunay {
                side: side.map(&mut on_vertex),
                triangles: triangles.map(on_triangle),
                opposite: opposite.map(on_vertex),
            },
        }
    }
}

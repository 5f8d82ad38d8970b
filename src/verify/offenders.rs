//! The indices in a violation: collected, or replaced by the numbers of a file.

use std::slice::from_mut;

use super::violation::Violation;

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

/// What a number in a violation is the index of.
#[derive(Clone, Copy)]
enum Kind {
    Vertex,
    Edge,
    Triangle,
}

impl Violation {
    /// The vertices, edges and triangles that it names.
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

    /// The same violation with other numbers for vertices, edges and triangles.
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

    /// Visits the indices in it; counts are not indices.
    fn each_index(&mut self, mut visit: impl FnMut(Kind, &mut usize)) {
        use Violation as V;
        let (vertices, edges, triangles): (&mut [usize], &mut [usize], &mut [usize]) = match self {
            V::TooLarge { .. }
            | V::WindingBoundary { .. }
            | V::WrongCount { .. }
            | V::NotCanonical { .. } => return,
            V::NonFiniteCoordinate { vertex }
            | V::PinchedBoundary { vertex }
            | V::UnusedPoint { vertex } => (from_mut(vertex), &mut [], &mut []),
            V::FlatTriangle { triangle } | V::ReversedTriangle { triangle } => {
                (&mut [], &mut [], from_mut(triangle))
            }
            V::EdgeOutOfRange { edge, vertex }
            | V::MissingEdge {
                edge,
                after: vertex,
            } => (from_mut(vertex), from_mut(edge), &mut []),
            V::TriangleOutOfRange { triangle, vertex } => {
                (from_mut(vertex), &mut [], from_mut(triangle))
            }
            V::NoTriangles { vertices } | V::ConcaveBoundary { vertices } => {
                (vertices, &mut [], &mut [])
            }
            V::ExtraBoundary { side, .. }
            | V::MissingBoundary { side }
            | V::TangledBoundary { side } => (side, &mut [], &mut []),
            V::UndeclaredBoundary { side, triangle } => (side, &mut [], from_mut(triangle)),
            V::RepeatedSide { side, triangles } => (side, &mut [], triangles),
            V::NotDelaunay {
                side,
                triangles,
                opposite,
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

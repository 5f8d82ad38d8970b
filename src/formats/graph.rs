//! A planar straight-line graph as it stands in a file: vertices, edges, and how the file counts them.

use crate::Error;

/// Vertices and edges in the file's order, edges as positions in `points`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Graph<S> {
    /// The vertices.
    pub points: Vec<[S; 2]>,
    /// The edges, as positions in `points`.
    pub edges: Vec<[usize; 2]>,
    /// The file's number of the first vertex: 0 or 1.
    pub first_vertex: usize,
    /// The file's number of the first edge: 0 or 1.
    pub first_edge: usize,
}

impl<S> Graph<S> {
    /// The same error with vertices and edges numbered as in the file.
    ///
    /// ```
    /// use sweep_cdt::{Error, formats::Graph};
    ///
    /// let graph = Graph::<f64> { first_edge: 1, ..Graph::default() };
    /// let error = graph.as_numbered(Error::CrossingEdges { edges: [0, 1] });
    /// assert_eq!(error.to_string(), "edges 1 and 2 cross");
    /// ```
    pub fn as_numbered(&self, error: Error) -> Error {
        let vertex_number = |vertex: usize| vertex.saturating_add(self.first_vertex);
        let edge_number = |edge: usize| edge.saturating_add(self.first_edge);
        match error {
            Error::NonFiniteCoordinate { vertex } => Error::NonFiniteCoordinate {
                vertex: vertex_number(vertex),
            },
            Error::EdgeOutOfRange { edge, vertex } => Error::EdgeOutOfRange {
                edge: edge_number(edge),
                vertex: vertex_number(vertex),
            },
            Error::CrossingEdges { edges } => Error::CrossingEdges {
                edges: edges.map(edge_number),
            },
            Error::TooManyPoints { .. }
            | Error::TooManyEdges { .. }
            | Error::TooManyVerticesOnEdges { .. } => error,
        }
    }
}

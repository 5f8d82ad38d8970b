//! Triangle's `.ele`, and the `.node` that it refers to.

use std::io::{self, Write};

use super::rows::{self, number};
use crate::Triangulation;
use crate::formats::{Coordinate, Graph};

/// Writes the triangles with the vertices' numbers of the input.
pub(super) fn write<S>(
    graph: &Graph<S>,
    result: &Triangulation,
    out: &mut impl Write,
) -> io::Result<()> {
    let first = graph.first_vertex;
    writeln!(out, "{} 3 0", result.len())?;
    let triangles = result.canonical_triangles();
    rows::write(out, triangles.len(), |t, text| {
        number(t + first, text);
        for corner in triangles[t] {
            text.push(b' ');
            number(corner + first, text);
        }
        text.push(b'\n');
    })
}

/// Writes the vertices as a `.node`.
///
/// ```
/// use sweep_cdt::formats::{Graph, write_node};
///
/// let graph = Graph { points: vec![[0.5, 2.0]], first_vertex: 1, ..Graph::default() };
/// let mut text = Vec::new();
/// write_node(&graph, &mut text)?;
/// assert_eq!(text, b"1 2 0 0\n1 0.5 2\n");
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// # Errors
/// Those of `out`.
pub fn write_node<S: Coordinate>(graph: &Graph<S>, out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "{} 2 0 0", graph.points.len())?;
    rows::write(out, graph.points.len(), |vertex, text| {
        number(vertex + graph.first_vertex, text);
        for coordinate in &graph.points[vertex] {
            text.push(b' ');
            coordinate.write_text(text);
        }
        text.push(b'\n');
    })
}

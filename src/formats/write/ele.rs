//! Triangle's `.ele`, and the `.node` that it refers to.

use std::io::{self, Write};

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
    for (t, [a, b, c]) in result.canonical_triangles().into_iter().enumerate() {
        writeln!(
            out,
            "{} {} {} {}",
            t + first,
            a + first,
            b + first,
            c + first
        )?;
    }
    Ok(())
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
    for (vertex, [x, y]) in graph.points.iter().enumerate() {
        writeln!(
            out,
            "{} {} {}",
            vertex + graph.first_vertex,
            x.text(),
            y.text()
        )?;
    }
    Ok(())
}

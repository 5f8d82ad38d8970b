//! Triangle's `.ele`, and the `.node` that it refers to.

use std::io::{self, Write};

use super::places::places;
use super::rows::{self, number};
use crate::domain::Domain;
use crate::formats::{Coordinate, Graph};

/// Writes the triangles inside with the vertices' numbers of the input, and, if the domain has regions, with the
/// attributes of these.
pub(super) fn write<S>(
    graph: &Graph<S>,
    domain: &Domain<'_>,
    out: &mut impl Write,
) -> io::Result<()> {
    let first = graph.first_vertex;
    let triangles = domain.canonical_triangles();
    let attributes = attributes(graph, domain, &triangles);
    let columns = u8::from(!attributes.is_empty());
    writeln!(out, "{} 3 {columns}", triangles.len())?;
    rows::write(out, triangles.len(), |t, text| {
        number(t + first, text);
        for corner in triangles[t] {
            text.push(b' ');
            number(corner + first, text);
        }
        if let Some(attribute) = attributes.get(t) {
            text.push(b' ');
            attribute.write_text(text);
        }
        text.push(b'\n');
    })
}

/// The attribute of each triangle in the list, 0 without a region; nothing if there are no regions.
fn attributes<S>(graph: &Graph<S>, domain: &Domain<'_>, triangles: &[[usize; 3]]) -> Vec<f64> {
    if !domain.has_regions() {
        return Vec::new();
    }
    let mut attributes = vec![0.0; triangles.len()];
    for (t, place) in places(domain, triangles).into_iter().enumerate() {
        let region = domain
            .region(t)
            .and_then(|region| graph.regions.get(region));
        if let (Some((place, _)), Some(region)) = (place, region) {
            attributes[place] = region.attribute;
        }
    }
    attributes
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

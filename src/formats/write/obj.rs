//! Wavefront's `.obj`: vertices with z = 0, and faces numbered from 1 as that format asks.

use std::io::{self, Write};

use super::rows::{self, number};
use crate::domain::Domain;
use crate::formats::{Coordinate, Graph};

/// Writes vertices (rationals rounded to doubles) and the triangles inside.
pub(super) fn write<S: Coordinate>(
    graph: &Graph<S>,
    domain: &Domain<'_>,
    out: &mut impl Write,
) -> io::Result<()> {
    rows::write(out, graph.points.len(), |vertex, text| {
        text.push(b'v');
        for coordinate in &graph.points[vertex] {
            text.push(b' ');
            coordinate.approx().write_text(text);
        }
        text.extend_from_slice(b" 0\n");
    })?;
    let triangles = domain.canonical_triangles();
    rows::write(out, triangles.len(), |t, text| {
        text.push(b'f');
        for corner in triangles[t] {
            text.push(b' ');
            number(corner + 1, text);
        }
        text.push(b'\n');
    })
}

//! Wavefront's `.obj`: vertices with z = 0, and faces numbered from 1 as that format asks.

use std::io::{self, Write};

use crate::Triangulation;
use crate::formats::{Coordinate, Graph};

/// Writes vertices (rationals rounded to doubles) and triangles.
pub(super) fn write<S: Coordinate>(
    graph: &Graph<S>,
    result: &Triangulation,
    out: &mut impl Write,
) -> io::Result<()> {
    for [x, y] in &graph.points {
        writeln!(out, "v {} {} 0", x.approx().text(), y.approx().text())?;
    }
    for [a, b, c] in result.canonical_triangles() {
        writeln!(out, "f {} {} {}", a + 1, b + 1, c + 1)?;
    }
    Ok(())
}

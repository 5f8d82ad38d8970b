//! Triangle's `.node` and `.poly`.
//!
//! ```text
//! .node    <vertices> 2 <attributes> <markers>        counts; only the first one is needed
//!          <vertex> <x> <y> [attributes] [marker]     numbered from 0 or from 1
//!
//! .poly    as .node; 0 vertices: they are in the .node beside it
//!          <segments> <markers>
//!          <segment> <vertex> <vertex> [marker]       numbered from 0 or from 1
//!          <holes>                                    this line and all after it may be left out
//!          <hole> <x> <y>                             a point in the hole; numbered from 0 or from 1
//!          <regions>                                  this line and all after it may be left out
//!          <region> <x> <y> [attribute] [area]        a point in the region; numbered from 0 or from 1
//! ```
//!
//! Attributes and markers of vertices and edges are ignored, and so are the areas of regions, which limit
//! triangles where a mesh is refined. A region without an attribute has 0.

use crate::formats::read::content::{Edges, Syntax, Vertices};
use crate::formats::read::records::Records;
use crate::formats::read::seeds;
use crate::formats::read::source::{ReadError, Source, no_vertex, quoted};
use crate::formats::read::token_lines::{Line, Lines};

/// Reads a `.node`.
pub(super) fn read_node(source: &Source) -> Result<Vertices<'_>, ReadError> {
    let mut lines = Lines::new(source)?;
    let count = vertex_count(&mut lines)?;
    let vertices = read_vertices(source, &mut lines, count)?;
    match lines.next_line() {
        Some(line) => Err(line.error(format!("the first line announces only {count} vertices"))),
        None => Ok(vertices),
    }
}

/// Reads a `.poly`; `node` is where its vertices are if it holds none.
pub(super) fn read_poly<'a>(
    source: &'a Source,
    node: Option<&'a Source>,
) -> Result<Edges<'a>, ReadError> {
    // The vertices, here or in the `.node`.
    let mut lines = Lines::new(source)?;
    let vertices = match (vertex_count(&mut lines)?, node) {
        (0, Some(node)) => read_node(node)?,
        (0, None) => {
            return Err(ReadError {
                missing_node: true,
                ..ReadError::of_file(&source.name, "no vertices, and no .node beside it")
            });
        }
        (count, _) => read_vertices(source, &mut lines, count)?,
    };

    // The edges.
    let count = lines
        .expect_line(|| "the number of edges".to_owned())?
        .index("a number of edges")?;
    let records = Records {
        name: "edge",
        number: "an edge's number",
        count,
    };
    let mut first = vertices.first;
    let edges = records.read(&mut lines, &mut first, |line| {
        Ok([end(line, &vertices)?, end(line, &vertices)?])
    })?;

    // Holes and regions, if the file goes on.
    let holes = seeds::read_holes(source, &mut lines, vertices.first)?;
    let (regions, attributes) = seeds::read_regions(source, &mut lines, vertices.first)?;
    Ok(Edges {
        vertices,
        edges,
        first,
        holes,
        regions,
        attributes,
    })
}

/// The number of vertices from the first line.
fn vertex_count(lines: &mut Lines<'_>) -> Result<usize, ReadError> {
    let mut line = lines.expect_line(|| "the number of vertices".to_owned())?;
    let count = line.index("a number of vertices")?;
    match line.token() {
        None | Some(b"2") => Ok(count),
        Some(b"3") => Err(line.error(
            "3 coordinates are announced, and only x and y are read: leave out z and announce 2",
        )),
        Some(other) => Err(line.error(format!(
            "{} is not 2, the number of coordinates",
            quoted(other)
        ))),
    }
}

fn read_vertices<'a>(
    source: &'a Source,
    lines: &mut Lines<'a>,
    count: usize,
) -> Result<Vertices<'a>, ReadError> {
    let records = Records {
        name: "vertex",
        number: "a vertex's number",
        count,
    };
    let mut first = 0;
    let coordinates = records.read(lines, &mut first, Line::coordinates)?;
    Ok(Vertices {
        source,
        syntax: Syntax::Plain,
        coordinates,
        first,
    })
}

/// Reads an end of an edge.
fn end(line: &mut Line<'_>, vertices: &Vertices<'_>) -> Result<usize, ReadError> {
    let number = line.index("a vertex's number")?;
    number
        .checked_sub(vertices.first)
        .filter(|&vertex| vertex < vertices.coordinates.len())
        .ok_or_else(|| {
            let (first, count) = (vertices.first, vertices.coordinates.len());
            line.error(no_vertex(number, first, count))
        })
}

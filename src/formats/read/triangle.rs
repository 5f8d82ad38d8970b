//! Triangle's `.node` and `.poly`.
//!
//! ```text
//! .node    <vertices> 2 <attributes> <markers>        counts; only the first one is needed
//!          <vertex> <x> <y> [attributes] [marker]     numbered from 0 or from 1
//!
//! .poly    as .node; 0 vertices: they are in the .node beside it
//!          <segments> <markers>
//!          <segment> <vertex> <vertex> [marker]       numbered from 0 or from 1
//!          holes and regions                          not read
//! ```
//!
//! Attributes and markers are ignored. The numbers of vertices and edges must be consecutive, since messages
//! use them. (Triangle itself ignores these numbers.)

use crate::formats::read::content::{Edges, Syntax, Vertices};
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

    // The edges. Holes and regions after them are not read.
    let count = lines
        .expect_line(|| "the number of edges".to_owned())?
        .index("a number of edges")?;
    let mut edges = Vec::with_capacity(lines.capacity(count));
    let mut first = vertices.first;
    for edge in 0..count {
        let mut line = lines.expect_line(|| format!("edge {} of {count}", edge + 1))?;
        numbered(&mut line, edge, &mut first, "an edge's number")?;
        edges.push([end(&mut line, &vertices)?, end(&mut line, &vertices)?]);
    }
    Ok(Edges {
        vertices,
        edges,
        first,
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
    let mut coordinates = Vec::with_capacity(lines.capacity(count));
    let mut first = 0;
    for vertex in 0..count {
        let mut line = lines.expect_line(|| format!("vertex {} of {count}", vertex + 1))?;
        numbered(&mut line, vertex, &mut first, "a vertex's number")?;
        coordinates.push(line.coordinates()?);
    }
    Ok(Vertices {
        source,
        syntax: Syntax::Plain,
        coordinates,
        first,
    })
}

/// Reads the number of record `at`, counted from 0. The number of the first record must be 0 or 1.
pub(super) fn numbered(
    line: &mut Line<'_>,
    at: usize,
    first: &mut usize,
    what: &str,
) -> Result<(), ReadError> {
    let number = line.index(what)?;
    if at == 0 && number <= 1 {
        *first = number;
    }
    match at + *first {
        expected if expected == number => Ok(()),
        _ if at == 0 => Err(line.error(format!("the first number is {number}, not 0 or 1"))),
        expected => Err(line.error(format!("the number is {number}, not {expected}"))),
    }
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

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
//! Attributes and markers are read over. Stricter than Triangle, which reads past them: numbers must
//! be consecutive, since messages name vertices and edges by them.

use crate::formats::read::lines::{Line, Lines};
use crate::formats::read::{ReadError, Source, Stop};
use crate::formats::{Coordinate, Graph};

/// Reads a `.node`.
pub(super) fn read_node<S: Coordinate>(source: &Source) -> Result<Graph<S>, Stop> {
    let mut lines = Lines::new(source);
    let count = vertex_count(&mut lines)?;
    let graph = vertices(&mut lines, count)?;
    match lines.next_line() {
        Some(line) => Err(line
            .error(format!("the first line announces only {count} vertices"))
            .into()),
        None => Ok(graph),
    }
}

/// Reads a `.poly`; `node` is where its vertices are if it holds none.
pub(super) fn read_poly<S: Coordinate>(
    source: &Source,
    node: Option<&Source>,
) -> Result<Graph<S>, Stop> {
    let mut lines = Lines::new(source);
    let count = vertex_count(&mut lines)?;
    let mut graph = match node {
        Some(node) => read_node(node)?,
        None => vertices(&mut lines, count)?,
    };
    let count = lines
        .expect_line(|| "the number of edges".to_owned())?
        .index("a number of edges")?;
    graph.edges.reserve(lines.capacity(count));
    for edge in 0..count {
        let mut line = lines.expect_line(|| format!("edge {} of {count}", edge + 1))?;
        numbered(&mut line, edge, &mut graph.first_edge, "an edge's number")?;
        let ends = [end(&mut line, &graph)?, end(&mut line, &graph)?];
        graph.edges.push(ends);
    }
    Ok(graph)
}

/// Whether a `.poly` leaves its vertices to the `.node` beside it.
pub(super) fn has_no_vertices(source: &Source) -> Result<bool, ReadError> {
    Ok(vertex_count(&mut Lines::new(source))? == 0)
}

/// The number of vertices from the first line.
fn vertex_count(lines: &mut Lines<'_>) -> Result<usize, ReadError> {
    let mut line = lines.expect_line(|| "the number of vertices".to_owned())?;
    let count = line.index("a number of vertices")?;
    match line.token() {
        None | Some(b"2") => Ok(count),
        Some(_) => Err(line.error("only 2 dimensions are read".to_owned())),
    }
}

fn vertices<S: Coordinate>(lines: &mut Lines<'_>, count: usize) -> Result<Graph<S>, Stop> {
    let mut points = Vec::with_capacity(lines.capacity(count));
    let mut first_vertex = 0;
    for vertex in 0..count {
        let mut line = lines.expect_line(|| format!("vertex {} of {count}", vertex + 1))?;
        numbered(&mut line, vertex, &mut first_vertex, "a vertex's number")?;
        points.push([
            line.coordinate("an x coordinate")?,
            line.coordinate("a y coordinate")?,
        ]);
    }
    Ok(Graph {
        points,
        edges: Vec::new(),
        first_vertex,
        first_edge: first_vertex,
    })
}

/// Reads the number of record `at`, which for the first one tells where the file's numbers begin.
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
fn end<S>(line: &mut Line<'_>, graph: &Graph<S>) -> Result<usize, ReadError> {
    let number = line.index("a vertex's number")?;
    number
        .checked_sub(graph.first_vertex)
        .filter(|&vertex| vertex < graph.points.len())
        .ok_or_else(|| line.error(format!("vertex {number} does not exist")))
}

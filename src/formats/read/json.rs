//! JSON: an object with `points`, pairs of coordinates, and `edges`, pairs of positions in `points`. Of
//! a result only `triangles` is read: triples of positions in the input's points, or all of them in one
//! list.
//!
//! A coordinate is a number, or a string for what a JSON number cannot be: `"2/3"`, `"nan"`, `"inf"`,
//! `"-inf"`. Other members are ignored.

use serde::Deserialize;
use serde_json::value::RawValue;

use crate::formats::read::content::{Corners, Edges, Syntax, Vertices};
use crate::formats::read::source::{ReadError, Source};

#[derive(Deserialize)]
struct Document<'a> {
    #[serde(borrow)]
    points: Vec<[&'a RawValue; 2]>,
    #[serde(default)]
    edges: Vec<[usize; 2]>,
}

#[derive(Deserialize)]
struct Triples {
    triangles: Vec<[usize; 3]>,
}

#[derive(Deserialize)]
struct Flat {
    triangles: Vec<usize>,
}

/// Reads a `.json` with a graph.
pub(super) fn read(source: &Source) -> Result<Edges<'_>, ReadError> {
    let Document { points, edges } =
        serde_json::from_slice(&source.bytes).map_err(|error| unreadable(source, &error))?;
    let coordinates = points
        .into_iter()
        .map(|point| point.map(|raw| raw.get().as_bytes()))
        .collect();
    let vertices = Vertices {
        source,
        syntax: Syntax::Json,
        coordinates,
        first: 0,
    };
    Ok(Edges {
        vertices,
        edges,
        first: 0,
    })
}

/// Reads a `.json` with triangles.
pub(super) fn read_triangles(source: &Source) -> Result<Corners<'_>, ReadError> {
    let triangles = serde_json::from_slice(&source.bytes)
        .map(|Triples { triangles }| triangles)
        .or_else(|error| flat(source).ok_or_else(|| unreadable(source, &error)))?;
    Ok(Corners {
        triangles,
        first: 0,
        first_vertex: 0,
        vertices: None,
    })
}

/// The triangles, where all corners stand in one list, three for each.
fn flat(source: &Source) -> Option<Vec<[usize; 3]>> {
    let Flat { triangles: corners } = serde_json::from_slice(&source.bytes).ok()?;
    let (triangles, rest) = corners.as_chunks();
    rest.is_empty().then(|| triangles.to_vec())
}

/// The error that serde reports, with its line and column.
fn unreadable(source: &Source, error: &serde_json::Error) -> ReadError {
    let (line, column) = (error.line(), error.column());
    let message = error.to_string();
    let message = message
        .strip_suffix(&format!(" at line {line} column {column}"))
        .unwrap_or(&message);
    ReadError {
        line: Some(line).filter(|&line| line > 0),
        column: Some(column).filter(|&column| column > 0),
        ..ReadError::of_file(&source.name, message)
    }
}

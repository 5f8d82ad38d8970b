//! JSON: an object with `points`, pairs of coordinates, and `edges`, pairs of positions in `points`; of
//! a result only `triangles`, triples of positions in the input's points, or all of them in one list.
//!
//! A coordinate is a number, or a string with what JSON has no numbers for: `"2/3"`, `"nan"`, `"inf"`,
//! `"-inf"`. Other members are ignored. Numbers are kept as text until all is read, so that each is
//! converted once and exactly.

use serde::Deserialize;
use serde_json::value::RawValue;

use crate::formats::read::result::Content;
use crate::formats::read::{ReadError, Source, Stop, coordinate};
use crate::formats::{Coordinate, Graph};

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
pub(super) fn read<S: Coordinate>(source: &Source) -> Result<Graph<S>, Stop> {
    let Document { points, edges } =
        serde_json::from_slice(&source.bytes).map_err(|error| unreadable(source, &error))?;
    let value = |raw: &RawValue| {
        let text = raw.get();
        let string = text
            .starts_with('"')
            .then(|| serde_json::from_str::<String>(text).ok())
            .flatten();
        coordinate(string.as_deref().unwrap_or(text).as_bytes(), |message| {
            let (line, column) = position(source, text);
            at(source, line, column, &message)
        })
    };
    let points = points
        .into_iter()
        .map(|[x, y]| Ok([value(x)?, value(y)?]))
        .collect::<Result<Vec<[S; 2]>, Stop>>()?;
    Ok(Graph {
        points,
        edges,
        first_vertex: 0,
        first_edge: 0,
    })
}

/// Reads a `.json` with triangles.
pub(super) fn read_triangles<S>(source: &Source) -> Result<Content<S>, Stop> {
    let triangles = serde_json::from_slice(&source.bytes)
        .map(|Triples { triangles }| triangles)
        .or_else(|error| flat(source).ok_or_else(|| unreadable(source, &error)))?;
    Ok(Content {
        triangles,
        first_triangle: 0,
        first_vertex: 0,
        points: None,
    })
}

/// The triangles where three corners after the other stand in one list.
fn flat(source: &Source) -> Option<Vec<[usize; 3]>> {
    let Flat { triangles: corners } = serde_json::from_slice(&source.bytes).ok()?;
    let (triangles, rest) = corners.as_chunks();
    rest.is_empty().then(|| triangles.to_vec())
}

/// Line and column of a piece of the source.
fn position(source: &Source, piece: &str) -> (usize, usize) {
    let offset = piece.as_ptr().addr() - source.bytes.as_ptr().addr();
    let before = &source.bytes[..offset];
    let line_start = before
        .iter()
        .rposition(|&byte| byte == b'\n')
        .map_or(0, |end| end + 1);
    let line = before.iter().filter(|&&byte| byte == b'\n').count() + 1;
    (line, offset - line_start + 1)
}

fn unreadable(source: &Source, error: &serde_json::Error) -> ReadError {
    at(source, error.line(), error.column(), &error.to_string())
}

fn at(source: &Source, line: usize, column: usize, message: &str) -> ReadError {
    let message = message
        .strip_suffix(&format!(" at line {line} column {column}"))
        .unwrap_or(message);
    ReadError {
        line: Some(line).filter(|&line| line > 0),
        column: Some(column).filter(|&column| column > 0),
        ..ReadError::of_file(&source.name, message)
    }
}

//! JSON: an object with `points`, pairs of coordinates, and `edges`, pairs of positions in `points`. Of
//! a result only `triangles` is read: triples of positions in the input's points, or all of them in one
//! list.
//!
//! A coordinate is a number, or a string for what a JSON number cannot be: `"2/3"`, `"nan"`, `"inf"`,
//! `"-inf"`. Other members are ignored.

use serde::Deserialize;
use serde_json::value::RawValue;

use crate::formats::read::content::{Corners, Edges, Syntax, Vertices};
use crate::formats::read::json_faults;
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
        object(source)?.map_err(|error| json_faults::of_graph(source, &error))?;
    let exists = |edge: &[usize; 2]| edge.iter().all(|&vertex| vertex < points.len());
    if !edges.iter().all(exists) {
        return Err(json_faults::of_ends(source, &edges, points.len()));
    }
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
    let triangles = object(source)?
        .map(|Triples { triangles }| triangles)
        .or_else(|error| flat(source).ok_or_else(|| json_faults::of_triangles(source, &error)))?;
    Ok(Corners {
        triangles,
        first: 0,
        first_vertex: 0,
        vertices: None,
    })
}

/// The triangles, where all corners stand in one list, three for each.
fn flat(source: &Source) -> Option<Vec<[usize; 3]>> {
    let Flat { triangles: corners } = object(source).ok()?.ok()?;
    let (triangles, rest) = corners.as_chunks();
    rest.is_empty().then(|| triangles.to_vec())
}

/// Members of the object in a file. The names of structures that they are read to stand in no message.
fn object<'a, T: Deserialize<'a>>(
    source: &'a Source,
) -> Result<Result<T, serde_json::Error>, ReadError> {
    let text = source.text()?;
    // Serde would take a list for an object without names.
    if text.trim_ascii_start().starts_with(b"[") {
        return Err(json_faults::of_list(source));
    }
    Ok(serde_json::from_slice(text))
}

//! JSON: an object with `points`, pairs of coordinates, and `edges`, pairs of positions in `points`. Of
//! a result `triangles` is read, triples of positions in its points or all of them in one list, and
//! `points`, if it has any; otherwise they are those of the input.
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

/// Triples of corners, or single ones.
#[derive(Deserialize)]
#[serde(bound(deserialize = "T: Deserialize<'de>"))]
struct Answer<'a, T> {
    #[serde(borrow, default)]
    points: Option<Vec<[&'a RawValue; 2]>>,
    triangles: Vec<T>,
}

/// Reads a `.json` with a graph.
pub(super) fn read(source: &Source) -> Result<Edges<'_>, ReadError> {
    let Document { points, edges } =
        object(source)?.map_err(|error| json_faults::of_graph(source, &error))?;
    let exists = |edge: &[usize; 2]| edge.iter().all(|&vertex| vertex < points.len());
    if !edges.iter().all(exists) {
        return Err(json_faults::of_ends(source, &edges, points.len()));
    }
    Ok(Edges::without_seeds(vertices(source, points), edges, 0))
}

/// Reads a `.json` with triangles.
pub(super) fn read_triangles(source: &Source) -> Result<Corners<'_>, ReadError> {
    let Answer { points, triangles } = object(source)?
        .or_else(|error| flat(source).ok_or_else(|| json_faults::of_triangles(source, &error)))?;
    Ok(Corners {
        triangles,
        first: 0,
        first_vertex: 0,
        vertices: points.map(|points| vertices(source, points)),
    })
}

/// The result, where all corners stand in one list, three for each triangle.
fn flat(source: &Source) -> Option<Answer<'_, [usize; 3]>> {
    let answer: Answer<'_, usize> = object(source).ok()?.ok()?;
    let (triangles, rest) = answer.triangles.as_chunks();
    rest.is_empty().then(|| Answer {
        points: answer.points,
        triangles: triangles.to_vec(),
    })
}

/// The vertices of a file that has these points.
fn vertices<'a>(source: &'a Source, points: Vec<[&'a RawValue; 2]>) -> Vertices<'a> {
    Vertices {
        source,
        syntax: Syntax::Json,
        coordinates: points
            .into_iter()
            .map(|point| point.map(|raw| raw.get().as_bytes()))
            .collect(),
        first: 0,
    }
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

//! JSON: an object with `points`, pairs of coordinates with or without a height, and `edges`, pairs of positions in
//! `points`. Of a result `triangles` is read, triples of positions in its points or all of them in one list, and
//! `points`, if it has any; otherwise they are those of the input.
//!
//! A result may have `regions`, for each triangle a position in those of the input, or `null`.
//!
//! Other programs call these lists `vertices`, `segments`, and `simplices` or `faces`, which are read too.
//!
//! An input may have more, as Triangle has it (see `more.rs`).
//!
//! A coordinate is a number, or a string for what a JSON number cannot be: `"2/3"`, `"nan"`, `"inf"`,
//! `"-inf"`. Other members are ignored, with a remark in an input.
//!
//! A file without `points` that has a `type` of `GeoJSON` is read as that format.

mod faults;
mod more;
pub(super) mod pieces;

use crate::read::content::{Corners, Edges, Labels, Syntax, Vertices};
use crate::read::json::pieces::Position;
use crate::read::source::{ReadError, Source};
use serde::Deserialize;
use serde_json::value::RawValue;

#[derive(Deserialize)]
struct Document<'a> {
    #[serde(borrow, alias = "vertices")]
    points: Vec<Position<'a>>,
    #[serde(default, alias = "segments")]
    edges: Vec<[usize; 2]>,
}

/// Triples of corners, or single ones.
#[derive(Deserialize)]
#[serde(bound(deserialize = "T: Deserialize<'de>"))]
struct Answer<'a, T> {
    #[serde(borrow, default, alias = "vertices")]
    points: Option<Vec<Position<'a>>>,
    #[serde(alias = "simplices", alias = "faces")]
    triangles: Vec<T>,
    #[serde(borrow)]
    regions: Option<&'a RawValue>,
}

/// Reads a `.json` with a graph.
pub(super) fn read(source: &Source) -> Result<Edges<'_>, ReadError> {
    let Document { points, edges } =
        object(source)?.map_err(|error| faults::of_graph(source, &error))?;
    let exists = |edge: &[usize; 2]| edge.iter().all(|&vertex| vertex < points.len());
    if !edges.iter().all(exists) {
        return Err(faults::of_ends(source, &edges, points.len()));
    }
    more::read(
        source,
        Edges::without_seeds(vertices(source, points), edges, 0),
    )
}

/// Reads a `.json` with triangles.
pub(super) fn read_triangles(source: &Source) -> Result<Corners<'_>, ReadError> {
    let Answer {
        points,
        triangles,
        regions,
    } = object(source)?
        .or_else(|error| flat(source).ok_or_else(|| faults::of_triangles(source, &error)))?;
    Ok(Corners {
        first: 0,
        first_vertex: 0,
        is_soup: false,
        labels: regions
            .and_then(|list| serde_json::from_str(list.get()).ok())
            .filter(|positions: &Vec<_>| positions.len() == triangles.len())
            .map_or(Labels::Nothing, Labels::Positions),
        triangles,
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
        regions: answer.regions,
    })
}

/// The vertices of a file that has these points.
pub(super) fn vertices<'a>(source: &'a Source, points: Vec<Position<'a>>) -> Vertices<'a> {
    let (coordinates, heights): (Vec<_>, Vec<_>) = points
        .into_iter()
        .map(|Position([x, y], z)| {
            let text = |raw: &'a RawValue| raw.get().as_bytes();
            ([text(x), text(y)], z.map(text))
        })
        .unzip();
    Vertices {
        syntax: Syntax::Json,
        ..Vertices::plain(source, coordinates, 0)
    }
    .with_heights(&heights)
}

/// Members of the object in a file. The names of structures that they are read to stand in no message.
fn object<'a, T: Deserialize<'a>>(
    source: &'a Source,
) -> Result<Result<T, serde_json::Error>, ReadError> {
    let text = source.text()?;
    // Serde would take a list for an object without names.
    if text.trim_ascii_start().starts_with(b"[") {
        return Err(faults::of_list(source));
    }
    Ok(serde_json::from_slice(text))
}

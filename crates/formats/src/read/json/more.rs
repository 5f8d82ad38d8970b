//! What a JSON file with a graph says beyond its points and edges, by the names that Triangle's Python package has, too.
//!
//! | member | one element for each | which is |
//! |---|---|---|
//! | `holes` | hole | `[x, y]` |
//! | `regions` | region | `[x, y]`, then an attribute, then an area, which only refinement takes |
//! | `vertex_markers`, `point_markers` | vertex | a whole number, `null`, or a list of one |
//! | `edge_markers`, `segment_markers` | edge | likewise |
//! | `vertex_attributes`, `point_attributes` | vertex | a list of numbers; without heights in `points` the first one is the height |
//! | `columns` | column, an object of lists | a number or `null` for each vertex |
//! | `triangles`, `simplices`, `faces` | face | the positions of its corners |
//! | `crs` | | the coordinate system, as in `GeoJSON` |
//!
//! Other members are ignored with a remark, but for those of a result of ours, which follow from the graph.
//!
//! Cost: the file is read once more, to find these members.

use serde::Deserialize;
use serde_json::value::RawValue;

use crate::read::content::{Edges, Field, Syntax, Vertices};
use crate::read::json::pieces::{Position, fault, members};
use crate::read::shapes::geojson;
use crate::read::source::{ReadError, Source};
use crate::{Column, CoordinateSystem, Faces};

/// The members of results that follow from the graph.
const OF_RESULT: [&str; 9] = [
    "neighbors",
    "constrained",
    "hull",
    "duplicates",
    "chains",
    "split",
    "boundary",
    "region_attributes",
    "features",
];

/// A number, or a list of one.
#[derive(Deserialize)]
#[serde(untagged)]
enum Marker {
    Number(i64),
    Listed([i64; 1]),
}

/// Adds what else the file says to its points and edges.
pub(super) fn read<'a>(source: &'a Source, mut edges: Edges<'a>) -> Result<Edges<'a>, ReadError> {
    // It has been read as an object.
    let all = members(source.text()?).unwrap_or_default();
    // CityJSON has vertices, too, which are none before they are scaled.
    let is_city =
        |(name, value): &(String, &RawValue)| name == "type" && value.get() == "\"CityJSON\"";
    if let (true, Some(error)) = (all.iter().any(is_city), geojson::foreign(source)) {
        return Err(error);
    }
    let points = edges.vertices.coordinates.len();
    for (name, piece) in &all {
        let fault = |what: &str| fault(source, piece, format!("`{name}` is not {what}"));
        match &name[..] {
            "points" | "vertices" | "edges" | "segments" => {}
            "holes" => {
                let holes = list(piece).ok_or_else(|| fault("a list of points, [[x, y], ...]"))?;
                edges.holes = seeds(source, &holes);
            }
            "regions" if is_of_result(piece) => {}
            _ if OF_RESULT.contains(&&name[..]) => {}
            "regions" => {
                let what = "a list of points with attributes, [[x, y, attribute], ...]";
                let regions: Vec<Vec<&RawValue>> = list(piece).ok_or_else(|| fault(what))?;
                let positions = regions.iter().map(|region| match region[..] {
                    [x, y, ..] if region.len() <= 4 => Some(Position([x, y], None)),
                    _ => None,
                });
                let positions: Option<Vec<_>> = positions.collect();
                edges.regions = seeds(source, &positions.ok_or_else(|| fault(what))?);
                let numbers = |at: usize| {
                    let number = |region: &Vec<&RawValue>| match region.get(at) {
                        Some(area) if at == 3 && area.get() == "null" => Some(0.0),
                        Some(number) => serde_json::from_str(number.get()).ok(),
                        None => Some(0.0),
                    };
                    let numbers: Option<Vec<f64>> = regions.iter().map(number).collect();
                    numbers.ok_or_else(|| fault(what))
                };
                [edges.attributes, edges.areas] = [numbers(2)?, numbers(3)?];
            }
            "vertex_markers" | "point_markers" => {
                let what = format!("a list of {points} whole numbers, one for each point");
                let pieces: Vec<&RawValue> = list(piece).ok_or_else(|| fault(&what))?;
                let markers = markers(piece, points).ok_or_else(|| fault(&what))?;
                if markers.iter().any(|&marker| marker != 0) {
                    let pieces = pieces.into_iter().map(inner).collect();
                    edges.vertices.fields.push(field(Column::MARKER, pieces));
                }
            }
            "edge_markers" | "segment_markers" => {
                let count = edges.edges.len();
                let what = format!("a list of {count} whole numbers, one for each edge");
                edges.markers = markers(piece, count).ok_or_else(|| fault(&what))?;
            }
            "vertex_attributes" | "point_attributes" => {
                let rows: Option<Vec<Vec<&RawValue>>> = list(piece);
                let width = rows
                    .as_ref()
                    .and_then(|rows| rows.first())
                    .map_or(0, Vec::len);
                let is_right = |rows: &Vec<Vec<&RawValue>>| {
                    rows.len() == points && rows.iter().all(|row| row.len() == width)
                };
                let what = format!("a list of {points} lists of numbers, one for each point");
                let rows = rows.filter(is_right).ok_or_else(|| fault(&what))?;
                let mut columns = Vec::new();
                for at in 0..width {
                    let is_height = at == 0 && !has_column(&edges.vertices, Column::HEIGHT);
                    let name = if is_height {
                        Column::HEIGHT.to_owned()
                    } else {
                        format!("attribute{}", at + 1)
                    };
                    columns.push(field(&name, rows.iter().map(|row| text(row[at])).collect()));
                }
                edges.vertices.fields.extend(columns);
            }
            "columns" => {
                let what = format!("an object of lists of {points} numbers, one for each point");
                let columns = members(text(piece)).ok_or_else(|| fault(&what))?;
                for (name, numbers) in columns {
                    let numbers: Option<Vec<&RawValue>> = list(numbers);
                    let numbers = numbers.filter(|numbers| numbers.len() == points);
                    let numbers = numbers.ok_or_else(|| fault(&what))?;
                    edges
                        .vertices
                        .fields
                        .push(field(&name, numbers.into_iter().map(text).collect()));
                }
            }
            "triangles" | "simplices" | "faces" => match list(piece) {
                Some(triangles) => {
                    edges.faces = Faces {
                        triangles,
                        others: Vec::new(),
                    };
                }
                None => edges
                    .remarks
                    .ignore_named(1, ["member", "members"], name.as_bytes()),
            },
            "crs" => edges.system = Some(CoordinateSystem::of_json(piece)),
            _ => edges
                .remarks
                .ignore_named(1, ["member", "members"], name.as_bytes()),
        }
    }
    Ok(edges)
}

/// A list of things of one kind.
fn list<'a, T: Deserialize<'a>>(piece: &'a RawValue) -> Option<Vec<T>> {
    serde_json::from_str(piece.get()).ok()
}

/// Whether the regions are those of triangles, each a position in the input's list.
fn is_of_result(piece: &RawValue) -> bool {
    list(piece).is_some_and(|list: Vec<Option<usize>>| !list.is_empty())
}

/// So many markers.
fn markers(piece: &RawValue, count: usize) -> Option<Vec<i64>> {
    let markers: Vec<Option<Marker>> = list(piece)?;
    let number = |marker| match marker {
        Some(Marker::Number(number) | Marker::Listed([number])) => number,
        None => 0,
    };
    (markers.len() == count).then(|| markers.into_iter().map(number).collect())
}

/// A marker without the list around it.
fn inner(marker: &RawValue) -> &[u8] {
    let bytes = text(marker);
    let inner = bytes
        .strip_prefix(b"[")
        .and_then(|bytes| bytes.strip_suffix(b"]"));
    inner.unwrap_or(bytes).trim_ascii()
}

fn text(piece: &RawValue) -> &[u8] {
    piece.get().as_bytes()
}

fn field<'a>(name: &str, pieces: Vec<&'a [u8]>) -> Field<'a> {
    Field {
        name: name.to_owned(),
        syntax: Syntax::Json,
        pieces,
    }
}

fn has_column(vertices: &Vertices<'_>, name: &str) -> bool {
    vertices.fields.iter().any(|field| field.name == name)
}

fn seeds<'a>(source: &'a Source, seeds: &[Position<'a>]) -> Vertices<'a> {
    let coordinates = seeds.iter().map(|Position([x, y], _)| [text(x), text(y)]);
    Vertices {
        syntax: Syntax::Json,
        ..Vertices::plain(source, coordinates.collect(), 0)
    }
}

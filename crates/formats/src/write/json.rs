//! JSON: the input's `points` and `edges` (so that the file can be read again), and the result.
//!
//! | member | one element for each | which is |
//! |---|---|---|
//! | `points` | vertex | `[x, y]`, or `[x, y, z]` with a height; numbers, fractions as strings `"p/q"` |
//! | `edges` | input edge | its two vertices |
//! | `vertex_markers`, `edge_markers` | vertex, input edge, if any has a marker | a whole number |
//! | `columns` | other column, an object of lists | a number for each vertex, `null` where it is missing |
//! | `crs` | | the coordinate system, if there is one |
//! | `triangles` | triangle | its vertices counter-clockwise, the lowest first; sorted |
//! | `neighbors` | triangle | the triangles opposite its vertices, `null` beyond the hull |
//! | `constrained` | side that is an edge or a piece of one | its two vertices, lower first; sorted |
//! | `hull` | vertex on the border | the vertex; counter-clockwise from the leftmost one |
//! | `duplicates` | vertex equal to an earlier one | the vertex and the first one equal to it |
//! | `chains` | input edge | the vertices along it, from its first end to its second |
//! | `split` | edge before edges were split at their crossings, if they were | the vertices along it, from its first to its second |
//!
//! Of a graph that is not triangulated there are only those up to `crs`, with `holes` and `regions`, their seeds. Of a domain only the triangles inside are listed, with their constrained sides, and beyond the domain is `null`.
//! There are members more:
//!
//! | member | one element for each | which is |
//! |---|---|---|
//! | `boundary` | closed chain around the domain | its vertices, with the domain on the left |
//! | `regions` | triangle, if there are regions | its region, `null` for none |
//! | `region_attributes` | region of the input, if there are any | its attribute |
//! | `features` | triangle, if the domain is that of polygons | the feature whose polygon covers it, from 1 |
//!
//! All vertices, triangles and regions are positions in `points`, in `triangles` and in the input's list, from 0.

use std::collections::BTreeMap;
use std::io::{self, Write};

use serde::Serialize;
use serde_json::value::RawValue;

use super::labels::{Labels, places};
use crate::{Coordinate, GraphFile, sorted_pairs};
use sweep_cdt::Triangulation;
use sweep_cdt::interior::Interior;

/// Writes the object of the whole hull, one element a line.
pub(super) fn write<S: Coordinate>(
    file: &GraphFile<S>,
    result: &Triangulation,
    out: &mut impl Write,
) -> io::Result<()> {
    write_members(file, &Interior::whole(result), out)?;
    out.write_all(b"\n}\n")
}

/// Writes the object of a domain.
pub(super) fn write_interior<S: Coordinate>(
    file: &GraphFile<S>,
    interior: &Interior<'_>,
    out: &mut impl Write,
) -> io::Result<()> {
    write_members(file, interior, out)?;
    member(out, "boundary", interior.boundary())?;
    if interior.is_of_polygons() {
        let labels = Labels::of(file, interior, &interior.canonical_triangles());
        let features = labels.map_or(Vec::new(), |labels| labels.values);
        member(out, "features", features.iter().map(json_coordinate))?;
    } else if interior.has_regions() {
        let triangles = interior.canonical_triangles();
        let mut regions = vec![None; triangles.len()];
        for (t, place) in places(interior, &triangles).into_iter().enumerate() {
            if let Some((place, _)) = place {
                regions[place] = interior.region(t);
            }
        }
        member(out, "regions", regions)?;
        let attributes = file.graph.regions.iter();
        let attributes = attributes.map(|region| json_coordinate(&region.attribute));
        member(out, "region_attributes", attributes)?;
    }
    out.write_all(b"\n}\n")
}

/// Writes the object of a graph alone.
pub(super) fn write_graph<S: Coordinate>(
    file: &GraphFile<S>,
    out: &mut impl Write,
) -> io::Result<()> {
    write_input(file, out)?;
    let graph = &file.graph;
    if !graph.holes.is_empty() {
        let holes = graph.holes.iter();
        member(
            out,
            "holes",
            holes.map(|seed| seed.each_ref().map(json_coordinate)),
        )?;
    }
    if !graph.regions.is_empty() {
        let regions = graph.regions.iter().map(|region| {
            let [x, y] = region.seed.each_ref().map(json_coordinate);
            [x, y, json_coordinate(&region.attribute)]
        });
        member(out, "regions", regions)?;
    }
    out.write_all(b"\n}\n")
}

/// Writes what all objects of a result have.
fn write_members<S: Coordinate>(
    file: &GraphFile<S>,
    interior: &Interior<'_>,
    out: &mut impl Write,
) -> io::Result<()> {
    let result = interior.triangulation();
    let triangles = interior.canonical_triangles();
    let neighbors = neighbors(interior, &triangles);
    let chains =
        (0..file.graph.edges.len()).map(|edge| result.edge_chain(edge).collect::<Vec<_>>());
    write_input(file, out)?;
    member(out, "triangles", &triangles)?;
    member(out, "neighbors", neighbors)?;
    member(
        out,
        "constrained",
        sorted_pairs(interior.constrained_sides()),
    )?;
    member(out, "hull", result.hull())?;
    member(out, "duplicates", result.duplicates())?;
    member(out, "chains", chains)?;
    if file.pieces_of.is_empty() {
        return Ok(());
    }
    let split = file.pieces_of.chunk_by(|a, b| a == b);
    let mut first = 0;
    let split = split.map(|pieces| {
        let range = first..first + pieces.len();
        first = range.end;
        let mut chain: Vec<usize> = range.flat_map(|e| result.edge_chain(e)).collect();
        chain.dedup();
        chain
    });
    member(out, "split", split)
}

/// Writes the input's members.
pub(super) fn write_input<S: Coordinate>(
    file: &GraphFile<S>,
    out: &mut impl Write,
) -> io::Result<()> {
    let heights = file.heights();
    let point = |(vertex, point): (usize, &[S; 2])| {
        let height = heights.map(|column| column.of(vertex));
        let height = height.filter(|height| !height.is_nan());
        let height = height.map(|height| json_coordinate(&height));
        let point = point.each_ref().map(json_coordinate);
        point.into_iter().chain(height).collect::<Vec<_>>()
    };
    let points = file.graph.points.iter().enumerate().map(point);
    out.write_all(b"{\n")?;
    member(out, "points", points)?;
    member(out, "edges", &file.graph.edges)?;
    if let Some(markers) = file.vertex_markers() {
        member(out, "vertex_markers", markers)?;
    }
    if !file.edge_markers.is_empty() {
        member(out, "edge_markers", &file.edge_markers)?;
    }
    let mut columns = file.other_columns().peekable();
    if columns.peek().is_some() {
        let value = |value: f64| (!value.is_nan()).then(|| json_coordinate(&value));
        let columns = columns.map(|column| {
            let values = (0..file.graph.points.len()).map(|v| value(column.of(v)));
            (column.name.clone(), values.collect())
        });
        let columns: BTreeMap<String, Vec<_>> = columns.collect();
        out.write_all(b",\n\"columns\": ")?;
        serde_json::to_writer(&mut *out, &columns)?;
    }
    match &file.system {
        Some(system) => write!(out, ",\n\"crs\": {}", system.json()),
        None => Ok(()),
    }
}

pub(super) fn member<T: Serialize>(
    out: &mut impl Write,
    name: &str,
    elements: impl IntoIterator<Item = T>,
) -> io::Result<()> {
    let comma = if name == "points" { "" } else { ",\n" };
    write!(out, "{comma}\"{name}\": [")?;
    for (at, element) in elements.into_iter().enumerate() {
        out.write_all(if at == 0 { b"\n" } else { b",\n" })?;
        serde_json::to_writer(&mut *out, &element)?;
    }
    out.write_all(b"]")
}

/// A finite coordinate as it stands in JSON: a number, or a string with a fraction.
///
/// # Panics
/// The coordinate is not finite.
pub fn json_coordinate<S: Coordinate>(value: &S) -> Box<RawValue> {
    let text = value.text();
    let text = if text.contains('/') {
        format!("\"{text}\"")
    } else {
        text
    };
    RawValue::from_string(text).expect("a finite number, or a string without special characters")
}

/// For each triangle of the canonical list the places in it of those opposite its vertices.
fn neighbors(interior: &Interior<'_>, triangles: &[[usize; 3]]) -> Vec<[Option<usize>; 3]> {
    let result = interior.triangulation();
    let places = places(interior, triangles);
    let mut neighbors = vec![[None; 3]; triangles.len()];
    for (t, place) in places.iter().enumerate() {
        if let Some((place, first)) = *place {
            neighbors[place] = [0, 1, 2].map(|i| {
                let across = result.neighbor(t, (first + i) % 3)?;
                places[across].map(|(place, _)| place)
            });
        }
    }
    neighbors
}

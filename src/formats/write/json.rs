//! JSON: the input's `points` and `edges` (so that the file can be read again), and the result.
//!
//! | member | one element for each | which is |
//! |---|---|---|
//! | `points` | vertex | `[x, y]`, numbers; fractions as strings `"p/q"` |
//! | `edges` | input edge | its two vertices |
//! | `triangles` | triangle | its vertices counter-clockwise, the lowest first; sorted |
//! | `neighbors` | triangle | the triangles opposite its vertices, `null` beyond the hull |
//! | `constrained` | side that is an edge or a piece of one | its two vertices, lower first; sorted |
//! | `hull` | vertex on the border | the vertex; counter-clockwise from the leftmost one |
//! | `duplicates` | vertex equal to an earlier one | the vertex and the first one equal to it |
//! | `chains` | input edge | the vertices along it, upper end first |
//!
//! All vertices and triangles are positions in `points` and `triangles`, from 0.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::value::RawValue;

use crate::Triangulation;
use crate::formats::pairs::sorted_pairs;
use crate::formats::{Coordinate, Graph};

/// Writes the object, one element a line.
pub(super) fn write<S: Coordinate>(
    graph: &Graph<S>,
    result: &Triangulation,
    out: &mut impl Write,
) -> io::Result<()> {
    let triangles = result.canonical_triangles();
    let neighbors = neighbors(result, &triangles);
    let chains = (0..graph.edges.len()).map(|edge| result.edge_chain(edge).collect::<Vec<_>>());
    out.write_all(b"{\n")?;
    member(
        out,
        "points",
        graph
            .points
            .iter()
            .map(|point| point.each_ref().map(json_coordinate)),
    )?;
    member(out, "edges", &graph.edges)?;
    member(out, "triangles", &triangles)?;
    member(out, "neighbors", neighbors)?;
    member(out, "constrained", sorted_pairs(result.constrained_edges()))?;
    member(out, "hull", result.hull())?;
    member(out, "duplicates", result.duplicates())?;
    member(out, "chains", chains)?;
    out.write_all(b"\n}\n")
}

fn member<T: Serialize>(
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
fn json_coordinate<S: Coordinate>(value: &S) -> Box<RawValue> {
    let text = value.text();
    let text = if text.contains('/') {
        format!("\"{text}\"")
    } else {
        text
    };
    RawValue::from_string(text).expect("a finite number, or a string without special characters")
}

/// For each triangle of the canonical list the places in it of those opposite its vertices.
fn neighbors(result: &Triangulation, triangles: &[[usize; 3]]) -> Vec<[Option<usize>; 3]> {
    // Triangle `t` in the list: its place, and which of its vertices comes first there.
    let find = |t: usize| {
        let corners = result.triangle(t);
        let first = (0..3)
            .min_by_key(|&i| corners[i])
            .expect("a triangle has corners");
        let listed = [0, 1, 2].map(|i| corners[(first + i) % 3]);
        (
            triangles
                .binary_search(&listed)
                .expect("every triangle is listed"),
            first,
        )
    };
    let places: Vec<(usize, usize)> = (0..result.len()).map(find).collect();
    let mut neighbors = vec![[None; 3]; triangles.len()];
    for (t, &(place, first)) in places.iter().enumerate() {
        neighbors[place] = [0, 1, 2].map(|i| {
            let across = result.neighbor(t, (first + i) % 3)?;
            Some(places[across].0)
        });
    }
    neighbors
}

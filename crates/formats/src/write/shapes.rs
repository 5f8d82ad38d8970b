//! `GeoJSON` and WKT: polygons of a result, or the points and edges of a graph, with coordinates wherever a vertex is
//! meant. The column `z` is the third coordinate. Rationals are rounded to doubles.

use std::io::{self, Write};

use super::rows::write_rows;
use crate::{Column, Coordinate, GraphFile};
use sweep_cdt::Pslg;
use sweep_cdt::interior::Interior;

/// How positions stand in a format.
struct Positions<'a, S> {
    graph: &'a Pslg<S>,
    heights: Option<&'a Column>,
    /// The text before, between and after the coordinates of a position.
    marks: [&'static str; 3],
}

impl<'a, S: Coordinate> Positions<'a, S> {
    fn of_geojson(file: &'a GraphFile<S>) -> Positions<'a, S> {
        Positions {
            graph: &file.graph,
            heights: file.heights(),
            marks: ["[", ",", "]"],
        }
    }

    fn of_wkt(file: &'a GraphFile<S>) -> Positions<'a, S> {
        Positions {
            graph: &file.graph,
            heights: file.heights(),
            marks: ["", " ", ""],
        }
    }

    /// The endings of the names of geometries in WKT.
    fn dimension(&self) -> &'static str {
        if self.heights.is_some() { " Z" } else { "" }
    }

    /// Writes an item for each list of vertices: the positions, with commas between them, between two words.
    fn write<const N: usize>(
        &self,
        [before, after]: [&str; 2],
        count: usize,
        vertices: impl Fn(usize) -> [usize; N] + Sync + Send,
        out: &mut impl Write,
    ) -> io::Result<()> {
        write_rows(out, count, |at, text| {
            text.extend_from_slice(if at == 0 { b"\n" } else { b",\n" });
            text.extend_from_slice(before.as_bytes());
            for (at, vertex) in vertices(at).into_iter().enumerate() {
                if at > 0 {
                    text.push(b',');
                }
                self.write_position(vertex, text);
            }
            text.extend_from_slice(after.as_bytes());
        })
    }

    fn write_position(&self, vertex: usize, text: &mut Vec<u8>) {
        let [before, between, after] = self.marks.map(str::as_bytes);
        let [x, y] = self.graph.points[vertex].each_ref().map(S::approx);
        text.extend_from_slice(before);
        x.write_text(text);
        text.extend_from_slice(between);
        y.write_text(text);
        if let Some(heights) = self.heights {
            let height = heights.of(vertex);
            // A position of GeoJSON has two or three numbers, one of WKT as many as all others.
            if !height.is_nan() {
                text.extend_from_slice(between);
                height.write_text(text);
            } else if before.is_empty() {
                text.extend_from_slice(b" NaN");
            }
        }
        text.extend_from_slice(after);
    }
}

/// Writes a collection of features, one for each triangle inside.
pub(super) fn write_geojson<S: Coordinate>(
    file: &GraphFile<S>,
    interior: &Interior<'_>,
    out: &mut impl Write,
) -> io::Result<()> {
    let triangles = interior.canonical_triangles();
    let words = [
        r#"{"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[["#,
        "]]}}",
    ];
    out.write_all(br#"{"type":"FeatureCollection","features":["#)?;
    let ring = |t: usize| closed(triangles[t]);
    Positions::of_geojson(file).write(words, triangles.len(), ring, out)?;
    out.write_all(b"]}\n")
}

/// Writes the vertices and the edges.
pub(super) fn write_geojson_graph<S: Coordinate>(
    file: &GraphFile<S>,
    out: &mut impl Write,
) -> io::Result<()> {
    let positions = Positions::of_geojson(file);
    out.write_all(
        br#"{"type":"GeometryCollection","geometries":[{"type":"MultiPoint","coordinates":["#,
    )?;
    let graph = &file.graph;
    positions.write(["", ""], graph.points.len(), |v| [v], out)?;
    out.write_all(br#"]},{"type":"MultiLineString","coordinates":["#)?;
    positions.write(["[", "]"], graph.edges.len(), |e| graph.edges[e], out)?;
    out.write_all(b"]}]}\n")
}

/// Writes a collection of polygons, one for each triangle inside.
pub(super) fn write_wkt<S: Coordinate>(
    file: &GraphFile<S>,
    interior: &Interior<'_>,
    out: &mut impl Write,
) -> io::Result<()> {
    let positions = Positions::of_wkt(file);
    let triangles = interior.canonical_triangles();
    let dimension = positions.dimension();
    if triangles.is_empty() {
        return writeln!(out, "GEOMETRYCOLLECTION{dimension} EMPTY");
    }
    let polygon = format!("POLYGON{dimension} ((");
    write!(out, "GEOMETRYCOLLECTION{dimension} (")?;
    let ring = |t: usize| closed(triangles[t]);
    positions.write([&polygon, "))"], triangles.len(), ring, out)?;
    out.write_all(b")\n")
}

/// Writes the vertices and the edges.
pub(super) fn write_wkt_graph<S: Coordinate>(
    file: &GraphFile<S>,
    out: &mut impl Write,
) -> io::Result<()> {
    let positions = Positions::of_wkt(file);
    let dimension = positions.dimension();
    write!(out, "GEOMETRYCOLLECTION{dimension} (MULTIPOINT{dimension} ")?;
    let graph = &file.graph;
    let (points, edges) = (graph.points.len(), graph.edges.len());
    write_list(points, out, |out| {
        positions.write(["(", ")"], points, |v| [v], out)
    })?;
    write!(out, ",\nMULTILINESTRING{dimension} ")?;
    write_list(edges, out, |out| {
        positions.write(["(", ")"], edges, |e| graph.edges[e], out)
    })?;
    out.write_all(b")\n")
}

/// Writes a list of WKT of so many items, which has a word of its own for none.
fn write_list<W: Write>(
    count: usize,
    out: &mut W,
    items: impl FnOnce(&mut W) -> io::Result<()>,
) -> io::Result<()> {
    if count == 0 {
        return out.write_all(b"EMPTY");
    }
    out.write_all(b"(")?;
    items(out)?;
    out.write_all(b")")
}

/// The ring around a triangle.
fn closed([a, b, c]: [usize; 3]) -> [usize; 4] {
    [a, b, c, a]
}

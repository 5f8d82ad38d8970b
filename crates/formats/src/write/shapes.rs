//! `GeoJSON` and WKT: polygons of a result, or the points and edges of a graph, with coordinates wherever a vertex is
//! meant. The column `z` is the third coordinate. Rationals are rounded to doubles.

use std::io::{self, Write};

use super::labels::Labels;
use super::rows::write_rows;
use crate::graph_file::whole;
use crate::{Column, Coordinate, CoordinateSystem, GraphFile};
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
        let begin = |_, text: &mut Vec<u8>| text.extend_from_slice(before.as_bytes());
        self.write_after(begin, after, count, vertices, out)
    }

    /// Writes an item for each list of vertices, after what `begin` appends for it.
    fn write_after<const N: usize>(
        &self,
        begin: impl Fn(usize, &mut Vec<u8>) + Sync + Send,
        after: &str,
        count: usize,
        vertices: impl Fn(usize) -> [usize; N] + Sync + Send,
        out: &mut impl Write,
    ) -> io::Result<()> {
        write_rows(out, count, |at, text| {
            text.extend_from_slice(if at == 0 { b"\n" } else { b",\n" });
            begin(at, text);
            for (at, vertex) in vertices(at).into_iter().enumerate() {
                if at > 0 {
                    text.push(b',');
                }
                self.write_position(vertex, text);
            }
            text.extend_from_slice(after.as_bytes());
        })
    }

    /// Writes polygons as lists of rings, which are lists of positions.
    fn write_polygons(
        &self,
        polygons: &[Polygon],
        [begin, end]: [&str; 2],
        out: &mut impl Write,
    ) -> io::Result<()> {
        write_rows(out, polygons.len(), |at, text| {
            text.extend_from_slice(if at == 0 { b"\n" } else { b",\n" });
            text.extend_from_slice(begin.as_bytes());
            for (at, ring) in polygons[at].rings.iter().enumerate() {
                if at > 0 {
                    text.push(b',');
                }
                text.extend_from_slice(begin.as_bytes());
                for (at, &vertex) in ring.iter().enumerate() {
                    if at > 0 {
                        text.push(b',');
                    }
                    self.write_position(vertex, text);
                }
                text.extend_from_slice(end.as_bytes());
            }
            text.extend_from_slice(end.as_bytes());
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

/// Writes a collection of features, one for each triangle inside, with its region, or the feature whose polygon covers
/// it and the properties of that.
pub(super) fn write_geojson<S: Coordinate>(
    file: &GraphFile<S>,
    interior: &Interior<'_>,
    out: &mut impl Write,
) -> io::Result<()> {
    let triangles = interior.canonical_triangles();
    let labels = Labels::of(file, interior, &triangles);
    let begin = |t: usize, text: &mut Vec<u8>| {
        text.extend_from_slice(br#"{"type":"Feature","properties":{"#);
        if let Some(labels) = &labels {
            text.extend_from_slice(format!("\"{}\":", labels.name).as_bytes());
            let label = labels.values[t];
            label.write_text(text);
            let own = match whole(label).filter(|_| interior.is_of_polygons()) {
                Some(feature) => file.properties.of(usize::try_from(feature).unwrap_or(0)),
                None => "",
            };
            if !own.is_empty() {
                text.push(b',');
                text.extend_from_slice(own.as_bytes());
            }
        }
        text.extend_from_slice(br#"},"geometry":{"type":"Polygon","coordinates":[["#);
    };
    write_system(r#"{"type":"FeatureCollection","#, file.system.as_ref(), out)?;
    out.write_all(br#""features":["#)?;
    let ring = |t: usize| closed(triangles[t]);
    let positions = Positions::of_geojson(file);
    positions.write_after(begin, "]]}}", triangles.len(), ring, out)?;
    out.write_all(b"]}\n")
}

/// Writes the beginning of an object, with the coordinate system.
pub(super) fn write_system(
    begin: &str,
    system: Option<&CoordinateSystem>,
    out: &mut impl Write,
) -> io::Result<()> {
    out.write_all(begin.as_bytes())?;
    match system {
        Some(system) => write!(out, r#""crs":{},"#, system.json()),
        None => Ok(()),
    }
}

/// Writes the vertices, each as a feature where there are no edges, with the properties of the feature that is numbered as it
/// is, from 1. Otherwise a collection has them, and the edges:
/// polygons by their rings, and lines.
pub(super) fn write_geojson_graph<S: Coordinate>(
    file: &GraphFile<S>,
    out: &mut impl Write,
) -> io::Result<()> {
    let positions = Positions::of_geojson(file);
    let graph = &file.graph;
    if graph.edges.is_empty() {
        write_system(r#"{"type":"FeatureCollection","#, file.system.as_ref(), out)?;
        out.write_all(br#""features":["#)?;
        let begin = |v: usize, text: &mut Vec<u8>| {
            text.extend_from_slice(br#"{"type":"Feature","properties":{"#);
            text.extend_from_slice(file.properties.of(v + 1).as_bytes());
            text.extend_from_slice(br#"},"geometry":{"type":"Point","coordinates":"#);
        };
        positions.write_after(begin, "}}", graph.points.len(), |v| [v], out)?;
        return out.write_all(b"]}\n");
    }
    write_system(
        r#"{"type":"GeometryCollection","#,
        file.system.as_ref(),
        out,
    )?;
    out.write_all(br#""geometries":[{"type":"MultiPoint","coordinates":["#)?;
    positions.write(["", ""], graph.points.len(), |v| [v], out)?;
    let shapes = Shapes::of(file);
    for polygons in shapes.polygons.chunk_by(|a, b| a.feature == b.feature) {
        out.write_all(br#"]},{"type":"MultiPolygon","coordinates":["#)?;
        positions.write_polygons(polygons, ["[", "]"], out)?;
    }
    out.write_all(br#"]},{"type":"MultiLineString","coordinates":["#)?;
    let lines = &shapes.lines;
    positions.write(["[", "]"], lines.len(), |at| graph.edges[lines[at]], out)?;
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
    write_srid(file.system.as_ref(), out)?;
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
    write_srid(file.system.as_ref(), out)?;
    write!(out, "GEOMETRYCOLLECTION{dimension} (MULTIPOINT{dimension} ")?;
    let graph = &file.graph;
    let points = graph.points.len();
    write_list(points, out, |out| {
        positions.write(["(", ")"], points, |v| [v], out)
    })?;
    let shapes = Shapes::of(file);
    for polygons in shapes.polygons.chunk_by(|a, b| a.feature == b.feature) {
        write!(out, ",\nMULTIPOLYGON{dimension} (")?;
        positions.write_polygons(polygons, ["(", ")"], out)?;
        out.write_all(b")")?;
    }
    write!(out, ",\nMULTILINESTRING{dimension} ")?;
    let lines = &shapes.lines;
    write_list(lines.len(), out, |out| {
        positions.write(["(", ")"], lines.len(), |at| graph.edges[lines[at]], out)
    })?;
    out.write_all(b")\n")
}

/// Writes the number of the coordinate system, where it has one.
pub(super) fn write_srid(
    system: Option<&CoordinateSystem>,
    out: &mut impl Write,
) -> io::Result<()> {
    match system.and_then(CoordinateSystem::srid) {
        Some(srid) => write!(out, "SRID={srid};"),
        None => Ok(()),
    }
}

/// The edges of a graph as polygons and lines.
struct Shapes {
    polygons: Vec<Polygon>,
    /// Edges of no ring, and those of rings that are not one chain in the order of the edges.
    lines: Vec<usize>,
}

struct Polygon {
    feature: usize,
    /// The vertices of each ring, the first one at the end once more.
    rings: Vec<Vec<usize>>,
}

impl Shapes {
    fn of<S>(file: &GraphFile<S>) -> Shapes {
        let (graph, polygons) = (&file.graph, &file.polygons);
        let mut edges_of = vec![Vec::new(); polygons.rings.len()];
        let mut lines = Vec::new();
        for edge in 0..graph.edges.len() {
            match polygons.ring_of.get(edge).copied().flatten() {
                Some(ring) => edges_of[ring].push(edge),
                None => lines.push(edge),
            }
        }
        let mut list: Vec<Polygon> = (polygons.features.iter())
            .map(|&feature| Polygon {
                feature,
                rings: Vec::new(),
            })
            .collect();
        for (ring, edges) in polygons.rings.iter().zip(edges_of) {
            let chain: Vec<[usize; 2]> = edges.iter().map(|&edge| graph.edges[edge]).collect();
            let is_chain = chain.windows(2).all(|pair| pair[0][1] == pair[1][0])
                && chain.first().map(|edge| edge[0]) == chain.last().map(|edge| edge[1]);
            let rings = list.get_mut(ring.polygon).map(|polygon| &mut polygon.rings);
            match rings.filter(|rings| is_chain && ring.is_hole != rings.is_empty()) {
                Some(rings) => {
                    let first = chain.first().map(|edge| edge[0]);
                    rings.push(
                        first
                            .into_iter()
                            .chain(chain.iter().map(|edge| edge[1]))
                            .collect(),
                    );
                }
                None => lines.extend(edges),
            }
        }
        list.retain(|polygon| !polygon.rings.is_empty());
        Shapes {
            polygons: list,
            lines,
        }
    }
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

//! Lines of equal height: as features of a map, each with its height, or as vertices and edges.
//!
//! In `.geojson` a line is a feature, whose property `elev` is its height; in `.wkt` all are one collection. Both have the
//! height as third coordinate. In every other format a line is a chain of edges between vertices of its own, and the
//! heights are the column `z`.

use std::io::{self, Write};

use super::shapes::{write_srid, write_system};
use crate::Coordinate;
use crate::{Column, CoordinateSystem, Format, GraphFile, write_graph};
use sweep_cdt::Pslg;

/// Writes lines, each with its height, and their coordinate system, in one of [`Format::INPUTS`]; the last point of a closed line equals its first.
///
/// ```
/// use sweep_cdt_formats::{Format, write_lines};
///
/// let lines = [(7.5, vec![[0.0, 0.0], [1.0, 0.0], [0.0, 2.0], [0.0, 0.0]])];
/// let mut text = Vec::new();
/// write_lines(Format::Poly, &lines, None, &mut text)?;
/// let vertices = "3 2 1 0\n0 0 0 7.5\n1 1 0 7.5\n2 0 2 7.5\n";
/// let edges = "3 0\n0 0 1\n1 1 2\n2 2 0\n0\n";
/// assert_eq!(text, [vertices, edges].concat().as_bytes());
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// # Errors
/// Errors of `out`; [`io::ErrorKind::Unsupported`] for another format.
pub fn write_lines(
    format: Format,
    lines: &[(f64, Vec<[f64; 2]>)],
    system: Option<&CoordinateSystem>,
    out: &mut impl Write,
) -> io::Result<()> {
    match format {
        Format::Geojson => write_geojson(lines, system, out),
        Format::Wkt => write_wkt(lines, system, out),
        _ => {
            let mut file = graph(lines);
            file.system = system.cloned();
            write_graph(format, &file, out)
        }
    }
}

/// The lines as vertices and edges.
fn graph(lines: &[(f64, Vec<[f64; 2]>)]) -> GraphFile<f64> {
    let mut graph = Pslg::default();
    let mut heights = Vec::new();
    for (height, points) in lines {
        let first = graph.points.len();
        let is_closed = points.len() > 2 && points.first() == points.last();
        let count = points.len() - usize::from(is_closed);
        graph.points.extend(&points[..count]);
        heights.resize(first + count, *height);
        let steps = points.len().saturating_sub(1);
        let edges = (0..steps).map(|at| [first + at, first + (at + 1) % count]);
        graph.edges.extend(edges);
    }
    GraphFile {
        columns: vec![Column::heights(heights)],
        ..graph.into()
    }
}

/// Writes a feature for each line.
fn write_geojson(
    lines: &[(f64, Vec<[f64; 2]>)],
    system: Option<&CoordinateSystem>,
    out: &mut impl Write,
) -> io::Result<()> {
    write_system(r#"{"type":"FeatureCollection","#, system, out)?;
    out.write_all(br#""features":["#)?;
    for (at, (height, points)) in lines.iter().enumerate() {
        let height = height.text();
        let comma = if at == 0 { "" } else { "," };
        write!(
            out,
            "{comma}\n{{\"type\":\"Feature\",\"properties\":{{\"elev\":{height}}},\
             \"geometry\":{{\"type\":\"LineString\",\"coordinates\":["
        )?;
        for (at, [x, y]) in points.iter().enumerate() {
            let comma = if at == 0 { "" } else { "," };
            write!(out, "{comma}[{},{},{height}]", x.text(), y.text())?;
        }
        out.write_all(b"]}}")?;
    }
    out.write_all(b"]}\n")
}

/// Writes a collection of lines.
fn write_wkt(
    lines: &[(f64, Vec<[f64; 2]>)],
    system: Option<&CoordinateSystem>,
    out: &mut impl Write,
) -> io::Result<()> {
    write_srid(system, out)?;
    if lines.is_empty() {
        return out.write_all(b"MULTILINESTRING Z EMPTY\n");
    }
    out.write_all(b"MULTILINESTRING Z (")?;
    for (at, (height, points)) in lines.iter().enumerate() {
        let height = height.text();
        out.write_all(if at == 0 { b"\n(" } else { b",\n(" })?;
        for (at, [x, y]) in points.iter().enumerate() {
            let comma = if at == 0 { "" } else { "," };
            write!(out, "{comma}{} {} {height}", x.text(), y.text())?;
        }
        out.write_all(b")")?;
    }
    out.write_all(b")\n")
}

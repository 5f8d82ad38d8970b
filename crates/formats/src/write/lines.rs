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

/// Writes lines, each with its height, and their coordinate system, in one of [`Format::GRAPHS`]; the last point of a closed line equals its first.
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
    if !Format::LINES.contains(&format) {
        let mut file = graph(lines);
        file.system = system.cloned();
        return write_graph(format, &file, out);
    }
    let mut writer = LineWriter::begin(format, system, out)?;
    for (height, points) in lines {
        writer.line(*height, points)?;
    }
    writer.finish()
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

/// Writes lines one by one, as [`write_lines`] does.
///
/// ```
/// use sweep_cdt_formats::{Format, LineWriter};
///
/// let mut text = Vec::new();
/// let mut lines = LineWriter::begin(Format::Wkt, None, &mut text)?;
/// lines.line(7.5, &[[0.0, 0.0], [1.0, 0.0]])?;
/// lines.finish()?;
/// assert_eq!(text, b"MULTILINESTRING Z (\n(0 0 7.5,1 0 7.5))\n");
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct LineWriter<W> {
    out: W,
    is_map: bool,
    has_lines: bool,
}

impl<W: Write> LineWriter<W> {
    /// Begins a file in one of [`Format::LINES`] with this coordinate system.
    ///
    /// # Errors
    /// Errors of `out`; [`io::ErrorKind::Unsupported`] for another format.
    pub fn begin(
        format: Format,
        system: Option<&CoordinateSystem>,
        mut out: W,
    ) -> io::Result<Self> {
        match format {
            Format::Geojson => {
                write_system(r#"{"type":"FeatureCollection","#, system, &mut out)?;
                out.write_all(br#""features":["#)?;
            }
            Format::Wkt => write_srid(system, &mut out)?,
            _ => return Err(io::ErrorKind::Unsupported.into()),
        }
        Ok(LineWriter {
            out,
            is_map: format == Format::Geojson,
            has_lines: false,
        })
    }

    /// The next line, a feature or a part of the collection.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn line(&mut self, height: f64, points: &[[f64; 2]]) -> io::Result<()> {
        let is_first = !std::mem::replace(&mut self.has_lines, true);
        let height = height.text();
        let begin = match (is_first, self.is_map) {
            (true, true) => "",
            (true, false) => "MULTILINESTRING Z (",
            _ => ",",
        };
        let out = &mut self.out;
        match self.is_map {
            true => write!(
                out,
                "{begin}\n{{\"type\":\"Feature\",\"properties\":{{\"elev\":{height}}},\
                 \"geometry\":{{\"type\":\"LineString\",\"coordinates\":["
            )?,
            false => write!(out, "{begin}\n(")?,
        }
        for (at, [x, y]) in points.iter().enumerate() {
            let comma = if at == 0 { "" } else { "," };
            let [x, y] = [x.text(), y.text()];
            match self.is_map {
                true => write!(out, "{comma}[{x},{y},{height}]")?,
                false => write!(out, "{comma}{x} {y} {height}")?,
            }
        }
        out.write_all(if self.is_map { b"]}}" } else { b")" })
    }

    /// Ends the file.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn finish(mut self) -> io::Result<()> {
        self.out.write_all(match (self.is_map, self.has_lines) {
            (true, _) => b"]}\n",
            (false, true) => b")\n",
            (false, false) => b"MULTILINESTRING Z EMPTY\n",
        })
    }
}

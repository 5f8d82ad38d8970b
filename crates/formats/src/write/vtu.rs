//! VTK's XML format: an `UnstructuredGrid` of one piece, its arrays as text.

use std::io::{self, Write};

use quick_xml::escape::escape;

use super::mesh::{Mesh, write_faces};
use super::rows::{number, write_rows};
use crate::{Column, Coordinate};

impl<S: Coordinate> Mesh<'_, S> {
    /// Writes VTK's XML format with all columns.
    pub(super) fn write_vtu(&self, out: &mut impl Write) -> io::Result<()> {
        const TYPES: [&[u8]; 2] = [b"3\n", b"5\n"];
        let (points, lines) = (self.file.graph.points.len(), self.lines.len());
        let cells = lines + self.triangles.len();
        let begin = |out: &mut dyn Write, kind: &str, name: &str, components: usize| {
            let name = escape(name);
            writeln!(
                out,
                "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"ascii\">"
            )
        };
        writeln!(out, "<?xml version=\"1.0\"?>")?;
        writeln!(
            out,
            "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">"
        )?;
        writeln!(
            out,
            "<UnstructuredGrid>\n<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">"
        )?;
        writeln!(out, "<PointData>")?;
        for column in self.others() {
            begin(out, "Float64", &column.name, 1)?;
            write_rows(out, points, |vertex, text| {
                column.of(vertex).write_text(text);
                text.push(b'\n');
            })?;
            writeln!(out, "</DataArray>")?;
        }
        writeln!(out, "</PointData>")?;
        if !self.markers.is_empty() || self.labels.is_some() {
            writeln!(out, "<CellData>")?;
            if !self.markers.is_empty() {
                begin(out, "Int64", Column::MARKER, 1)?;
                write_rows(out, cells, |cell, text| {
                    self.write_marker(cell, text);
                    text.push(b'\n');
                })?;
                writeln!(out, "</DataArray>")?;
            }
            if let Some(labels) = &self.labels {
                begin(out, "Float64", labels.name, 1)?;
                write_rows(out, cells, |cell, text| {
                    self.write_label(cell, labels, text);
                    text.push(b'\n');
                })?;
                writeln!(out, "</DataArray>")?;
            }
            writeln!(out, "</CellData>")?;
        }
        writeln!(out, "<Points>")?;
        begin(out, "Float64", "Points", 3)?;
        self.write_vertices(|_, _| (), &[], out)?;
        writeln!(out, "</DataArray>\n</Points>\n<Cells>")?;
        begin(out, "Int64", "connectivity", 1)?;
        write_faces(b"", 0, &self.lines, out)?;
        write_faces(b"", 0, &self.triangles, out)?;
        writeln!(out, "</DataArray>")?;
        begin(out, "Int64", "offsets", 1)?;
        write_rows(out, cells, |at, text| {
            // Two corners for each line, three for each triangle.
            number(
                2 * lines.min(at + 1) + 3 * (at + 1).saturating_sub(lines),
                text,
            );
            text.push(b'\n');
        })?;
        writeln!(out, "</DataArray>")?;
        begin(out, "UInt8", "types", 1)?;
        write_rows(out, cells, |at, text| {
            text.extend_from_slice(TYPES[usize::from(at >= lines)]);
        })?;
        writeln!(out, "</DataArray>\n</Cells>\n</Piece>")?;
        writeln!(out, "</UnstructuredGrid>\n</VTKFile>")
    }
}

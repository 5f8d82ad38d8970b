//! VTK's XML formats: an `UnstructuredGrid` (`.vtu`) or a `PolyData` (`.vtp`) of one piece, its arrays as text.

use std::io::{self, Write};

use quick_xml::escape::escape;

use super::mesh::{Mesh, write_faces};
use super::rows::{number, write_rows};
use crate::{Column, Coordinate};

impl<S: Coordinate> Mesh<'_, S> {
    /// Writes a grid with all columns.
    pub(super) fn write_vtu(&self, out: &mut impl Write) -> io::Result<()> {
        const TYPES: [&[u8]; 2] = [b"3\n", b"5\n"];
        let lines = self.lines.len();
        let cells = lines + self.triangles.len();
        let counts = format!("NumberOfCells=\"{cells}\"");
        self.begin("UnstructuredGrid", &counts, out)?;
        writeln!(out, "<Cells>")?;
        begin_array("Int64", "connectivity", 1, out)?;
        write_faces(b"", 0, &self.lines, out)?;
        write_faces(b"", 0, &self.triangles, out)?;
        writeln!(out, "</DataArray>")?;
        begin_array("Int64", "offsets", 1, out)?;
        write_rows(out, cells, |at, text| {
            // Two corners for each line, three for each triangle.
            number(
                2 * lines.min(at + 1) + 3 * (at + 1).saturating_sub(lines),
                text,
            );
            text.push(b'\n');
        })?;
        writeln!(out, "</DataArray>")?;
        begin_array("UInt8", "types", 1, out)?;
        write_rows(out, cells, |at, text| {
            text.extend_from_slice(TYPES[usize::from(at >= lines)]);
        })?;
        writeln!(out, "</DataArray>\n</Cells>\n</Piece>")?;
        writeln!(out, "</UnstructuredGrid>\n</VTKFile>")
    }

    /// Writes lines and polygons with all columns.
    pub(super) fn write_vtp(&self, out: &mut impl Write) -> io::Result<()> {
        let (lines, triangles) = (self.lines.len(), self.triangles.len());
        let counts = format!(
            "NumberOfVerts=\"0\" NumberOfLines=\"{lines}\" NumberOfStrips=\"0\" NumberOfPolys=\"{triangles}\""
        );
        self.begin("PolyData", &counts, out)?;
        write_section("Lines", &self.lines, out)?;
        write_section("Polys", &self.triangles, out)?;
        writeln!(out, "</Piece>\n</PolyData>\n</VTKFile>")
    }

    /// Writes all up to the cells.
    fn begin(&self, kind: &str, counts: &str, out: &mut impl Write) -> io::Result<()> {
        let points = self.file.graph.points.len();
        writeln!(out, "<?xml version=\"1.0\"?>")?;
        writeln!(
            out,
            "<VTKFile type=\"{kind}\" version=\"0.1\" byte_order=\"LittleEndian\">"
        )?;
        writeln!(
            out,
            "<{kind}>\n<Piece NumberOfPoints=\"{points}\" {counts}>"
        )?;
        writeln!(out, "<PointData>")?;
        for column in self.others() {
            begin_array("Float64", &column.name, 1, out)?;
            write_rows(out, points, |vertex, text| {
                column.of(vertex).write_text(text);
                text.push(b'\n');
            })?;
            writeln!(out, "</DataArray>")?;
        }
        writeln!(out, "</PointData>")?;
        self.write_cell_data(out)?;
        writeln!(out, "<Points>")?;
        begin_array("Float64", "Points", 3, out)?;
        self.write_vertices(|_, _| (), &[], out)?;
        writeln!(out, "</DataArray>\n</Points>")
    }

    /// Writes the markers of lines and the regions or features of triangles, if there are any.
    fn write_cell_data(&self, out: &mut impl Write) -> io::Result<()> {
        if self.markers.is_empty() && self.labels.is_none() {
            return Ok(());
        }
        let cells = self.lines.len() + self.triangles.len();
        writeln!(out, "<CellData>")?;
        if !self.markers.is_empty() {
            begin_array("Int64", Column::MARKER, 1, out)?;
            write_rows(out, cells, |cell, text| {
                self.write_marker(cell, text);
                text.push(b'\n');
            })?;
            writeln!(out, "</DataArray>")?;
        }
        if let Some(labels) = &self.labels {
            begin_array("Float64", labels.name, 1, out)?;
            write_rows(out, cells, |cell, text| {
                self.write_label(cell, labels, text);
                text.push(b'\n');
            })?;
            writeln!(out, "</DataArray>")?;
        }
        writeln!(out, "</CellData>")
    }
}

/// Writes cells of so many corners each.
fn write_section<const N: usize>(
    name: &str,
    cells: &[[usize; N]],
    out: &mut impl Write,
) -> io::Result<()> {
    writeln!(out, "<{name}>")?;
    begin_array("Int64", "connectivity", 1, out)?;
    write_faces(b"", 0, cells, out)?;
    writeln!(out, "</DataArray>")?;
    begin_array("Int64", "offsets", 1, out)?;
    write_rows(out, cells.len(), |at, text| {
        number(N * (at + 1), text);
        text.push(b'\n');
    })?;
    writeln!(out, "</DataArray>\n</{name}>")
}

fn begin_array(kind: &str, name: &str, components: usize, out: &mut impl Write) -> io::Result<()> {
    let name = escape(name);
    writeln!(
        out,
        "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"ascii\">"
    )
}

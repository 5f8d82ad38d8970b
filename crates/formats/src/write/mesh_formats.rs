//! Formats of meshes that fewer programs read: Stanford's, VTK's old one, Gmsh's and STL.

use std::io::{self, Write};

use super::mesh::{Mesh, write_faces};
use super::rows::{number, numbers, write_rows};
use crate::{Column, Coordinate};

impl<'a, S: Coordinate> Mesh<'a, S> {
    /// Writes Stanford's format with all columns. The names of properties have no spaces.
    pub(super) fn write_ply(&self, out: &mut impl Write) -> io::Result<()> {
        let others = self.others();
        writeln!(out, "ply\nformat ascii 1.0")?;
        writeln!(out, "element vertex {}", self.file.graph.points.len())?;
        for name in ["x", "y", Column::HEIGHT] {
            writeln!(out, "property double {name}")?;
        }
        for column in &others {
            writeln!(out, "property double {}", word(&column.name))?;
        }
        if !self.lines.is_empty() {
            let count = self.lines.len();
            writeln!(
                out,
                "element edge {count}\nproperty int vertex1\nproperty int vertex2"
            )?;
        }
        if !self.triangles.is_empty() {
            let count = self.triangles.len();
            writeln!(
                out,
                "element face {count}\nproperty list uchar int vertex_indices"
            )?;
        }
        writeln!(out, "end_header")?;
        self.write_vertices(|_, _| (), &others, out)?;
        write_faces(b"", 0, self.lines, out)?;
        write_faces(b"3 ", 0, &self.triangles, out)
    }

    /// Writes VTK's legacy format with all columns.
    pub(super) fn write_vtk(&self, out: &mut impl Write) -> io::Result<()> {
        const LINE: &[u8] = b"3\n";
        const TRIANGLE: &[u8] = b"5\n";
        let points = self.file.graph.points.len();
        let (lines, triangles) = (self.lines.len(), self.triangles.len());
        let cells = lines + triangles;
        writeln!(out, "# vtk DataFile Version 3.0\nsweep-cdt\nASCII")?;
        writeln!(out, "DATASET UNSTRUCTURED_GRID")?;
        writeln!(out, "POINTS {points} double")?;
        self.write_vertices(|_, _| (), &[], out)?;
        writeln!(out, "CELLS {cells} {}", 3 * lines + 4 * triangles)?;
        write_faces(b"2 ", 0, self.lines, out)?;
        write_faces(b"3 ", 0, &self.triangles, out)?;
        writeln!(out, "CELL_TYPES {cells}")?;
        write_rows(out, cells, |at, text| {
            text.extend_from_slice(if at < lines { LINE } else { TRIANGLE });
        })?;
        let others = self.others();
        if !others.is_empty() {
            writeln!(out, "POINT_DATA {points}")?;
        }
        for column in others {
            writeln!(
                out,
                "SCALARS {} double 1\nLOOKUP_TABLE default",
                word(&column.name)
            )?;
            write_rows(out, points, |vertex, text| {
                column.of(vertex).write_text(text);
                text.push(b'\n');
            })?;
        }
        Ok(())
    }

    /// Writes Gmsh's format of version 2.2, numbered from 1.
    pub(super) fn write_msh(&self, out: &mut impl Write) -> io::Result<()> {
        let points = self.file.graph.points.len();
        let (lines, triangles) = (self.lines, &self.triangles);
        writeln!(
            out,
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{points}"
        )?;
        self.write_vertices(
            |vertex, text| {
                number(vertex + 1, text);
                text.push(b' ');
            },
            &[],
            out,
        )?;
        let elements = lines.len() + triangles.len();
        writeln!(out, "$EndNodes\n$Elements\n{elements}")?;
        write_elements(b" 1 0 ", 1, lines, out)?;
        write_elements(b" 2 0 ", lines.len() + 1, triangles, out)?;
        writeln!(out, "$EndElements")
    }

    /// Writes the triangles as STL. The normals are zeros, which leaves them to the reader.
    pub(super) fn write_stl(&self, out: &mut impl Write) -> io::Result<()> {
        writeln!(out, "solid sweep-cdt")?;
        write_rows(out, self.triangles.len(), |t, text| {
            text.extend_from_slice(b"facet normal 0 0 0\nouter loop\n");
            for vertex in self.triangles[t] {
                text.extend_from_slice(b"vertex ");
                self.write_place(vertex, text);
                text.push(b'\n');
            }
            text.extend_from_slice(b"endloop\nendfacet\n");
        })?;
        writeln!(out, "endsolid sweep-cdt")
    }

    /// The columns but the heights.
    pub(super) fn others(&self) -> Vec<&'a Column> {
        let columns = self.file.columns.iter();
        columns
            .filter(|column| column.name != Column::HEIGHT)
            .collect()
    }
}

/// Writes a line for each element of a `.msh`: its number, from `first` on, this text, and the corners.
fn write_elements<const N: usize>(
    kind: &[u8],
    first: usize,
    elements: &[[usize; N]],
    out: &mut impl Write,
) -> io::Result<()> {
    write_rows(out, elements.len(), |at, text| {
        number(at + first, text);
        text.extend_from_slice(kind);
        numbers(elements[at].map(|corner| corner + 1), text);
        text.push(b'\n');
    })
}

/// A name as one word.
fn word(name: &str) -> String {
    let word = name.split_whitespace().collect::<Vec<_>>().join("_");
    if word.is_empty() {
        "unnamed".to_owned()
    } else {
        word
    }
}

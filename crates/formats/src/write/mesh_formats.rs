//! Formats of meshes that fewer programs read: Stanford's, VTK's old one, Gmsh's and STL.

use std::io::{self, Write};

use super::labels::Labels;
use super::mesh::{Mesh, write_faces};
use super::rows::{number, numbers, write_marker, write_rows};
use crate::graph_file::whole;
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
            writeln!(out, "property double {}", one_word(&column.name))?;
        }
        if !self.lines.is_empty() {
            let count = self.lines.len();
            writeln!(
                out,
                "element edge {count}\nproperty int vertex1\nproperty int vertex2"
            )?;
            if !self.markers.is_empty() {
                writeln!(out, "property int {}", Column::MARKER)?;
            }
        }
        if !self.triangles.is_empty() {
            let count = self.triangles.len();
            writeln!(
                out,
                "element face {count}\nproperty list uchar int vertex_indices"
            )?;
            if let Some(labels) = &self.labels {
                writeln!(out, "property double {}", labels.name)?;
            }
        }
        writeln!(out, "end_header")?;
        self.write_vertices(|_, _| (), &others, out)?;
        write_rows(out, self.lines.len(), |line, text| {
            numbers(self.lines[line], text);
            if let Some(marker) = self.markers.get(line) {
                write_marker(*marker, text);
            }
            text.push(b'\n');
        })?;
        write_rows(out, self.triangles.len(), |t, text| {
            text.extend_from_slice(b"3 ");
            numbers(self.triangles[t], text);
            if let Some(labels) = &self.labels {
                text.push(b' ');
                labels.values[t].write_text(text);
            }
            text.push(b'\n');
        })
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
        write_faces(b"2 ", 0, &self.lines, out)?;
        write_faces(b"3 ", 0, &self.triangles, out)?;
        writeln!(out, "CELL_TYPES {cells}")?;
        write_rows(out, cells, |at, text| {
            text.extend_from_slice(if at < lines { LINE } else { TRIANGLE });
        })?;
        if !self.markers.is_empty() || self.labels.is_some() {
            writeln!(out, "CELL_DATA {cells}")?;
        }
        if !self.markers.is_empty() {
            let name = Column::MARKER;
            writeln!(out, "SCALARS {name} long 1\nLOOKUP_TABLE default")?;
            write_rows(out, cells, |cell, text| {
                self.write_marker(cell, text);
                text.push(b'\n');
            })?;
        }
        if let Some(labels) = &self.labels {
            let name = labels.name;
            writeln!(out, "SCALARS {name} double 1\nLOOKUP_TABLE default")?;
            write_rows(out, cells, |cell, text| {
                self.write_label(cell, labels, text);
                text.push(b'\n');
            })?;
        }
        let others = self.others();
        if !others.is_empty() {
            writeln!(out, "POINT_DATA {points}")?;
        }
        for column in others {
            writeln!(
                out,
                "SCALARS {} double 1\nLOOKUP_TABLE default",
                one_word(&column.name)
            )?;
            write_rows(out, points, |vertex, text| {
                column.of(vertex).write_text(text);
                text.push(b'\n');
            })?;
        }
        Ok(())
    }

    /// Writes Gmsh's format of version 2.2, numbered from 1. Physical groups are the markers of lines, those of vertices,
    /// whose elements are points, and the regions or features of triangles, if all are whole numbers.
    pub(super) fn write_msh(&self, out: &mut impl Write) -> io::Result<()> {
        let points = self.file.graph.points.len();
        let (lines, triangles) = (&self.lines, &self.triangles);
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
        let marked = self.file.vertex_markers().unwrap_or_default();
        let marked: Vec<(usize, i64)> = marked
            .into_iter()
            .enumerate()
            .filter(|(_, marker)| *marker != 0)
            .collect();
        let (vertices, groups): (Vec<[usize; 1]>, Vec<i64>) = marked
            .into_iter()
            .map(|(vertex, marker)| ([vertex], marker))
            .unzip();
        let labels = self.labels.as_ref().and_then(|labels| {
            let labels = labels.values.iter().map(|&value| whole(value));
            labels.collect::<Option<Vec<i64>>>()
        });
        // Some programs want as many tags of all elements, where any has one.
        let labels = labels.unwrap_or_default();
        let has_groups = !(groups.is_empty() && self.markers.is_empty() && labels.is_empty());
        let elements = vertices.len() + lines.len() + triangles.len();
        writeln!(out, "$EndNodes\n$Elements\n{elements}")?;
        let grouped = |groups| has_groups.then_some(groups);
        write_elements(b" 15", 1, &vertices, grouped(&groups[..]), out)?;
        let first = vertices.len() + 1;
        write_elements(b" 1", first, lines, grouped(&self.markers), out)?;
        let first = first + lines.len();
        write_elements(b" 2", first, triangles, grouped(&labels), out)?;
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

    /// Appends the marker of a cell: lines come first, and triangles have none.
    pub(super) fn write_marker(&self, cell: usize, text: &mut Vec<u8>) {
        let marker = self.markers.get(cell).copied().unwrap_or_default();
        text.extend_from_slice(itoa::Buffer::new().format(marker).as_bytes());
    }

    /// Appends the region or feature of a cell: lines come first, and have none.
    pub(super) fn write_label(&self, cell: usize, labels: &Labels, text: &mut Vec<u8>) {
        let triangle = cell.checked_sub(self.lines.len());
        let label = triangle.map_or(0.0, |t| labels.values[t]);
        label.write_text(text);
    }

    /// The columns but the heights.
    pub(super) fn others(&self) -> Vec<&'a Column> {
        let columns = self.file.columns.iter();
        columns
            .filter(|column| column.name != Column::HEIGHT)
            .collect()
    }
}

/// Writes a line for each element of a `.msh`: its number, from `first` on, this kind, its
/// group if any element has one, 0 for none, and the corners.
fn write_elements<const N: usize>(
    kind: &[u8],
    first: usize,
    elements: &[[usize; N]],
    groups: Option<&[i64]>,
    out: &mut impl Write,
) -> io::Result<()> {
    write_rows(out, elements.len(), |at, text| {
        number(at + first, text);
        text.extend_from_slice(kind);
        match groups {
            // The second tag is the part of the geometry, which Gmsh wants beside a group.
            Some(groups) => {
                let group = groups.get(at).copied().unwrap_or_default();
                text.extend_from_slice(b" 2");
                write_marker(group, text);
                write_marker(group, text);
            }
            None => text.extend_from_slice(b" 0"),
        }
        text.push(b' ');
        numbers(elements[at].map(|corner| corner + 1), text);
        text.push(b'\n');
    })
}

/// A name as one word, as a `.ply` has them, without `#`, after which many readers take the rest of a line for a comment.
///
/// ```
/// assert_eq!(sweep_cdt_formats::one_word("wind speed #2"), "wind_speed_2");
/// ```
#[must_use]
pub fn one_word(name: &str) -> String {
    let parts = name.split(|c: char| c.is_whitespace() || c == '#');
    let parts: Vec<&str> = parts.filter(|part| !part.is_empty()).collect();
    let word = parts.join("_");
    if word.is_empty() {
        "unnamed".to_owned()
    } else {
        word
    }
}

//! Formats of meshes: vertices, lines and triangles. They have three dimensions: the column `z` is the height, and
//! without one it is 0. Rationals are rounded to doubles, which all of them are read as.

use std::io::{self, Write};

use super::rows::{number, numbers, write_rows};
use crate::{Column, Coordinate, GraphFile};
use sweep_cdt::domain::Domain;

/// What is written: the vertices of a graph with triangles of a result, or with the edges.
pub(super) struct Mesh<'a, S> {
    pub(super) file: &'a GraphFile<S>,
    pub(super) heights: Option<&'a Column>,
    pub(super) lines: &'a [[usize; 2]],
    pub(super) triangles: Vec<[usize; 3]>,
}

impl<'a, S: Coordinate> Mesh<'a, S> {
    /// The triangles inside.
    pub(super) fn of(file: &'a GraphFile<S>, domain: &Domain<'_>) -> Mesh<'a, S> {
        Mesh {
            file,
            heights: file.heights(),
            lines: &[],
            triangles: domain.canonical_triangles(),
        }
    }

    /// The edges.
    pub(super) fn of_graph(file: &'a GraphFile<S>) -> Mesh<'a, S> {
        Mesh {
            file,
            heights: file.heights(),
            lines: &file.graph.edges,
            triangles: Vec::new(),
        }
    }

    /// Writes Wavefront's format, numbered from 1.
    pub(super) fn write_obj(&self, out: &mut impl Write) -> io::Result<()> {
        self.write_vertices(|_, text| text.extend_from_slice(b"v "), &[], out)?;
        write_faces(b"l ", 1, self.lines, out)?;
        write_faces(b"f ", 1, &self.triangles, out)
    }

    /// Writes Geomview's format. A line is a face of two corners.
    pub(super) fn write_off(&self, out: &mut impl Write) -> io::Result<()> {
        let faces = self.lines.len() + self.triangles.len();
        writeln!(out, "OFF\n{} {faces} 0", self.file.graph.points.len())?;
        self.write_vertices(|_, _| (), &[], out)?;
        write_faces(b"2 ", 0, self.lines, out)?;
        write_faces(b"3 ", 0, &self.triangles, out)
    }

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

    /// Writes a line for each vertex: what `before` appends, x, y, z, and its numbers in other columns.
    pub(super) fn write_vertices(
        &self,
        before: impl Fn(usize, &mut Vec<u8>) + Sync + Send,
        others: &[&Column],
        out: &mut impl Write,
    ) -> io::Result<()> {
        write_rows(out, self.file.graph.points.len(), |vertex, text| {
            before(vertex, text);
            self.write_place(vertex, text);
            for column in others {
                text.push(b' ');
                column.of(vertex).write_text(text);
            }
            text.push(b'\n');
        })
    }

    /// Appends x, y and z of a vertex.
    fn write_place(&self, vertex: usize, text: &mut Vec<u8>) {
        for coordinate in &self.file.graph.points[vertex] {
            coordinate.approx().write_text(text);
            text.push(b' ');
        }
        let height = self.heights.map_or(0.0, |column| column.of(vertex));
        height.write_text(text);
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

/// Writes a line for each face: this text, and the corners, numbered from `first`.
pub(super) fn write_faces<const N: usize>(
    before: &[u8],
    first: usize,
    faces: &[[usize; N]],
    out: &mut impl Write,
) -> io::Result<()> {
    write_rows(out, faces.len(), |face, text| {
        text.extend_from_slice(before);
        numbers(faces[face].map(|corner| corner + first), text);
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

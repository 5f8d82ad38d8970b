//! Formats of meshes: vertices, lines and triangles. They have three dimensions: the column `z` is the height, and
//! without one it is 0. Rationals are rounded to doubles, which all of them are read as. The lines of a result are its
//! constrained sides.

use std::borrow::Cow;
use std::io::{self, Write};

use super::labels::{Labels, markers};
use super::rows::{numbers, write_rows};
use crate::{Column, Coordinate, GraphFile, sorted_pairs};
use sweep_cdt::interior::Interior;

/// The mesh that is written: the vertices of a graph with triangles of a result, or with the edges.
pub(super) struct Mesh<'a, S> {
    pub(super) file: &'a GraphFile<S>,
    pub(super) heights: Option<&'a Column>,
    pub(super) lines: Cow<'a, [[usize; 2]]>,
    /// The marker of each line, or none.
    pub(super) markers: Cow<'a, [i64]>,
    pub(super) triangles: Vec<[usize; 3]>,
    /// The region or feature of each triangle.
    pub(super) labels: Option<Labels>,
}

impl<'a, S: Coordinate> Mesh<'a, S> {
    /// The triangles inside.
    pub(super) fn of(file: &'a GraphFile<S>, interior: &Interior<'_>) -> Mesh<'a, S> {
        Mesh {
            triangles: interior.canonical_triangles(),
            lines: Cow::Borrowed(&[]),
            markers: Cow::Borrowed(&[]),
            ..Mesh::of_graph(file)
        }
    }

    /// The mesh with the constrained sides for lines.
    pub(super) fn with_sides(self, interior: &Interior<'_>) -> Mesh<'a, S> {
        Mesh {
            lines: sorted_pairs(interior.constrained_sides()).into(),
            ..self
        }
    }

    /// The mesh with the constrained sides, their markers, and the regions or features of triangles.
    pub(super) fn with_labels(self, interior: &Interior<'_>) -> Mesh<'a, S> {
        let mesh = self.with_sides(interior);
        Mesh {
            markers: markers(mesh.file, interior, &mesh.lines).into(),
            labels: Labels::of(mesh.file, interior, &mesh.triangles),
            ..mesh
        }
    }

    /// The edges.
    pub(super) fn of_graph(file: &'a GraphFile<S>) -> Mesh<'a, S> {
        Mesh {
            file,
            heights: file.heights(),
            lines: Cow::Borrowed(&file.graph.edges),
            markers: Cow::Borrowed(&file.edge_markers),
            triangles: Vec::new(),
            labels: None,
        }
    }

    /// Writes Wavefront's format, numbered from 1.
    pub(super) fn write_obj(&self, out: &mut impl Write) -> io::Result<()> {
        self.write_vertices(|_, text| text.extend_from_slice(b"v "), &[], out)?;
        write_faces(b"l ", 1, &self.lines, out)?;
        write_faces(b"f ", 1, &self.triangles, out)
    }

    /// Writes Geomview's format. A line is a face of two corners.
    pub(super) fn write_off(&self, out: &mut impl Write) -> io::Result<()> {
        let faces = self.lines.len() + self.triangles.len();
        writeln!(out, "OFF\n{} {faces} 0", self.file.graph.points.len())?;
        self.write_vertices(|_, _| (), &[], out)?;
        write_faces(b"2 ", 0, &self.lines, out)?;
        write_faces(b"3 ", 0, &self.triangles, out)
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
    pub(super) fn write_place(&self, vertex: usize, text: &mut Vec<u8>) {
        for coordinate in &self.file.graph.points[vertex] {
            coordinate.approx().write_text(text);
            text.push(b' ');
        }
        let height = self.heights.map_or(0.0, |column| column.of(vertex));
        height.write_text(text);
    }
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

//! Formats of meshes have in common: vertices, lines and faces.
//!
//! An input takes the vertices and the lines; its faces go along beside the graph. A result takes the vertices and the
//! faces, which must be triangles, and no lines. So one file can be both: an input, and its triangulation.

use crate::Faces;
use crate::read::content::{Corners, Edges, Labels, Vertices};
use crate::read::remarks::Remarks;
use crate::read::source::{ReadError, Source, no_vertex};

/// The contents of a file.
pub(super) struct Mesh<'a> {
    pub(super) vertices: Vertices<'a>,
    /// The vertices of the lines and the faces.
    pub(super) cells: Cells,
    /// The file's number of the first line and of the first face.
    pub(super) first: usize,
    pub(super) remarks: Remarks,
}

/// Lines and faces, vertices as the file numbers them.
#[derive(Default)]
pub(super) struct Cells {
    pub(super) lines: Vec<[usize; 2]>,
    /// The marker of each line, or none.
    pub(super) markers: Vec<i64>,
    /// Vertices with their markers.
    pub(super) vertex_markers: Vec<(usize, i64)>,
    pub(super) faces: Faces,
    /// The region of each triangle, or none.
    pub(super) regions: Vec<f64>,
    /// The error of the first cell that a result must not have.
    other: Option<ReadError>,
    /// How many cells are neither lines nor faces.
    pub(super) unread: usize,
}

impl Cells {
    /// Adds a face: of two corners it is a line, of fewer it is nothing. `error` says where it is.
    pub(super) fn add(&mut self, corners: &[usize], error: impl FnOnce(String) -> ReadError) {
        match *corners {
            [] | [_] => {}
            [a, b] => self.lines.push([a, b]),
            [a, b, c] => self.faces.triangles.push([a, b, c]),
            _ => {
                self.faces.others.push(corners.to_vec());
                self.other
                    .get_or_insert_with(|| error(no_triangle(corners.len())));
            }
        }
    }

    /// Adds that there is a cell which is neither a line nor a face, and which a result must not have.
    pub(super) fn refuse(&mut self, error: impl FnOnce() -> ReadError) {
        self.unread += 1;
        self.other.get_or_insert_with(error);
    }

    /// Adds the triangles of a strip: each corner makes one with the two before, every other one turned over.
    pub(super) fn add_strip(&mut self, corners: &[usize]) {
        for (at, window) in corners.windows(3).enumerate() {
            let [a, b, c] = [window[0], window[1], window[2]];
            let triangle = if at % 2 == 0 { [a, b, c] } else { [b, a, c] };
            self.faces.triangles.push(triangle);
        }
    }

    /// Adds lines from each corner to the next.
    pub(super) fn add_lines(&mut self, corners: &[usize]) {
        let pairs = corners.windows(2).map(|pair| [pair[0], pair[1]]);
        self.lines.extend(pairs);
    }
}

/// The fault of a face of so many corners.
pub(super) fn no_triangle(corners: usize) -> String {
    format!(
        "the face has {corners} corners, and only triangles are read: split it, for example by the option \
         `triangulate` of the program that wrote it"
    )
}

impl<'a> Mesh<'a> {
    /// The vertices and the lines, with the faces beside them.
    pub(super) fn into_graph(self) -> Result<Edges<'a>, ReadError> {
        let Mesh {
            vertices,
            cells:
                Cells {
                    lines,
                    markers,
                    vertex_markers,
                    mut faces,
                    unread,
                    ..
                },
            first,
            mut remarks,
        } = self;
        let count = vertices.coordinates.len();
        let mut edges = Vec::with_capacity(lines.len());
        for line in lines {
            for number in line {
                if number
                    .checked_sub(vertices.first)
                    .is_none_or(|at| at >= count)
                {
                    let Source { name, .. } = vertices.source;
                    let why = no_vertex(number, vertices.first, count);
                    let message = format!("line {} of the mesh: {why}", edges.len() + first);
                    return Err(ReadError::of_file(name, message));
                }
            }
            edges.push(line.map(|number| number - vertices.first));
        }
        // A number before the first one becomes one that no vertex has.
        let corners = (faces.triangles.as_flattened_mut().iter_mut())
            .chain(faces.others.iter_mut().flatten());
        corners.for_each(|corner| *corner = corner.wrapping_sub(vertices.first));
        remarks.ignore(unread, "cell of another kind", "cells of other kinds");
        let place = |(number, marker): (usize, i64)| (number.wrapping_sub(vertices.first), marker);
        Ok(Edges {
            vertex_markers: vertex_markers.into_iter().map(place).collect(),
            markers,
            faces,
            remarks,
            ..Edges::without_seeds(vertices, edges, first)
        })
    }

    /// The vertices and the triangles.
    pub(super) fn into_triangles(self) -> Result<Corners<'a>, ReadError> {
        let Cells {
            faces,
            regions,
            other,
            ..
        } = self.cells;
        match other {
            Some(error) => Err(error),
            None => Ok(Corners {
                labels: if regions.is_empty() {
                    Labels::Nothing
                } else {
                    Labels::Attributes(regions)
                },
                triangles: faces.triangles,
                first: self.first,
                first_vertex: self.vertices.first,
                vertices: Some(self.vertices),
                is_soup: false,
            }),
        }
    }
}

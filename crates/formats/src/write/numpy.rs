//! Arrays of NumPy: points, edges and triangles, as `.npy` one of them and as `.npz` all, with names.
//!
//! Points have a row for each: x, y, z if any column follows, and the other columns. Numbers are doubles, and those of
//! vertices whole numbers of 64 bits, the least significant byte first. The archive is not packed, and holds no times: the
//! same data make the same bytes.

use std::io::{self, Write};

use rawzip::ZipArchiveWriter;

use super::mesh::Mesh;
use super::rows::write_rows;
use crate::{Column, Coordinate};

impl<S: Coordinate> Mesh<'_, S> {
    /// Writes the points as a `.npy`.
    pub(super) fn write_points(&self, out: &mut impl Write) -> io::Result<()> {
        let others = self.others();
        let heights = self.heights;
        let has_heights = heights.is_some() || !others.is_empty();
        let graph = &self.file.graph;
        let columns = 2 + usize::from(has_heights) + others.len();
        write_head("<f8", [graph.points.len(), columns], out)?;
        write_rows(out, graph.points.len(), |vertex, bytes| {
            let mut put = |value: f64| bytes.extend_from_slice(&value.to_le_bytes());
            graph.points[vertex].iter().for_each(|x| put(x.approx()));
            let number = |column: Option<&Column>| column.map_or(f64::NAN, |c| c.of(vertex));
            if has_heights {
                put(number(heights));
            }
            others.iter().for_each(|column| put(number(Some(column))));
        })
    }

    /// Writes the triangles as a `.npy`.
    pub(super) fn write_triangles(&self, out: &mut impl Write) -> io::Result<()> {
        write_corners(&self.triangles, out)
    }

    /// Writes a `.npz`: `points`, `edges`, of a result `triangles`, even if there are none, and the seeds of holes and
    /// regions if there are any.
    pub(super) fn write_npz(&self, is_result: bool, out: &mut impl Write) -> io::Result<()> {
        let graph = &self.file.graph;
        let mut archive = ZipArchiveWriter::new(out);
        let mut add = |name: &str, write: &dyn Fn(&mut dyn Write) -> io::Result<()>| {
            let (mut entry, config) = archive.new_file(name).start().map_err(io::Error::other)?;
            let mut writer = config.wrap(&mut entry);
            write(&mut writer)?;
            let (_, sums) = writer.finish().map_err(io::Error::other)?;
            entry.finish(sums).map_err(io::Error::other).map(drop)
        };
        add("points.npy", &|mut out| self.write_points(&mut out))?;
        add("edges.npy", &|mut out| {
            write_corners(&graph.edges, &mut out)
        })?;
        if is_result {
            add("triangles.npy", &|mut out| self.write_triangles(&mut out))?;
        }
        let place = |place: &[S; 2]| place.each_ref().map(S::approx);
        if !graph.holes.is_empty() {
            let rows: Vec<[f64; 2]> = graph.holes.iter().map(place).collect();
            add("holes.npy", &|mut out| write_numbers(&rows, &mut out))?;
        }
        if !graph.regions.is_empty() {
            let row = |region: &sweep_cdt::Region<S>| {
                let [x, y] = place(&region.seed);
                [x, y, region.attribute]
            };
            let rows: Vec<[f64; 3]> = graph.regions.iter().map(row).collect();
            add("regions.npy", &|mut out| write_numbers(&rows, &mut out))?;
        }
        archive.finish().map_err(io::Error::other).map(drop)
    }
}

/// Writes numbers of vertices.
fn write_corners<const N: usize>(list: &[[usize; N]], out: &mut impl Write) -> io::Result<()> {
    write_head("<i8", [list.len(), N], out)?;
    write_rows(out, list.len(), |at, bytes| {
        for corner in list[at] {
            bytes.extend_from_slice(&(corner as u64).to_le_bytes());
        }
    })
}

fn write_numbers<const N: usize>(list: &[[f64; N]], out: &mut impl Write) -> io::Result<()> {
    write_head("<f8", [list.len(), N], out)?;
    write_rows(out, list.len(), |at, bytes| {
        for number in list[at] {
            bytes.extend_from_slice(&number.to_le_bytes());
        }
    })
}

/// Writes the header of a matrix, of 128 bytes in all: the numbers begin at a multiple of 64.
fn write_head(kind: &str, [rows, columns]: [usize; 2], out: &mut impl Write) -> io::Result<()> {
    const LENGTH: usize = 128 - 10;
    let header =
        format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({rows}, {columns}), }}");
    out.write_all(b"\x93NUMPY\x01\x00\x76\x00")?;
    writeln!(out, "{header:<width$}", width = LENGTH - 1)
}

//! CAD's `.dxf` as text: faces of a result, or lines and points of a graph. Nothing but entities is written, which programs
//! read as of version R12. Without heights z is 0.

use std::io::{self, Write};

use super::mesh::Mesh;
use super::rows::{number, write_rows};
use crate::Coordinate;

impl<S: Coordinate> Mesh<'_, S> {
    /// Writes a `3DFACE` for each triangle, a `LINE` for each line, and a `POINT` for each vertex where nothing has
    /// triangles.
    pub(super) fn write_dxf(&self, out: &mut impl Write) -> io::Result<()> {
        out.write_all(b"0\nSECTION\n2\nENTITIES\n")?;
        let points = if self.triangles.is_empty() {
            self.file.graph.points.len()
        } else {
            0
        };
        self.write_entities("POINT", points, |at| [at], out)?;
        self.write_entities("LINE", self.lines.len(), |at| self.lines[at], out)?;
        let face = |at: usize| {
            let [a, b, c] = self.triangles[at];
            [a, b, c, c]
        };
        self.write_entities("3DFACE", self.triangles.len(), face, out)?;
        out.write_all(b"0\nENDSEC\n0\nEOF\n")
    }

    /// Writes entities of a kind, each with places at some vertices.
    fn write_entities<const N: usize>(
        &self,
        kind: &str,
        count: usize,
        vertices: impl Fn(usize) -> [usize; N] + Sync + Send,
        out: &mut impl Write,
    ) -> io::Result<()> {
        write_rows(out, count, |at, text| {
            text.extend_from_slice(format!("0\n{kind}\n8\n0\n").as_bytes());
            for (digit, vertex) in vertices(at).into_iter().enumerate() {
                let [x, y] = self.file.graph.points[vertex].each_ref().map(S::approx);
                let height = self.heights.map_or(0.0, |column| column.of(vertex));
                for (code, value) in [(10, x), (20, y), (30, height)] {
                    // A height that is missing has no code.
                    if value.is_nan() {
                        continue;
                    }
                    number(code + digit, text);
                    text.push(b'\n');
                    value.write_text(text);
                    text.push(b'\n');
                }
            }
        })
    }
}

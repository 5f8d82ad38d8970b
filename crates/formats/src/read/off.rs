//! Geomview's `.off`, as text.
//!
//! ```text
//! OFF                                      may be left out, and may have the counts behind it
//! <vertices> <faces> <edges>               the number of edges may be left out and is not read
//! <x> <y> <z> [more]                       numbered from 0
//! <corners> <vertex> <vertex> ... [color]  two corners: a line
//! ```
//!
//! What follows z is ignored with a remark, colors and normals (`COFF`, `NOFF`, `CNOFF`) for instance, and what follows
//! the corners.
//! Of a line `#` and what follows is a comment.

use crate::read::content::Vertices;
use crate::read::mesh::{Cells, Mesh};
use crate::read::remarks::Remarks;
use crate::read::source::{ReadError, Source};
use crate::read::token_lines::Lines;

/// Reads a `.off`.
pub(super) fn read(source: &Source) -> Result<Mesh<'_>, ReadError> {
    let mut lines = Lines::new(source)?;
    let [vertex_count, face_count] = counts(&mut lines)?;
    let capacity = lines.capacity(vertex_count);
    let mut coordinates = Vec::with_capacity(capacity);
    let mut heights = Vec::with_capacity(capacity);
    let mut remarks = Remarks::default();
    for vertex in 0..vertex_count {
        let mut line = lines.expect_line(|| format!("vertex {} of {vertex_count}", vertex + 1))?;
        coordinates.push(line.coordinates()?);
        heights.push(Some(line.expect_token("a z coordinate")?));
        let more = usize::from(!line.is_empty());
        remarks.ignore(
            more,
            "color or normal of a vertex",
            "colors or normals of vertices",
        );
    }
    let mut cells = Cells::default();
    let mut corners = Vec::new();
    for face in 0..face_count {
        let mut line = lines.expect_line(|| format!("face {} of {face_count}", face + 1))?;
        let count = line.index("a number of corners")?;
        corners.clear();
        for _ in 0..count {
            corners.push(line.index("a vertex's number")?);
        }
        cells.add(&corners, |message| line.error(message));
        remarks.ignore(
            usize::from(!line.is_empty()),
            "color of a face",
            "colors of faces",
        );
    }
    if let Some(line) = lines.next_line() {
        let message = format!("only {vertex_count} vertices and {face_count} faces are announced");
        return Err(line.error(message));
    }
    Ok(Mesh {
        vertices: Vertices::plain(source, coordinates, 0).with_heights(&heights),
        cells,
        first: 0,
        remarks,
    })
}

/// The numbers of vertices and of faces.
fn counts(lines: &mut Lines<'_>) -> Result<[usize; 2], ReadError> {
    const WORDS: [&[u8]; 4] = [b"OFF", b"COFF", b"NOFF", b"CNOFF"];
    let missing = || "the number of vertices".to_owned();
    let mut line = lines.expect_line(missing)?;
    let mut behind = line.clone();
    if WORDS.contains(&behind.expect_token("`OFF`")?) {
        line = match behind.is_empty() {
            true => lines.expect_line(missing)?,
            false => behind,
        };
    }
    Ok([
        line.index("a number of vertices")?,
        line.index("a number of faces")?,
    ])
}

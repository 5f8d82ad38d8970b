//! Triangle's `.ele`.
//!
//! ```text
//! <triangles> 3 <attributes>                               counts; only the first one is needed
//! <triangle> <vertex> <vertex> <vertex> [attributes]       numbered from 0 or from 1
//! ```
//!
//! Vertices are numbered as in the `.node` beside it; without one, from 0 or 1 as the triangles are, as
//! Triangle does.

use crate::formats::read::content::Corners;
use crate::formats::read::records::Records;
use crate::formats::read::source::{ReadError, Source, quoted};
use crate::formats::read::token_lines::Lines;
use crate::formats::read::triangle::read_node;

/// Reads a `.ele`; `node` is the `.node` beside it.
pub(super) fn read<'a>(
    source: &'a Source,
    node: Option<&'a Source>,
) -> Result<Corners<'a>, ReadError> {
    // The line of counts.
    let mut lines = Lines::new(source)?;
    let mut line = lines.expect_line(|| "the number of triangles".to_owned())?;
    let count = line.index("a number of triangles")?;
    match line.token() {
        None | Some(b"3") => {}
        Some(b"6") => {
            return Err(line.error(
                "the triangles have 6 nodes each, and only those of 3 are read: \
                 write them without Triangle's option -o2",
            ));
        }
        Some(b"4") => {
            return Err(
                line.error("the cells have 4 corners, and only triangles are read: split them")
            );
        }
        Some(other) => {
            return Err(line.error(format!("{} is not 3, the number of corners", quoted(other))));
        }
    }

    // The triangles.
    let records = Records {
        name: "triangle",
        number: "a triangle's number",
        count,
    };
    let mut first_triangle = 0;
    let triangles = records.read(&mut lines, &mut first_triangle, |line| {
        let mut corner = || line.index("a vertex's number");
        Ok([corner()?, corner()?, corner()?])
    })?;
    if let Some(line) = lines.next_line() {
        let message = format!("the first line announces only {count} triangles");
        return Err(line.error(message));
    }

    // The vertices, whose numbers begin where the `.node` says, or where those of the triangles do.
    let vertices = node.map(read_node).transpose()?;
    Ok(Corners {
        triangles,
        first: first_triangle,
        first_vertex: vertices
            .as_ref()
            .map_or(first_triangle, |vertices| vertices.first),
        vertices,
    })
}

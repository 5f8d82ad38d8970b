//! STL, as text or binary: triangles, each with the coordinates of its corners.
//!
//! ```text
//! solid <name>
//!   facet normal <x> <y> <z>          normals are not read
//!     outer loop
//!       vertex <x> <y> <z>            three times
//!     endloop
//!   endfacet
//! endsolid <name>
//! ```
//!
//! A binary file has 80 bytes for a title, the number of triangles, and 50 bytes for each: 12 single precision numbers,
//! the last 9 of them the corners, and two bytes more, least significant bytes first. It is one if its length is
//! right for that number, whatever its title begins with.

use crate::read::binary::{Kind, Number};
use crate::read::content::{Corners, Labels, Syntax, Vertices};
use crate::read::source::{ReadError, Source, quoted};
use crate::read::token_lines::Lines;

/// Reads a `.stl`.
pub(super) fn read(source: &Source) -> Result<Corners<'_>, ReadError> {
    let (syntax, coordinates) = match binary(source) {
        Some(coordinates) => {
            let number = Number {
                kind: Kind::F32,
                big_endian: false,
            };
            (Syntax::Binary(number), coordinates)
        }
        None => (Syntax::Plain, text(source)?),
    };
    let triangles = (0..coordinates.len() / 3).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]);
    Ok(Corners {
        triangles: triangles.collect(),
        first: 0,
        first_vertex: 0,
        vertices: Some(Vertices {
            syntax,
            ..Vertices::plain(source, coordinates, 0)
        }),
        is_soup: true,
        labels: Labels::Nothing,
    })
}

/// The corners in a binary file, if it is one.
fn binary(source: &Source) -> Option<Vec<[&[u8]; 2]>> {
    const RECORD: usize = 50;
    let (_, rest) = source.bytes.split_at_checked(80)?;
    let (count, records) = rest.split_first_chunk()?;
    let count = usize::try_from(u32::from_le_bytes(*count)).ok()?;
    if Some(records.len()) != count.checked_mul(RECORD) {
        return None;
    }
    let corners = |record| {
        let numbers: &[u8] = record;
        [12, 24, 36].map(|at| [&numbers[at..at + 4], &numbers[at + 4..at + 8]])
    };
    Some(records.chunks_exact(RECORD).flat_map(corners).collect())
}

/// The corners in a text.
fn text(source: &Source) -> Result<Vec<[&[u8]; 2]>, ReadError> {
    let mut lines = Lines::new(source)?;
    let mut first = lines.expect_line(|| "`solid`".to_owned())?;
    if first.token() != Some(b"solid") {
        let message = "the file is not STL: no text that begins with `solid`, and no binary file, since its \
             length is not right for the number of triangles after the first 80 bytes";
        return Err(ReadError::of_file(&source.name, message));
    }
    let mut corners = Vec::new();
    let mut ends = false;
    while let Some(mut line) = lines.next_line() {
        let keyword = line.expect_token("a keyword")?;
        ends = keyword == b"endsolid";
        match keyword {
            b"vertex" => corners.push(line.coordinates()?),
            b"endfacet" if !corners.len().is_multiple_of(3) => {
                return Err(line.error("the facet has no three corners"));
            }
            b"solid" | b"facet" | b"outer" | b"endloop" | b"endfacet" | b"endsolid" => {}
            other => return Err(line.error(format!("{} is no keyword", quoted(other)))),
        }
    }
    if !ends {
        return Err(ReadError::of_file(
            &source.name,
            "the file ends before `endsolid`",
        ));
    }
    Ok(corners)
}

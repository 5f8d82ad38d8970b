//! Wavefront's `.obj`: the `v` lines, of which z is not read, and the `f` lines.
//!
//! A corner of a face may go on with texture and normal (`7/1/2`), and may count back from the last
//! vertex so far (`-1`). Vertices and faces are numbered from 1. Other statements are read over.

use crate::formats::Coordinate;
use crate::formats::read::lines::{Line, Lines};
use crate::formats::read::result::Content;
use crate::formats::read::{ReadError, Source, Stop, quoted};

/// Reads a `.obj`.
pub(super) fn read<S: Coordinate>(source: &Source) -> Result<Content<S>, Stop> {
    let mut lines = Lines::new(source);
    let (mut points, mut triangles) = (Vec::new(), Vec::new());
    while let Some(mut line) = lines.next_line() {
        match line.token() {
            Some(b"v") => points.push([
                line.coordinate("an x coordinate")?,
                line.coordinate("a y coordinate")?,
            ]),
            Some(b"f") => {
                let mut corner = || corner(&mut line, points.len());
                triangles.push([corner()?, corner()?, corner()?]);
                if line.token().is_some() {
                    let message = "the face has more than 3 corners";
                    return Err(line.error(message.to_owned()).into());
                }
            }
            _ => {}
        }
    }
    Ok(Content {
        triangles,
        first_triangle: 1,
        first_vertex: 1,
        points: Some(points),
    })
}

/// The vertex of a corner, of which `count` were listed so far.
fn corner(line: &mut Line<'_>, count: usize) -> Result<usize, ReadError> {
    const WHAT: &str = "a vertex's number";
    let token = line.expect_token(WHAT)?;
    let end = token.iter().position(|&byte| byte == b'/');
    let number = std::str::from_utf8(&token[..end.unwrap_or(token.len())]).unwrap_or_default();
    let vertex = match number.strip_prefix('-') {
        Some(back) => back
            .parse::<usize>()
            .ok()
            .and_then(|back| (count + 1).checked_sub(back))
            .filter(|vertex| (1..=count).contains(vertex)),
        None => number.parse().ok(),
    };
    vertex.ok_or_else(|| line.error(format!("{} is not {WHAT}", quoted(token))))
}

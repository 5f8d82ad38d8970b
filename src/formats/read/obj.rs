//! Wavefront's `.obj`: x and y of the `v` lines, and the `f` lines.
//!
//! The vertex of a corner may be followed by texture and normal (`7/1/2`), which are ignored, and may
//! be counted back from the last vertex so far (`-1`). Vertices and faces are numbered from 1. Other
//! lines are ignored.

use crate::formats::read::content::{Corners, Syntax, Vertices};
use crate::formats::read::source::{ReadError, Source, quoted};
use crate::formats::read::token_lines::{Line, Lines};

/// Reads a `.obj`.
pub(super) fn read(source: &Source) -> Result<Corners<'_>, ReadError> {
    let mut lines = Lines::new(source)?;
    let (mut coordinates, mut triangles) = (Vec::new(), Vec::new());
    while let Some(mut line) = lines.next_line() {
        match line.token() {
            Some(b"v") => coordinates.push(line.coordinates()?),
            Some(b"f") => {
                let mut corner = || corner(&mut line, coordinates.len());
                triangles.push([corner()?, corner()?, corner()?]);
                if line.token().is_some() {
                    let mut corners = 4;
                    while line.token().is_some() {
                        corners += 1;
                    }
                    return Err(line.error(format!(
                        "the face has {corners} corners, and only triangles are read: split it, \
                         for example by the option `triangulate` of the program that wrote it"
                    )));
                }
            }
            _ => {}
        }
    }
    let vertices = Vertices {
        source,
        syntax: Syntax::Plain,
        coordinates,
        first: 1,
    };
    Ok(Corners {
        triangles,
        first: 1,
        first_vertex: 1,
        vertices: Some(vertices),
    })
}

/// The vertex of a corner, where `count` vertices are listed so far.
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

//! Wavefront's `.obj`: the `v`, `l` and `f` lines of the file.
//!
//! A vertex is x, y and a height z, which may be missing. The vertex of a corner may be followed by texture and
//! normal (`7/1/2`), which are ignored, and may be counted back from the last vertex so far (`-1`). A line may go
//! through more than two vertices. A backslash at the end of a line says that the next one goes on with it. Vertices,
//! lines and faces are numbered from 1. Other lines of the file are ignored with a remark, by their keywords.

use crate::read::content::Vertices;
use crate::read::mesh::{Cells, Mesh};
use crate::read::remarks::Remarks;
use crate::read::source::{ReadError, Source, quoted};
use crate::read::token_lines::{Line, Lines};

/// Reads a `.obj`.
pub(super) fn read(source: &Source) -> Result<Mesh<'_>, ReadError> {
    let mut lines = Lines::new(source)?;
    let (mut coordinates, mut heights) = (Vec::new(), Vec::new());
    let (mut cells, mut remarks) = (Cells::default(), Remarks::default());
    let mut corners = Vec::new();
    while let Some(line) = lines.next_line() {
        let mut line = Wrapped {
            lines: &mut lines,
            line,
        };
        let keyword = line.token();
        let least = match keyword {
            Some(b"v") => {
                let x = line.expect_token("an x coordinate")?;
                coordinates.push([x, line.expect_token("a y coordinate")?]);
                heights.push(line.token());
                continue;
            }
            Some(b"l") => 2,
            Some(b"f") => 3,
            _ => {
                remarks.ignore_named(1, ["line of", "lines of"], keyword.unwrap_or_default());
                continue;
            }
        };
        corners.clear();
        while corners.len() < least || !line.is_empty() {
            corners.push(corner(&mut line, coordinates.len())?);
        }
        if least == 2 {
            cells.add_lines(&corners);
        } else {
            cells.add(&corners, |message| line.line.error(message));
        }
    }
    Ok(Mesh {
        vertices: Vertices::plain(source, coordinates, 1).with_heights(&heights),
        cells,
        first: 1,
        remarks,
    })
}

/// A line, with the lines that go on with it.
struct Wrapped<'a, 'l> {
    lines: &'l mut Lines<'a>,
    line: Line<'a>,
}

impl<'a> Wrapped<'a, '_> {
    fn token(&mut self) -> Option<&'a [u8]> {
        loop {
            let token = self.line.token()?;
            let Some(before) = token.strip_suffix(b"\\").filter(|_| self.line.is_empty()) else {
                return Some(token);
            };
            self.line = self.lines.next_line()?;
            if !before.is_empty() {
                return Some(before);
            }
        }
    }

    /// Whether no token is left, of this line at least.
    fn is_empty(&self) -> bool {
        self.line.is_empty()
    }

    fn expect_token(&mut self, what: &str) -> Result<&'a [u8], ReadError> {
        self.token().ok_or_else(|| {
            self.line
                .error(format!("the line ends where {what} should follow"))
        })
    }
}

/// The vertex of a corner, where `count` vertices are listed so far.
fn corner(line: &mut Wrapped<'_, '_>, count: usize) -> Result<usize, ReadError> {
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
    vertex.ok_or_else(|| line.line.error(format!("{} is not {WHAT}", quoted(token))))
}

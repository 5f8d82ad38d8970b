//! Readers: bytes in, a [`Graph`] or [`Triangles`] out.

mod ele;
mod json;
mod lines;
mod matching;
mod obj;
mod result;
mod triangle;

use std::fmt;

pub use result::{Matching, ResultFormat, Triangles, read_result};

use crate::formats::{Coordinate, Graph, Rational, Unreadable};

/// What [`read()`] understands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum InputFormat {
    /// Triangle's vertices.
    Node,
    /// Triangle's vertices and edges.
    Poly,
    /// An object with `points` and `edges`.
    Json,
}

impl InputFormat {
    /// All of them.
    pub const ALL: [InputFormat; 3] = [InputFormat::Node, InputFormat::Poly, InputFormat::Json];

    /// The name, which is the extension of its files.
    pub fn name(self) -> &'static str {
        match self {
            InputFormat::Node => "node",
            InputFormat::Poly => "poly",
            InputFormat::Json => "json",
        }
    }
}

/// A file in memory.
#[derive(Clone, Debug)]
pub struct Source {
    /// What errors call it.
    pub name: String,
    /// Its contents.
    pub bytes: Vec<u8>,
}

/// What a file holds: rationals if any coordinate in it is a fraction `p/q`, doubles otherwise.
#[derive(Clone, Debug, PartialEq)]
pub enum Input {
    /// All coordinates are decimals, each read as the nearest double.
    Doubles(Graph<f64>),
    /// Some coordinate is a fraction; all are read exactly.
    Rationals(Graph<Rational>),
}

/// Reads a file. `node` is asked for the `.node` beside a `.poly` that holds no vertices.
///
/// ```
/// use sweep_cdt::formats::{Input, InputFormat, Source, read};
///
/// let bytes = br#"{"points": [[0, 0], [1, 0.5]], "edges": [[0, 1]]}"#.to_vec();
/// let source = Source { name: "example".to_owned(), bytes };
/// let Input::Doubles(graph) = read(InputFormat::Json, &source, || unreachable!())? else {
///     unreachable!("no fraction in the file")
/// };
/// assert_eq!(graph.points, [[0.0, 0.0], [1.0, 0.5]]);
/// assert_eq!(graph.edges, [[0, 1]]);
/// # Ok::<(), sweep_cdt::formats::ReadError>(())
/// ```
///
/// # Errors
/// See [`ReadError`].
pub fn read(
    format: InputFormat,
    source: &Source,
    node: impl FnOnce() -> Result<Source, ReadError>,
) -> Result<Input, ReadError> {
    let node = match format {
        InputFormat::Poly if triangle::has_no_vertices(source)? => Some(node()?),
        _ => None,
    };
    match read_as(format, source, node.as_ref()) {
        Ok(graph) => Ok(Input::Doubles(graph)),
        Err(Stop::Fraction) => match read_as(format, source, node.as_ref()) {
            Ok(graph) => Ok(Input::Rationals(graph)),
            Err(Stop::Fraction) => unreachable!("rationals hold fractions"),
            Err(Stop::Bad(error)) => Err(error),
        },
        Err(Stop::Bad(error)) => Err(error),
    }
}

fn read_as<S: Coordinate>(
    format: InputFormat,
    source: &Source,
    node: Option<&Source>,
) -> Result<Graph<S>, Stop> {
    match format {
        InputFormat::Node => triangle::read_node(source),
        InputFormat::Poly => triangle::read_poly(source, node),
        InputFormat::Json => json::read(source),
    }
}

/// Why reading ends early.
enum Stop {
    /// A fraction was met where doubles were read.
    Fraction,
    /// The file is wrong.
    Bad(ReadError),
}

impl From<ReadError> for Stop {
    fn from(error: ReadError) -> Self {
        Stop::Bad(error)
    }
}

/// Where a file is wrong, and how: `file:line:column: message`.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ReadError {
    /// The name of the file.
    pub file: String,
    /// The line, counted from 1, if one is to blame.
    pub line: Option<usize>,
    /// The column, counted from 1, where known.
    pub column: Option<usize>,
    /// What is wrong there.
    pub message: String,
}

impl ReadError {
    /// An error of the whole file: that it cannot be read at all, for instance.
    pub fn of_file(file: impl Into<String>, message: impl Into<String>) -> ReadError {
        ReadError {
            file: file.into(),
            line: None,
            column: None,
            message: message.into(),
        }
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", self.file)?;
        for number in [self.line, self.column].into_iter().flatten() {
            write!(f, "{number}:")?;
        }
        write!(f, " {}", self.message)
    }
}

impl std::error::Error for ReadError {}

/// The coordinate in a token, or the message that says why there is none.
fn coordinate<S: Coordinate>(token: &[u8], error: impl Fn(String) -> ReadError) -> Result<S, Stop> {
    let text = std::str::from_utf8(token).unwrap_or("\u{fffd}");
    S::from_text(text).map_err(|unreadable| match unreadable {
        Unreadable::Fraction => Stop::Fraction,
        Unreadable::NotANumber => error(format!("{} is not a coordinate", quoted(token))).into(),
        Unreadable::TooLong => error(format!("{} has too many digits", quoted(token))).into(),
    })
}

/// A token as shown in messages: on one line and not too long.
fn quoted(token: &[u8]) -> String {
    const LONGEST: usize = 40;
    let text = String::from_utf8_lossy(&token[..token.len().min(4 * LONGEST)]);
    let short: String = text
        .chars()
        .take(LONGEST)
        .flat_map(char::escape_debug)
        .collect();
    let dots = if text.chars().count() > LONGEST {
        "..."
    } else {
        ""
    };
    format!("`{short}{dots}`")
}

//! Inputs that are read in pieces, from front to back.

mod file;
mod lines;
mod ply;
mod raw;

use std::path::Path;

use sweep_cdt_formats::{Named, ReadError};

/// Points and edges that come in pieces: a file, or what a program makes.
pub trait Input {
    /// The name in errors.
    fn name(&self) -> &str;

    /// The numbers of the first point and of the first edge in errors.
    fn first(&self) -> [u64; 2] {
        [0, 0]
    }

    /// Appends the next points, x and y of each. If there are none, no more will come.
    ///
    /// # Errors
    /// The input is wrong there, or cannot be read.
    fn next_points(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError>;

    /// Appends the next edges, by the numbers of their ends from 0. If there are none, no more will come. All points are
    /// read before the first edge.
    ///
    /// # Errors
    /// The input is wrong there, or cannot be read.
    fn next_edges(&mut self, edges: &mut Vec<[u64; 2]>) -> Result<(), ReadError>;

    /// How many bytes of how many are read.
    fn progress(&self) -> (u64, u64) {
        (0, 0)
    }
}

/// A format that is read in pieces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum InputFormat {
    /// Doubles, x and y of each point; little-endian, without a header. Edges may be in a file of their own, as pairs of
    /// whole numbers of 64 bits.
    Raw,
    /// A `.ply`, as text or binary.
    Ply,
}

impl Named for InputFormat {
    const ALL: &'static [Self] = &[InputFormat::Raw, InputFormat::Ply];

    fn name(self) -> &'static str {
        match self {
            InputFormat::Raw => "f64",
            InputFormat::Ply => "ply",
        }
    }
}

/// Opens a file. Its edges may be in another one, as pairs of whole numbers of 64 bits, little-endian; they then are
/// all edges.
///
/// # Errors
/// A file cannot be opened, or does not begin as its format does.
pub fn open(
    path: &Path,
    format: InputFormat,
    edges: Option<&Path>,
) -> Result<Box<dyn Input>, ReadError> {
    let input: Box<dyn Input> = match format {
        InputFormat::Raw => Box::new(raw::Points::open(path)?),
        InputFormat::Ply => Box::new(ply::Ply::open(path)?),
    };
    Ok(match edges {
        None => input,
        Some(edges) => Box::new(raw::WithEdges::open(input, edges)?),
    })
}

//! Inputs that are read in pieces, from front to back.

mod file;
#[cfg(feature = "las")]
mod las;
mod lines;
mod ply;
mod ply_body;
mod raw;
mod text;
mod triangle;

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
    /// Doubles, x and y of each point; little-endian, without a header.
    Raw,
    /// Stanford's `.ply`, as text or binary.
    Ply,
    /// Triangle's `.node`.
    Node,
    /// Triangle's `.poly`, and the `.node` beside it if that has the vertices.
    Poly,
    /// Points as text, a row for each.
    Csv,
    /// Points as text under another name.
    Xyz,
    /// Points as text under another name.
    Txt,
    /// A point cloud of a laser scanner, x and y of each point.
    #[cfg(feature = "las")]
    Las,
    /// A point cloud that is packed.
    #[cfg(feature = "las")]
    Laz,
}

impl Named for InputFormat {
    const ALL: &'static [Self] = &[
        InputFormat::Raw,
        InputFormat::Ply,
        InputFormat::Node,
        InputFormat::Poly,
        InputFormat::Csv,
        InputFormat::Xyz,
        InputFormat::Txt,
        #[cfg(feature = "las")]
        InputFormat::Las,
        #[cfg(feature = "las")]
        InputFormat::Laz,
    ];

    fn name(self) -> &'static str {
        match self {
            InputFormat::Raw => "f64",
            InputFormat::Ply => "ply",
            InputFormat::Node => "node",
            InputFormat::Poly => "poly",
            InputFormat::Csv => "csv",
            InputFormat::Xyz => "xyz",
            InputFormat::Txt => "txt",
            #[cfg(feature = "las")]
            InputFormat::Las => "las",
            #[cfg(feature = "las")]
            InputFormat::Laz => "laz",
        }
    }
}

/// Opens a file. The edges of points alone may be in a file of their own, as pairs of whole numbers of 64 bits,
/// little-endian: the numbers of both ends from 0.
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
        InputFormat::Node => Box::new(triangle::Triangle::open(path, false)?),
        InputFormat::Poly => Box::new(triangle::Triangle::open(path, true)?),
        InputFormat::Csv | InputFormat::Xyz | InputFormat::Txt => Box::new(text::Text::open(path)?),
        #[cfg(feature = "las")]
        InputFormat::Las | InputFormat::Laz => Box::new(las::Cloud::open(path)?),
    };
    let has_edges = matches!(format, InputFormat::Ply | InputFormat::Poly);
    match edges {
        None => Ok(input),
        Some(edges) if has_edges => {
            let (file, edges) = (input.name(), edges.display());
            let message = format!(
                "a .{} has edges itself, and {edges} cannot add any",
                format.name()
            );
            Err(ReadError::of_file(file, message))
        }
        Some(edges) => Ok(Box::new(raw::WithEdges::open(input, edges)?)),
    }
}

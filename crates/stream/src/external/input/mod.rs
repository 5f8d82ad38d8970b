//! Inputs that are read in pieces, from front to back.

mod chained;
mod file;
#[cfg(feature = "las")]
mod las;
mod lines;
mod no_value;
mod ply;
mod ply_body;
mod raw;
mod text;
mod triangle;

use std::fs::File;
use std::ops::Range;
use std::path::Path;

use sweep_cdt_formats::{Column, CoordinateSystem, Format, ReadError, Remark};

pub use self::chained::chained;
use self::file::InputFile;

/// Points and edges that come in pieces: a file, or what a program makes.
pub trait Input {
    /// The name in errors.
    fn name(&self) -> &str;

    /// The part of the input that is read now: numbers in errors are those of this file.
    fn part(&self) -> Part {
        Part::default()
    }

    /// The name of the file of an edge that has come, and its number there.
    fn edge(&self, number: u64) -> (String, u64) {
        (self.name().to_owned(), number + self.part().first[1])
    }

    /// The inputs that follow each other as this one, if there are several.
    fn inputs(&self) -> &[Box<dyn Input>] {
        &[]
    }

    /// Appends the next points, x and y of each. If there are none, no more will come.
    ///
    /// # Errors
    /// The input is wrong there, or cannot be read.
    fn next_points(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError>;

    /// The height of each point that came last, NaN where it has none; `None` if the input gives no heights.
    fn heights(&self) -> Option<&[f64]> {
        None
    }

    /// The other columns of the points that came last, if they are asked for. When all points are read, their names are
    /// those of the columns that hold numbers in the whole file. Before that there may be fewer, or others.
    fn columns(&self) -> &[Column] {
        &[]
    }

    /// Whether edges may come after the points.
    fn has_edges(&self) -> bool {
        true
    }

    /// Appends the next edges, by the numbers of their ends from 0. If there are none, no more will come. All points are
    /// read before the first edge.
    ///
    /// # Errors
    /// The input is wrong there, or cannot be read.
    fn next_edges(&mut self, _edges: &mut Vec<[u64; 2]>) -> Result<(), ReadError> {
        Ok(())
    }

    /// The remarks on the input: what is left out, and what decides which numbers are points. More may be known when all
    /// points are read.
    fn remarks(&self) -> Vec<Remark> {
        Vec::new()
    }

    /// Whether the points have heights in the input, left out or not.
    fn has_heights(&self) -> bool {
        false
    }

    /// The coordinate system of the points, if the input names one.
    fn system(&self) -> Option<CoordinateSystem> {
        None
    }

    /// How many bytes of how many are read.
    fn progress(&self) -> (u64, u64) {
        (0, 0)
    }
}

/// The part of an input that is read now: the only file, or one of several.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// The points of the file, by their numbers in the whole input: edges of the file end at no others. While points come, the end is not known.
    pub points: Range<u64>,
    /// The number of its first edge in the whole input.
    pub edges: u64,
    /// The numbers of the first point and of the first edge in the file.
    pub first: [u64; 2],
}

impl Default for Part {
    /// All of an input, whose points and edges are numbered from 0.
    fn default() -> Part {
        Part {
            points: 0..u64::MAX,
            edges: 0,
            first: [0, 0],
        }
    }
}

/// The formats that are read in pieces. A `.poly` may have its vertices in the `.node` beside it.
pub const FORMATS: &[Format] = &[
    Format::F64,
    Format::Ply,
    Format::Node,
    Format::Poly,
    Format::Csv,
    Format::Xyz,
    Format::Txt,
    #[cfg(feature = "las")]
    Format::Las,
    #[cfg(feature = "las")]
    Format::Laz,
];

/// Opens a file in one of [`FORMATS`]. The edges of points alone may be in a file of their own, as pairs of whole numbers
/// of 64 bits, little-endian: the numbers of both ends from 0.
///
/// # Errors
/// A file cannot be opened or does not begin as its format does; or the format is none of [`FORMATS`].
pub fn open(
    path: &Path,
    format: Format,
    edges: Option<&Path>,
) -> Result<Box<dyn Input>, ReadError> {
    open_chosen(path, format, edges, &Choice::default())
}

/// As many columns are read at most; more are left out.
const MOST_COLUMNS: usize = 1 << 12;

/// The parts of a file that are read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Choice {
    /// Of points as text these columns are x, y and perhaps z, by their names or their places from 1 on, as in
    /// [`Source::columns`](sweep_cdt_formats::Source::columns).
    pub columns: Vec<String>,
    /// Of a `.las` or `.laz` the points of these classes alone, which are then numbered as if there were no others; all
    /// points, if it is empty.
    pub classes: Vec<u8>,
    /// Whether a cloud need have no point of these classes, as one of several tiles.
    pub may_lack_classes: bool,
    /// Whether points come with their heights, if they have any: z of `.ply`, `.las` and text, the first attribute of
    /// `.node` and `.poly`.
    pub heights: bool,
    /// Whether points come with their other columns, beside heights: properties of `.ply`, attributes and markers of `.node` and `.poly`,
    /// columns of numbers of text.
    pub others: bool,
    /// A number that means that there is none, in heights and other columns but markers.
    pub no_value: Option<f64>,
}

/// Opens a file as [`open`] does, and reads what was chosen.
///
/// # Errors
/// The errors of [`open`]; or there is no such column, or the format has no classes.
pub fn open_chosen(
    path: &Path,
    format: Format,
    edges: Option<&Path>,
    choice: &Choice,
) -> Result<Box<dyn Input>, ReadError> {
    // A wrong choice is refused whether the file is there or not.
    format.expect_classes(&path.display().to_string(), &choice.classes)?;
    let node = path.with_extension("node");
    let input = begin(InputFile::open(path)?, Some(&node), format, choice)?;
    with_edges(input, edges)
}

/// Reads an open file of this name from its beginning, as [`open_chosen`] does. A `.poly` must have its vertices itself.
/// While it is read, nobody else may move where the file stands.
///
/// # Errors
/// The errors of [`open_chosen`].
pub fn read_chosen(
    name: &str,
    file: &File,
    format: Format,
    edges: Option<&Path>,
    choice: &Choice,
) -> Result<Box<dyn Input>, ReadError> {
    format.expect_classes(name, &choice.classes)?;
    with_edges(
        begin(InputFile::of(name, file)?, None, format, choice)?,
        edges,
    )
}

fn begin(
    file: InputFile,
    node: Option<&Path>,
    format: Format,
    choice: &Choice,
) -> Result<Box<dyn Input>, ReadError> {
    let input: Box<dyn Input> = match format {
        Format::F64 => Box::new(raw::Points::new(file)?),
        Format::Ply => Box::new(ply::Ply::new(file, choice)?),
        Format::Node => Box::new(triangle::Triangle::of_node(file, choice)?),
        Format::Poly => Box::new(triangle::Triangle::of_poly(file, node, choice)?),
        Format::Csv | Format::Xyz | Format::Txt => Box::new(text::Text::new(file, choice)?),
        #[cfg(feature = "las")]
        Format::Las | Format::Laz => Box::new(las::Cloud::new(file, choice)?),
        _ => {
            let message = format!("a .{} is not read in pieces", format.name());
            return Err(file.error(message));
        }
    };
    Ok(match choice.no_value {
        Some(value) => Box::new(no_value::NoValue::new(input, value)),
        None => input,
    })
}

/// Gives points the edges of a file, if there is one.
fn with_edges(input: Box<dyn Input>, edges: Option<&Path>) -> Result<Box<dyn Input>, ReadError> {
    let Some(edges) = edges else {
        return Ok(input);
    };
    let own = match input.inputs() {
        [] => Some(&input),
        inputs => inputs.iter().find(|input| input.has_edges()),
    };
    if let Some(input) = own.filter(|input| input.has_edges()) {
        let edges = edges.display();
        let message = format!("it has edges itself, and {edges} cannot add any");
        return Err(ReadError::of_file(input.name(), message));
    }
    Ok(Box::new(raw::WithEdges::open(input, edges)?))
}

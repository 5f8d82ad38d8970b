//! Readers: bytes in, a [`GraphFile`](crate::GraphFile) or [`Triangles`] out.

mod binary;
#[cfg(feature = "las")]
mod cloud;
mod content;
mod edited;
mod file;
mod input;
mod json;
mod matching;
mod mesh;
mod msh;
mod names;
mod numpy;
mod obj;
mod off;
mod ply;
mod raised;
mod remarks;
mod result;
mod shapes;
mod source;
mod stl;
mod text;
mod token_lines;
mod triangle;
mod vtk;
mod vtu;
mod words;

/// Parts of the reader of `.ply`, for those who read one in pieces.
pub mod ply_parts {
    pub use super::binary::{Kind, Number};
    pub use super::ply::header::{Element, Encoding, Header, Property};
}
#[cfg(feature = "las")]
pub use cloud::Cloud;
pub use input::{Input, read};
pub use matching::Matching;
pub use matching::listed::Listed;
pub use matching::matched::Matched;
pub use matching::refusal::{Nearest, ResultError, WayOut};
pub use matching::written::Precision;
pub use names::{named_columns, named_height};
pub use raised::{properties_of_rows, raised};
pub use result::{Triangles, added_points, read_result};
pub use source::{ReadError, ReadErrorKind, Source, quoted, reason};

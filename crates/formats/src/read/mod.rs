//! Readers: bytes in, a [`GraphFile`](crate::GraphFile) or [`Triangles`] out.

mod binary;
mod content;
mod file;
mod geojson;
mod input;
mod json;
mod json_faults;
mod json_more;
mod json_pieces;
mod listed;
mod matched;
mod matching;
mod mesh;
mod msh;
mod msh_binary;
mod msh_parts;
mod names;
mod nearby;
mod npy;
mod numpy;
mod obj;
mod off;
mod ply;
mod ply_header;
mod points;
mod refusal;
mod remarks;
mod result;
mod rounded;
mod rounding;
mod rows;
mod shapes;
mod source;
mod stl;
mod token_lines;
mod triangle;
mod vtk;
mod vtk_arrays;
mod vtk_cells;
mod vtu;
mod vtu_arrays;
mod vtu_elements;
mod wkt;
mod words;
mod written;

/// Parts of the reader of `.ply`, for those who read one in pieces.
pub mod ply_parts {
    pub use super::binary::{Kind, Number};
    pub use super::ply_header::{Element, Encoding, Header, Property};
}
pub use input::{Input, read};
pub use listed::Listed;
pub use matched::Matched;
pub use matching::Matching;
pub use refusal::{Nearest, ResultError, WayOut};
pub use result::{Triangles, added_points, read_result};
pub use source::{ReadError, ReadErrorKind, Source, quoted};
pub use written::Precision;

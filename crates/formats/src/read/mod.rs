//! Readers: bytes in, a [`GraphFile`](crate::GraphFile) or [`Triangles`] out.

#[cfg(feature = "mesh-formats")]
mod binary;
mod content;
#[cfg(feature = "mesh-formats")]
mod dxf;
mod file;
#[cfg(feature = "mesh-formats")]
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
#[cfg(feature = "mesh-formats")]
mod msh;
#[cfg(feature = "mesh-formats")]
mod msh_binary;
#[cfg(feature = "mesh-formats")]
mod msh_parts;
mod names;
mod nearby;
#[cfg(feature = "mesh-formats")]
mod npy;
#[cfg(feature = "mesh-formats")]
mod numpy;
mod obj;
mod off;
#[cfg(feature = "mesh-formats")]
mod ply;
#[cfg(feature = "mesh-formats")]
mod ply_header;
mod points;
mod refusal;
mod remarks;
mod result;
mod rounded;
mod rounding;
mod rows;
#[cfg(feature = "mesh-formats")]
mod shapes;
mod source;
#[cfg(feature = "mesh-formats")]
mod stl;
mod token_lines;
mod triangle;
#[cfg(feature = "mesh-formats")]
mod vtk;
#[cfg(feature = "mesh-formats")]
mod vtk_arrays;
#[cfg(feature = "mesh-formats")]
mod vtk_cells;
#[cfg(feature = "mesh-formats")]
mod vtu;
#[cfg(feature = "mesh-formats")]
mod vtu_arrays;
#[cfg(feature = "mesh-formats")]
mod vtu_elements;
#[cfg(feature = "mesh-formats")]
mod wkt;
#[cfg(feature = "mesh-formats")]
mod words;
mod written;

#[cfg(feature = "geo-types")]
pub(crate) use input::merged;
/// Parts of the reader of `.ply`, for those who read one in pieces.
#[cfg(feature = "mesh-formats")]
pub mod ply_parts {
    pub use super::binary::{Kind, Number};
    pub use super::ply_header::{Element, Encoding, Header, Property};
}
pub use input::{Input, InputFormat, read};
pub use listed::Listed;
pub use matched::Matched;
pub use matching::Matching;
pub use refusal::{Nearest, ResultError, WayOut};
pub use result::{ResultFormat, Triangles, added_points, read_result};
pub use source::{ReadError, ReadErrorKind, Source, quoted};
pub use written::Precision;

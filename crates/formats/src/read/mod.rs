//! Readers: bytes in, a [`GraphFile`](crate::GraphFile) or [`Triangles`] out.

mod binary;
mod content;
mod file;
mod geojson;
mod input;
mod json;
mod json_faults;
mod json_pieces;
mod matching;
mod mesh;
mod msh;
mod obj;
mod off;
mod ply;
mod ply_header;
mod result;
mod shapes;
mod source;
mod stl;
mod token_lines;
mod triangle;
mod vtk;
mod vtk_arrays;
mod vtu;
mod vtu_arrays;
mod vtu_elements;
mod wkt;
mod words;

#[cfg(feature = "geo-types")]
pub(crate) use input::merged;
pub use input::{Input, InputFormat, read};
pub use matching::{Matched, Matching};
pub use result::{ResultFormat, Triangles, added_points, read_result};
pub use source::{ReadError, ResultError, Source};

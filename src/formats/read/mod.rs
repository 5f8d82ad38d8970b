//! Readers: bytes in, a [`Graph`](crate::formats::Graph) or [`Triangles`] out.

mod content;
mod input;
mod json;
mod json_faults;
mod json_pieces;
mod matching;
mod obj;
mod result;
mod source;
mod token_lines;
mod triangle;

pub use input::{Input, InputFormat, read};
pub use matching::{Matched, Matching};
pub use result::{ResultFormat, Triangles, added_points, read_result};
pub use source::{ReadError, ResultError, Source};

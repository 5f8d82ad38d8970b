//! Readers: bytes in, a [`Graph`](crate::formats::Graph) or [`Triangles`] out.

mod content;
mod ele;
mod input;
mod json;
mod json_faults;
mod json_pieces;
mod matched;
mod matching;
mod obj;
mod records;
mod result;
mod result_error;
mod rounding;
mod seeds;
mod source;
mod token_lines;
mod triangle;

pub use input::{Input, InputFormat, read};
pub use matched::Matched;
pub use matching::Matching;
pub use result::{ResultFormat, Triangles, read_result};
pub use result_error::ResultError;
pub use source::{ReadError, Source};

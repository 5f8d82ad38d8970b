//! File formats: graphs and triangulations, read and written.
//!
//! | name | read | written |
//! |---|---|---|
//! | `node` | vertices ([Triangle]'s format) | vertices |
//! | `poly` | vertices, edges, and seeds of holes and regions (Triangle's format) | |
//! | `json` | an object with `points` and `edges`, or with `triangles` and maybe `points` | all of them and more |
//! | `ele` | triangles, and the `node` beside it | triangles (Triangle's format) |
//! | `obj` | vertices and triangles | vertices and triangles (Wavefront) |
//! | `svg` | | a picture |
//!
//! Readers take bytes, never panic on any of them, and name the line that is wrong. A byte order mark is
//! skipped; lines end with a line feed, a carriage return or both. Writers list triangles in
//! [canonical order](crate::Triangulation::canonical_triangles), so that what they write depends on nothing
//! but the input.
//!
//! [Triangle]: https://www.cs.cmu.edu/~quake/triangle.html

mod coordinate;
mod cores;
mod graph;
pub(crate) mod pairs;
mod rational;
mod read;
mod write;

pub use coordinate::{Coordinate, CoordinateError};
pub use graph::{Graph, Region};
pub use read::{
    Input, InputFormat, Matched, Matching, ReadError, ResultError, ResultFormat, Source, Triangles,
    read, read_result,
};
pub use write::{OutputFormat, write, write_domain, write_node};

//! File formats: graphs and triangulations, read and written.
//!
//! | name | read | written |
//! |---|---|---|
//! | `node` | vertices ([Triangle]'s format) | vertices |
//! | `poly` | vertices, edges, and seeds of holes and regions (Triangle's format) | the same |
//! | `json` | an object with `points` and `edges`, or with `triangles` and maybe `points` | all of them and more |
//! | `ele` | triangles, and the `node` beside it | triangles (Triangle's format) |
//! | `obj`, `off` | vertices, lines and triangles | the same (Wavefront, Geomview) |
//! | `csv`, `xyz`, `txt` | points and columns, a row for each point | the same; as `csv` also edges that cross, and `json` holds them too |
//! | `ply`, `vtk`, `vtu`, `vtp`, `msh` | vertices, lines and triangles | the same (Stanford, VTK, Gmsh) |
//! | `stl` | triangles by their coordinates | the same |
//! | `geojson`, `wkt` | points, lines, rings of polygons; or triangles | the same (maps) |
//! | `npy`, `npz` | arrays of points, edges and triangles | the same (NumPy) |
//!
//! Heights and other numbers that stand beside the coordinates of vertices are [`Column`]s of a [`GraphFile`], and are
//! written where a format has room for them. So are markers, polygons with their holes, and the coordinate system.
//! [`GraphFile::remarks`] names what a reader ignores, [`not_written`] what an output has no room for. `docs/formats.md`
//! says of each format what is read, written and ignored.
//!
//! Readers take bytes, never panic on any of them, and name the line that is wrong. A byte order mark is
//! skipped; lines end with a line feed, a carriage return or both. Writers list triangles in
//! [canonical order](sweep_cdt::Triangulation::canonical_triangles), so that what they write depends on nothing
//! but the input.
//!
//! [Triangle]: https://www.cs.cmu.edu/~quake/triangle.html

mod doubts;
mod order;

mod coordinate;
mod format;
mod graph_file;
mod layers;
mod messages;
mod numbering;
mod polygons;
mod properties;
mod read;
mod remark;
mod seeds;
mod split;
mod system;
mod threads;
mod write;

pub use coordinate::{Coordinate, CoordinateError, MAX_DIGITS, MAX_EXPONENT, quotient};
pub use doubts::Voids;
pub use format::Format;
pub use graph_file::{Column, Faces, GraphFile, sorted_pairs};
pub use numbering::{Layer, Numbering};
pub use polygons::Polygons;
pub use properties::Properties;
#[cfg(feature = "las")]
pub use read::Cloud;
pub use read::ply_parts as ply;
pub use read::{
    Input, Listed, Matched, Matching, Nearest, Precision, ReadError, ReadErrorKind, ResultError,
    Source, Triangles, WayOut, added_points, named_columns, named_height, properties_of_rows,
    quoted, raised, read, read_result, reason,
};
pub use remark::{NoTriangles, Remark};
pub use seeds::locate_seeds;
pub use split::Splitting;
pub use system::CoordinateSystem;
#[cfg(feature = "geotiff")]
pub use write::write_geotiff;
pub use write::{
    Cell, LineWriter, RasterHead, Ridges, StreamCertificate, edges_along, json_coordinate,
    not_written, one_word, write, write_asc, write_cells, write_certificate, write_crossings,
    write_graph, write_interior, write_lines, write_node, write_ridges, write_violations,
};

/// The example of the README, as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

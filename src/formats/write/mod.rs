//! Writers: a [`Graph`] and its [`Triangulation`] in, text out.

mod ele;
mod json;
mod obj;
mod svg;
mod trails;

use std::io::{self, Write};

pub use ele::write_node;
pub use json::json_coordinate;
pub use svg::write_violations_svg;

use crate::Triangulation;
use crate::formats::{Coordinate, Graph};

/// What [`write()`] makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum OutputFormat {
    /// Triangle's triangles, numbered as the input.
    Ele,
    /// Vertices, edges and the whole result.
    Json,
    /// Wavefront's vertices and faces.
    Obj,
    /// A picture.
    Svg,
}

impl OutputFormat {
    /// All of them.
    pub const ALL: [OutputFormat; 4] = [
        OutputFormat::Ele,
        OutputFormat::Json,
        OutputFormat::Obj,
        OutputFormat::Svg,
    ];

    /// The name, which is the extension of its files.
    pub fn name(self) -> &'static str {
        match self {
            OutputFormat::Ele => "ele",
            OutputFormat::Json => "json",
            OutputFormat::Obj => "obj",
            OutputFormat::Svg => "svg",
        }
    }
}

/// Writes `result`, the triangulation of `graph`.
///
/// # Errors
/// Those of `out`.
pub fn write<S: Coordinate>(
    format: OutputFormat,
    graph: &Graph<S>,
    result: &Triangulation,
    out: &mut impl Write,
) -> io::Result<()> {
    match format {
        OutputFormat::Ele => ele::write(graph, result, out),
        OutputFormat::Json => json::write(graph, result, out),
        OutputFormat::Obj => obj::write(graph, result, out),
        OutputFormat::Svg => svg::write(graph, result, out),
    }
}

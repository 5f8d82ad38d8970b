//! Writers: a [`Graph`] and its [`Triangulation`] in, text out.

mod crossings;
mod json;
mod rows;

use std::io::{self, Write};

pub use crossings::{CrossingsFormat, write_crossings};
pub use rows::write_node;

use crate::Triangulation;
use crate::domain::Domain;
use crate::draw::ResultPicture;
use crate::formats::{Coordinate, Graph};

/// What [`write()`] makes. Each format is named by the extension of its files.
///
/// ```
/// use sweep_cdt::formats::OutputFormat;
///
/// assert_eq!("svg".parse(), Ok(OutputFormat::Svg));
/// assert_eq!(<&str>::from(OutputFormat::Ele), "ele");
/// ```
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, strum::EnumString, strum::IntoStaticStr, strum::VariantArray,
)]
#[strum(ascii_case_insensitive, serialize_all = "lowercase")]
#[non_exhaustive]
pub enum OutputFormat {
    /// Triangle's triangles, numbered as the input.
    Ele,
    /// Triangle's vertices, numbered as the input.
    Node,
    /// Vertices, edges and the whole result.
    Json,
    /// Wavefront's vertices and faces.
    Obj,
    /// A picture.
    Svg,
}

/// Writes `result`, the triangulation of `graph`.
///
/// ```
/// use sweep_cdt::formats::{Graph, OutputFormat, write};
///
/// let graph = Graph { points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], ..Graph::default() };
/// let result = sweep_cdt::triangulate(&graph.points, &graph.edges)?;
/// let mut text = Vec::new();
/// write(OutputFormat::Ele, &graph, &result, &mut text)?;
/// assert_eq!(text, b"1 3 0\n0 0 1 2\n");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
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
        OutputFormat::Json => json::write(graph, result, out),
        OutputFormat::Svg => ResultPicture::new(graph, result).write(out),
        _ => write_domain(format, graph, &Domain::whole(result), out),
    }
}

/// Writes the part of a triangulation of `graph` that is inside a domain: the triangles inside and no others. The
/// vertices are all written, and keep their numbers. A `.ele` has the attributes of regions, if the domain has
/// regions and `graph` lists them.
///
/// ```
/// use sweep_cdt::domain::Rule;
/// use sweep_cdt::formats::{Graph, OutputFormat, write_domain};
///
/// let points = vec![[0.0, 0.0], [4.0, 3.0], [0.0, 6.0], [1.0, 3.0]];
/// let edges = vec![[0, 1], [1, 2], [2, 3], [3, 0]];
/// let graph = Graph { points, edges, ..Graph::default() };
/// let result = sweep_cdt::triangulate(&graph.points, &graph.edges)?;
/// let mut text = Vec::new();
/// write_domain(OutputFormat::Ele, &graph, &result.domain(Rule::EvenOdd)?, &mut text)?;
/// assert_eq!(text, b"2 3 0\n0 0 1 3\n1 1 2 3\n");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Those of `out`.
pub fn write_domain<S: Coordinate>(
    format: OutputFormat,
    graph: &Graph<S>,
    domain: &Domain<'_>,
    out: &mut impl Write,
) -> io::Result<()> {
    match format {
        OutputFormat::Ele => rows::write_ele(graph, domain, out),
        OutputFormat::Node => write_node(graph, out),
        OutputFormat::Json => json::write_domain(graph, domain, out),
        OutputFormat::Obj => rows::write_obj(graph, domain, out),
        OutputFormat::Svg => ResultPicture::new(graph, domain.triangulation())
            .domain(domain)
            .write(out),
    }
}

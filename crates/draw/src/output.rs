//! Results in any format: written as a file, or drawn.

use std::io::{self, Write};

use sweep_cdt::Triangulation;
use sweep_cdt::interior::Interior;
use sweep_cdt_formats::{self as formats, Coordinate, Format, GraphFile};

use crate::ResultPicture;

/// Writes `result`, the triangulation of the graph of `file`, in one of [`Format::OUTPUTS`].
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt_formats::Format;
///
/// let points = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
/// let graph = Pslg { points, ..Pslg::default() };
/// let result = sweep_cdt::triangulate(&graph.points, &graph.edges)?;
/// let mut picture = Vec::new();
/// sweep_cdt_draw::write(Format::Svg, &graph.into(), &result, &mut picture)?;
/// assert!(picture.starts_with(b"<svg"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Errors of `out`, and of [`sweep_cdt_formats::write()`].
pub fn write<S: Coordinate>(
    format: Format,
    file: &GraphFile<S>,
    result: &Triangulation,
    out: &mut impl Write,
) -> io::Result<()> {
    match format {
        Format::Svg => picture(file, result).write(out),
        Format::Png => picture(file, result).write_png(out),
        _ => formats::write(format, file, result, out),
    }
}

/// Writes the part of a triangulation of the graph of `file` that is inside a domain.
///
/// # Errors
/// Errors of `out`, and of [`sweep_cdt_formats::write_interior`].
pub fn write_interior<S: Coordinate>(
    format: Format,
    file: &GraphFile<S>,
    interior: &Interior<'_>,
    out: &mut impl Write,
) -> io::Result<()> {
    let picture = || picture(file, interior.triangulation()).interior(interior);
    match format {
        Format::Svg => picture().write(out),
        Format::Png => picture().write_png(out),
        _ => formats::write_interior(format, file, interior, out),
    }
}

/// The picture of `result`, with the numbers and heights of the file.
fn picture<'a, S: Coordinate>(
    file: &'a GraphFile<S>,
    result: &'a Triangulation,
) -> ResultPicture<'a, S> {
    let picture = ResultPicture::new(&file.graph, result).numbering(file.numbering);
    match file.heights() {
        Some(heights) => picture.heights(heights),
        None => picture,
    }
}

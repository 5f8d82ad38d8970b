//! The form in which a result is written: a format of files, or a picture.

use std::io::{self, Write};

use sweep_cdt::Triangulation;
use sweep_cdt::interior::Interior;
use sweep_cdt_formats::{Coordinate, GraphFile, Named, OutputFormat, write, write_interior};

use crate::ResultPicture;

/// A format of files, or a picture. Each is named by the extension of its files.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt_draw::Output;
/// use sweep_cdt_formats::{Named, OutputFormat};
///
/// assert_eq!(Output::named("svg"), Some(Output::Svg));
/// assert_eq!(Output::named("ele"), Some(Output::File(OutputFormat::Ele)));
///
/// let points = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
/// let graph = Pslg { points, ..Pslg::default() };
/// let result = sweep_cdt::triangulate(&graph.points, &graph.edges)?;
/// let mut picture = Vec::new();
/// Output::Svg.write(&graph.into(), &result, &mut picture)?;
/// assert!(picture.starts_with(b"<svg"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// A format of the crate `sweep-cdt-formats`.
    File(OutputFormat),
    /// A picture.
    Svg,
    /// A picture of pixels.
    Png,
}

/// How many formats of files there are.
const FILES: usize = OutputFormat::ALL.len();

impl Named for Output {
    const ALL: &'static [Output] = &{
        let mut all = [Output::Svg; FILES + 2];
        all[FILES + 1] = Output::Png;
        let mut i = 0;
        while i < FILES {
            all[i] = Output::File(OutputFormat::ALL[i]);
            i += 1;
        }
        all
    };

    fn name(self) -> &'static str {
        match self {
            Output::File(format) => format.name(),
            Output::Svg => "svg",
            Output::Png => "png",
        }
    }
}

impl Output {
    /// Writes `result`, the triangulation of the graph of `file`.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write<S: Coordinate>(
        self,
        file: &GraphFile<S>,
        result: &Triangulation,
        out: &mut impl Write,
    ) -> io::Result<()> {
        match self {
            Output::File(format) => write(format, file, result, out),
            Output::Svg => picture(file, result).write(out),
            Output::Png => picture(file, result).write_png(out),
        }
    }

    /// Writes the part of a triangulation of the graph of `file` that is inside a domain.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write_interior<S: Coordinate>(
        self,
        file: &GraphFile<S>,
        interior: &Interior<'_>,
        out: &mut impl Write,
    ) -> io::Result<()> {
        match self {
            Output::File(format) => write_interior(format, file, interior, out),
            Output::Svg => picture(file, interior.triangulation())
                .interior(interior)
                .write(out),
            Output::Png => picture(file, interior.triangulation())
                .interior(interior)
                .write_png(out),
        }
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

//! What a result is written as: a format of files, or a picture.

use std::io::{self, Write};
use std::str::FromStr;

use strum::{ParseError, VariantArray};
use sweep_cdt::Triangulation;
use sweep_cdt::domain::Domain;
use sweep_cdt_formats::{Coordinate, Graph, OutputFormat, write, write_domain};

use crate::ResultPicture;

/// A format of files, or a picture. Each is named by the extension of its files.
///
/// ```
/// use sweep_cdt_draw::Output;
/// use sweep_cdt_formats::{Graph, OutputFormat};
///
/// assert_eq!("svg".parse(), Ok(Output::Svg));
/// assert_eq!("ele".parse(), Ok(Output::File(OutputFormat::Ele)));
///
/// let points = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
/// let graph = Graph { points, ..Graph::default() };
/// let result = sweep_cdt::triangulate(&graph.points, &graph.edges)?;
/// let mut picture = Vec::new();
/// Output::Svg.write(&graph, &result, &mut picture)?;
/// assert!(picture.starts_with(b"<svg"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// A format of the crate `sweep-cdt-formats`.
    File(OutputFormat),
    /// A picture.
    Svg,
}

/// How many formats of files there are.
const FILES: usize = OutputFormat::VARIANTS.len();

impl VariantArray for Output {
    const VARIANTS: &'static [Output] = &{
        let mut all = [Output::Svg; FILES + 1];
        let mut i = 0;
        while i < FILES {
            all[i] = Output::File(OutputFormat::VARIANTS[i]);
            i += 1;
        }
        all
    };
}

impl FromStr for Output {
    type Err = ParseError;

    fn from_str(name: &str) -> Result<Output, ParseError> {
        if name.eq_ignore_ascii_case("svg") {
            return Ok(Output::Svg);
        }
        name.parse().map(Output::File)
    }
}

impl From<Output> for &'static str {
    fn from(output: Output) -> &'static str {
        match output {
            Output::File(format) => format.into(),
            Output::Svg => "svg",
        }
    }
}

impl Output {
    /// Writes `result`, the triangulation of `graph`.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write<S: Coordinate>(
        self,
        graph: &Graph<S>,
        result: &Triangulation,
        out: &mut impl Write,
    ) -> io::Result<()> {
        match self {
            Output::File(format) => write(format, graph, result, out),
            Output::Svg => ResultPicture::new(graph, result).write(out),
        }
    }

    /// Writes the part of a triangulation of `graph` that is inside a domain.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_domain<S: Coordinate>(
        self,
        graph: &Graph<S>,
        domain: &Domain<'_>,
        out: &mut impl Write,
    ) -> io::Result<()> {
        match self {
            Output::File(format) => write_domain(format, graph, domain, out),
            Output::Svg => ResultPicture::new(graph, domain.triangulation())
                .domain(domain)
                .write(out),
        }
    }
}

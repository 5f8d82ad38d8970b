//! What a result is written as: a format of files, or a picture.

use std::io::{self, Write};
use std::str::FromStr;

use strum::{ParseError, VariantArray};
use sweep_cdt::Triangulation;
use sweep_cdt::domain::Domain;
use sweep_cdt_formats::{Coordinate, GraphFile, OutputFormat, write, write_domain};

use crate::ResultPicture;

/// A format of files, or a picture. Each is named by the extension of its files.
///
/// ```
/// use sweep_cdt::Pslg;
/// use sweep_cdt_draw::Output;
/// use sweep_cdt_formats::OutputFormat;
///
/// assert_eq!("svg".parse(), Ok(Output::Svg));
/// assert_eq!("ele".parse(), Ok(Output::File(OutputFormat::Ele)));
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
    /// Writes `result`, the triangulation of the graph of `file`.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write<S: Coordinate>(
        self,
        file: &GraphFile<S>,
        result: &Triangulation,
        out: &mut impl Write,
    ) -> io::Result<()> {
        match self {
            Output::File(format) => write(format, file, result, out),
            Output::Svg => picture(file, result).write(out),
        }
    }

    /// Writes the part of a triangulation of the graph of `file` that is inside a domain.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_domain<S: Coordinate>(
        self,
        file: &GraphFile<S>,
        domain: &Domain<'_>,
        out: &mut impl Write,
    ) -> io::Result<()> {
        match self {
            Output::File(format) => write_domain(format, file, domain, out),
            Output::Svg => picture(file, domain.triangulation())
                .domain(domain)
                .write(out),
        }
    }
}

/// The picture of `result`, with the numbers of the file.
fn picture<'a, S: Coordinate>(
    file: &'a GraphFile<S>,
    result: &'a Triangulation,
) -> ResultPicture<'a, S> {
    ResultPicture::new(&file.graph, result).numbering(file.numbering)
}

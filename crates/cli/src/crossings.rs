//! `sweep-cdt crossings`: which edges cross, and where.

use std::io::{self, Write};
use std::path::PathBuf;

use num_rational::BigRational;
use sweep_cdt::crossings::{Crossing, Exact, crossings};
use sweep_cdt_draw::CrossingsPicture;
use sweep_cdt_formats::{Coordinate, Format, GraphFile, Input, write_crossings};

use crate::shared::failure::Failure;
use crate::shared::files::{FileArgument, ReadingArgs, format_of_output, format_parser};
use crate::shared::layers::LayersArgs;
use crate::shared::outputs::{Destination, Outputs, refuse_read, refuse_twice};
use crate::shared::places::parts;

/// List the edges that cross
///
/// Lists all pairs of edges that cross at a point that is no vertex, each with that point, as the nearest double
/// and exactly. Such edges have no triangulation; `sweep-cdt triangulate --split-crossings` makes vertices
/// of the points. Edges that meet at vertices, pass through them, overlap or have no length are not listed.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct Crossings {
    #[command(flatten)]
    layers: LayersArgs,

    #[command(flatten)]
    reading: ReadingArgs,

    /// File to write the list to: .csv, .json or .geojson; `-` for standard output
    #[arg(short, long, value_name = "OUTPUT")]
    output: Option<FileArgument>,

    /// Format of standard output, and of an output whose extension tells none
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(Format::CROSSINGS))]
    output_format: Option<Format>,

    /// Print the exact points too, as fractions
    #[arg(long)]
    fractions: bool,

    /// Draw a picture, with close-ups of the first crossings
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
}

const AFTER_HELP: &str = "\
Output, sorted by edges, which are numbered as the input numbers them:
  .csv     edge,other,x,y,near_x,near_y: two edges, their common point exactly (a fraction, if
           it is not whole), and the nearest doubles
  .json    {\"crossings\": [{\"edges\": [i, j], \"point\": [x, y], \"near\": [x, y]}, ...]}; fractions as
           strings: \"1/3\"
  .geojson a point for each pair, at the nearest doubles, with the properties edge, other, x and y
  Without -o they are printed, a line each.

Exit status:
  0  no edges cross   1  some do, or the input is wrong   2  wrong usage

Examples:
  sweep-cdt crossings streets.poly -o crossings.csv --svg crossings.svg
  sweep-cdt triangulate streets.poly --split-crossings -o streets.ele";

impl Crossings {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let target = |file: &FileArgument| -> Result<_, Failure> {
            let format = format_of_output(file, self.output_format, Format::CROSSINGS)?;
            Ok((format, Destination::of(file)?))
        };
        let list = self.output.as_ref().map(target).transpose()?;
        let svg = self.svg.clone().map(Destination::of_path).transpose()?;
        let outputs = || list.iter().map(|(_, list)| list).chain(&svg);
        refuse_twice(outputs())?;
        let mut read = self.reading.files();
        let input = self.layers.read(&mut read)?;
        refuse_read(&read, outputs())?;
        match input {
            Input::Doubles(file) => self.list(&file, list, svg),
            Input::Rationals(file) => self.list(&file, list, svg),
        }
    }

    fn list<S: Coordinate + Exact>(
        &self,
        file: &GraphFile<S>,
        list: Option<(Format, Destination)>,
        svg: Option<Destination>,
    ) -> Result<(), Failure> {
        let name = self.layers.name();
        let (graph, numbering) = (&file.graph, file.numbering);
        let found = crossings(&graph.points, &graph.edges).map_err(|error| {
            let error = file.split_as_numbered(error);
            Failure::Error(format!("{name}: {error}"))
        })?;
        // Standard output holds either the list or a report.
        let is_printed = list.is_none();
        let is_free = list.as_ref().is_none_or(|(_, list)| !list.is_standard());
        let mut outputs = Outputs::default();
        if let Some((format, list)) = list {
            let found = &found;
            outputs.add(list, move |out| {
                write_crossings(format, numbering, found, out)
            })?;
        }
        if let Some(svg) = svg {
            let picture = CrossingsPicture::new(graph, &found).numbering(numbering);
            outputs.add(svg, move |out| picture.write(out))?;
        }
        if is_free {
            outputs.add(Destination::standard(), |out| {
                let (edges, count) = (graph.edges.len(), found.len());
                writeln!(out, "{name}: edges {edges}, crossings {count}")?;
                if is_printed {
                    found
                        .iter()
                        .try_for_each(|pair| print(file, pair, self.fractions, out))?;
                }
                Ok(())
            })?;
        }
        outputs.finish()?;
        if found.is_empty() {
            Ok(())
        } else {
            Err(Failure::Wrong)
        }
    }
}

/// Writes a pair of edges in one line: their numbers in the file, the nearest doubles, the exact point if it is asked
/// for, and their features.
fn print<S: Exact>(
    file: &GraphFile<S>,
    crossing: &Crossing<S>,
    with_fractions: bool,
    out: &mut impl Write,
) -> io::Result<()> {
    let [edge, other] = file.numbering.edges(crossing.edges);
    let [x, y] = crossing.point_f64().map(|x| x.text());
    write!(out, "edges {edge} and {other} cross near ({x}, {y})")?;
    if with_fractions {
        let [x, y] = crossing.point().each_ref().map(BigRational::text);
        write!(out, ", exactly at ({x}, {y})")?;
    }
    writeln!(out, "{}", parts(file, crossing.edges))
}

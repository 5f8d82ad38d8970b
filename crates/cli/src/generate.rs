//! `sweep-cdt generate`: data of many kinds, to try this and other programs with.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use sweep_cdt_formats::{Column, Format, GraphFile, write_graph};
use sweep_cdt_generate::{KINDS, Kind};

use crate::shared::failure::Failure;
use crate::shared::files::{FileArgument, format_of_output, format_parser};
use crate::shared::outputs::{Destination, Outputs};
use crate::shared::resources::has_room;

/// Generate data of many kinds
///
/// Writes points and edges that can be triangulated: the edges do not cross. The same arguments give the same
/// file, byte for byte, on every platform.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct Generate {
    /// Kind of data
    #[arg(value_name = "KIND", value_parser = kind_parser())]
    kind: Kind,

    /// About how many points
    #[arg(value_name = "N", value_parser = clap::value_parser!(u32).range(1..=MOST))]
    points: u32,

    /// Seed of the random numbers
    #[arg(long, value_name = "SEED", default_value_t = 1)]
    seed: u64,

    /// File to write: .poly, .node, .json, .obj, .off, .csv, .xyz, .txt, .ply, .vtk, .vtu, .vtp, .msh, .geojson, .wkt, .npy
    /// or .npz; `-` for standard output
    #[arg(short, long, value_name = "OUTPUT", default_value = "-")]
    output: FileArgument,

    /// Format of an output whose extension tells none [default for standard output: poly]
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(Format::GRAPHS))]
    output_format: Option<Format>,
}

const AFTER_HELP: &str = "\
Output, which the other subcommands read; numbered from 0:
  .poly    Triangle's vertices and segments
  .node    Triangle's vertices; the edges are left out
  .csv, .xyz, .txt, .npy
           the points with their heights; the edges are left out
  .json    {\"points\": [[x, y], ...], \"edges\": [[i, j], ...]}
  .obj, .off, .ply, .vtk, .vtu, .vtp, .msh
           vertices and lines; z is 0 where there are no heights
  .geojson, .wkt
           points and lines
  .npz     arrays of NumPy: points and edges
  Contour lines have heights: an attribute of the vertices, or the third coordinate. Coordinates are
  the shortest decimals that read as the same doubles.

Exit status:
  0  done   1  the output cannot be written   2  wrong usage

Examples:
  sweep-cdt generate contours 100000 -o terrain.poly
  sweep-cdt generate parcels 2000 --seed 7 | sweep-cdt triangulate - --input-format poly";

/// Somewhat fewer than can be triangulated: some kinds make a few more than N.
const MOST: i64 = 100_000_000;

/// Bytes that a point takes while it is made, at most: contour lines take most.
const POINT: u64 = 256;

/// Reads the name of a kind.
fn kind_parser() -> impl TypedValueParser<Value = Kind> {
    let kinds = KINDS
        .iter()
        .map(|kind| PossibleValue::new(kind.name).help(kind.about));
    PossibleValuesParser::new(kinds).map(|name| Kind::named(&name).expect("one of the kinds"))
}

impl Generate {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let poly = self.output.is_standard().then_some(Format::Poly);
        let format = format_of_output(&self.output, self.output_format.or(poly), Format::GRAPHS)?;
        let destination = Destination::of(&self.output)?;
        if !has_room(u64::from(self.points) * POINT) {
            return Err(Failure::Error("out of memory".to_owned()));
        }
        let (graph, heights) = self.kind.graph_and_heights(self.points as usize, self.seed);
        let mut file = GraphFile::from(graph);
        file.columns = heights.into_iter().map(Column::heights).collect();
        let mut outputs = Outputs::default();
        outputs.add(destination, |out| write_graph::<f64>(format, &file, out))?;
        outputs.finish()
    }
}

//! `sweep-cdt heights`: the heights of points on triangulated terrain.

use std::io::Write;

use num_rational::BigRational;
use sweep_cdt::crossings::Exact;
use sweep_cdt_formats::{
    Column, Coordinate, Format, GraphFile, Input, Remark, Source, not_written, raised, write_graph,
};
use sweep_cdt_terrain::Surface;

use crate::shared::arguments::{InputArgs, distance};
use crate::shared::arithmetic::as_rationals;
use crate::shared::failure::Failure;
use crate::shared::files::{FileArgument, FilesRead, format_of_output, format_parser};
use crate::shared::outputs::{Destination, Outputs, refuse_read};
use crate::shared::terrain::{TerrainArgs, Work};

/// Find the heights of points on triangulated terrain
///
/// Triangulates points and edges that have heights, as `sweep-cdt triangulate` does, and gives other points the height
/// of the triangle that they lie in: exactly where, and linear in between. A point on a side or at a vertex has the
/// height there. A point outside has none.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct Heights {
    #[command(flatten)]
    terrain: TerrainArgs,

    /// File with the points, in any format that is read
    #[arg(long, value_name = "POINTS")]
    at: FileArgument,

    /// Format of the points [default: by the extension]
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(Format::INPUTS))]
    at_format: Option<Format>,

    /// The columns of the points that are x, y and perhaps z, as --columns names those of the terrain
    #[arg(long, value_name = "X,Y[,Z]", value_delimiter = ',')]
    at_columns: Vec<String>,

    /// Give a point outside the height of the nearest place on the border that is at most so far away, in the units of
    /// the points: points that lie on the border but for rounding need a distance greater than that
    #[arg(long, value_name = "DISTANCE", value_parser = distance)]
    within: Option<f64>,

    /// File to write, in any format that `generate` writes; `-` for standard output
    #[arg(short, long, value_name = "OUTPUT", default_value = "-")]
    output: FileArgument,

    /// Format of standard output, and of an output whose extension tells none [default: that of the points]
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(Format::GRAPHS))]
    output_format: Option<Format>,
}

const AFTER_HELP: &str = "\
Heights are the third coordinate, the first attribute of the vertices of a .node or .poly, or a
property of the features of a .geojson or column of a .csv (--height-property).
A triangle with a corner that has no height gives none, and a point outside of --inside has none
unless --within is given. Of several nearest places the lowest counts, and of these the leftmost.

Output: a .geojson, .csv, .xyz or .txt that is written in its own format stays as it is, features with
their properties and rows with all their fields, but for heights: third coordinates, or the column of
heights, which is the last one if there was none. In another format: the points in the order of their
file, with their columns, markers and coordinate system where the format has room for them, and their
heights in place of those that they had. Equal points of a map (.geojson, .wkt) are one. A point
without a height has what its format has for that: nothing, or `NaN`. A line says how many there are.

Without --within, time is proportional to points and triangles, times the logarithm, however the points lie.

Exit status:
  0  done   1  wrong input, nothing written   2  wrong usage

Examples:
  sweep-cdt heights terrain.poly --at trees.csv -o trees3d.csv
  sweep-cdt heights survey.geojson --inside even-odd --at wells.geojson -o wells.obj";

impl Heights {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let points = InputArgs::new(self.at.clone(), self.at_format).options("--at-");
        let same = points.format()?;
        let same = Some(same).filter(|same| Format::GRAPHS.contains(same));
        let format = format_of_output(&self.output, self.output_format.or(same), Format::GRAPHS)?;
        let destination = Destination::of(&self.output)?;
        let mut files = self.terrain.files();
        let terrain = self.terrain.read(&mut files)?;
        files.columns.clone_from(&self.at_columns);
        files.keeps_text = same == Some(format) && Format::RAISED.contains(&format);
        let mut source = None;
        let points_read = points.read(&mut files, |read| source = Some(read.clone()))?;
        refuse_read(&files, [&destination])?;
        let to = To {
            name: &points.name(),
            source: source.filter(|_| files.keeps_text),
            format,
            destination,
        };
        match (terrain, points_read) {
            (Input::Doubles(terrain), Input::Doubles(points)) => {
                self.write(&terrain, points, to, &files)
            }
            (terrain, points) => {
                let terrain = as_rationals(&self.terrain.name(), terrain)?;
                let points = as_rationals(to.name, points)?;
                self.write::<BigRational>(&terrain, points, to, &files)
            }
        }
    }

    /// Writes the points with their heights.
    fn write<S: Coordinate + Exact>(
        &self,
        terrain: &GraphFile<S>,
        mut points: GraphFile<S>,
        to: To<'_>,
        files: &FilesRead,
    ) -> Result<(), Failure> {
        let places = &points.graph.points;
        let heights = self.terrain.surface(
            terrain,
            files,
            At {
                places,
                within: self.within,
            },
        )?;
        let heights = Column::heights(
            heights
                .into_iter()
                .map(|height| height.unwrap_or(f64::NAN))
                .collect(),
        );
        let (places, missing) = (heights.values.len(), heights.missing());
        points.columns.retain(|column| column.name != heights.name);
        points.columns.insert(0, heights);
        let To {
            name,
            source,
            format,
            destination,
        } = to;
        let text = source.map(|source| raised(format, &source, &points));
        let text = text.transpose()?.flatten();
        if text.is_none() && Format::OUTPUTS.contains(&format) {
            let lost = not_written(format, &points, None);
            files.say(&destination.name.display().to_string(), lost.as_slice())?;
        }
        let mut outputs = Outputs::default();
        outputs.add(destination, |out| match &text {
            Some(text) => out.write_all(text),
            None => write_graph(format, &points, out),
        })?;
        outputs.finish()?;
        let off = (missing > 0).then_some(Remark::OffTerrain { missing, places });
        files.say(name, off.as_slice())
    }
}

/// Where points go with their heights.
struct To<'a> {
    /// The name of the points in messages.
    name: &'a str,
    /// The file that they were read from, if all else in it stays.
    source: Option<Source>,
    format: Format,
    destination: Destination,
}

/// Points that want heights.
struct At<'a, S> {
    places: &'a [[S; 2]],
    within: Option<f64>,
}

impl<S: Exact> Work<S> for At<'_, S> {
    type Done = Vec<Option<f64>>;

    fn run(self, surface: &Surface<'_, S>) -> Result<Self::Done, Failure> {
        Ok(match self.within {
            Some(distance) => surface.heights_within(self.places, distance),
            None => surface.heights_at(self.places),
        })
    }
}

//! `sweep-cdt heights`: the heights of points on triangulated terrain.

use std::fs::File;
use std::io::Write;
use std::path::Path;

use num_rational::BigRational;
use sweep_cdt::crossings::Exact;
use sweep_cdt_formats::{
    Column, Coordinate, CoordinateSystem, Format, GraphFile, Input, Remark, Source, not_written,
    properties_of_rows, raised, write_graph,
};
use sweep_cdt_terrain::{Raster, Surface};

use crate::shared::arguments::{InputArgs, distance};
use crate::shared::arithmetic::as_rationals;
use crate::shared::failure::Failure;
use crate::shared::files::{FileArgument, FilesRead, format_of_output, format_parser};
use crate::shared::outputs::{Destination, Outputs, refuse_read, refuse_twice};
use crate::shared::raster::{RasterArgs, RasterFormat, say_lost, write_raster};
use crate::shared::terrain::{TerrainArgs, Work};

/// Find the heights of points, or of a grid, on triangulated terrain
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
    #[arg(long, value_name = "POINTS", required_unless_present = "raster")]
    at: Option<FileArgument>,

    /// Format of the points [default: by the extension]
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(Format::INPUTS), requires = "at")]
    at_format: Option<Format>,

    /// The columns of the points that are x, y and perhaps z, as --columns names those of the terrain
    #[arg(long, value_name = "X,Y[,Z]", value_delimiter = ',', requires = "at")]
    at_columns: Vec<String>,

    /// Give a point outside the height of the nearest place on the border that is at most so far away, in the units of
    /// the points: points that lie on the border but for rounding need a distance greater than that
    #[arg(long, value_name = "DISTANCE", value_parser = distance, requires = "at")]
    within: Option<f64>,

    /// File to write, in any format that `generate` writes; `-` for standard output
    #[arg(
        short,
        long,
        value_name = "OUTPUT",
        default_value = "-",
        requires = "at"
    )]
    output: FileArgument,

    /// Format of an output whose extension tells none [default for standard output and a name without extension: that of
    /// the points]
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(Format::GRAPHS), requires = "at")]
    output_format: Option<Format>,

    #[command(flatten)]
    raster: RasterArgs,
}

const AFTER_HELP: &str = "\
Heights are the third coordinate, the first attribute of the vertices of a .node or .poly, or a
property of the features of a .geojson or column of a .csv (--height-property).
A triangle with a corner that has no height gives none, and a point outside of --inside has none
unless --within is given. Of several nearest places the lowest counts, and of these the leftmost.

Output: a .geojson, .csv, .xyz or .txt that is written in its own format stays as it is, features with
their properties and rows with all their fields, but for heights: third coordinates, or the column of
heights, which is the last one if there was none. Rows become features of a .geojson, with all other
fields as properties. In another format: the points in the order of their file, with their columns,
markers and coordinate system where the format has room for them, and their heights in place of those
that they had. A .geojson names the coordinate system of the terrain, if the points have none. Equal
points of a map (.geojson, .wkt) are one. A point without a height has what its format has for that:
nothing, or `NaN`. A line says how many there are.

--raster writes a grid as `sweep-cdt stream --raster` does: .asc, with NODATA_value where no triangle
is, or .tif, with NaN there. Cells cover all points.

Without --within, time is proportional to points and triangles, times the logarithm, however the points lie.

Exit status:
  0  done   1  wrong input, nothing written   2  wrong usage

Examples:
  sweep-cdt heights terrain.poly --at trees.csv -o trees3d.csv
  sweep-cdt heights survey.geojson --inside even-odd --at wells.geojson -o wells.obj
  sweep-cdt heights points.laz breaklines.geojson --class 2 --raster dem.asc --cell 1";

impl Heights {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let raster = self.raster.target()?;
        let mut files = self.terrain.files();
        let Some(at) = &self.at else {
            return match self.read(&mut files)? {
                Input::Doubles(terrain) => self.write(&terrain, None, raster, &files),
                Input::Rationals(terrain) => self.write(&terrain, None, raster, &files),
            };
        };
        let points = InputArgs::new(at.clone(), self.at_format).options("--at-");
        let same = points.format()?;
        let same = Some(same).filter(|same| Format::GRAPHS.contains(same));
        // An extension that is not known may mean a format that is not written.
        let tells_none = self.output.path().and_then(Path::extension).is_none();
        let given = self.output_format.or(same.filter(|_| tells_none));
        let format = format_of_output(&self.output, given, Format::GRAPHS)?;
        let destination = Destination::of(&self.output)?;
        let terrain = self.read(&mut files)?;
        files.columns.clone_from(&self.at_columns);
        let is_table = same.is_some_and(|same| Format::TABLES.contains(&same));
        let has_features = is_table && format == Format::Geojson;
        files.keeps_text = has_features || same == Some(format) && Format::RAISED.contains(&format);
        let mut source = None;
        let points_read = points.read(&mut files, |read| source = Some(read.clone()))?;
        let to = To {
            name: points.name(),
            source: source.filter(|_| files.keeps_text),
            has_features,
            format,
            destination,
        };
        let systems = [
            (&*self.terrain.name(), system_of(&terrain)),
            (&*to.name, system_of(&points_read)),
        ];
        CoordinateSystem::of_all(systems.into_iter())?;
        match (terrain, points_read) {
            (Input::Doubles(terrain), Input::Doubles(points)) => {
                self.write(&terrain, Some((points, to)), raster, &files)
            }
            (terrain, points) => {
                let terrain = as_rationals(&self.terrain.name(), terrain)?;
                let points = as_rationals(&to.name, points)?;
                self.write::<BigRational>(&terrain, Some((points, to)), raster, &files)
            }
        }
    }

    /// Reads the terrain.
    fn read(&self, files: &mut FilesRead) -> Result<Input, Failure> {
        match self.terrain.read(files)? {
            Input::Rationals(_) if self.raster.path().is_some() => {
                let name = self.terrain.name();
                Err(Failure::Error(format!(
                    "{name}: there are fractions, and a grid is made of doubles"
                )))
            }
            terrain => Ok(terrain),
        }
    }

    /// Writes points with their heights, and a grid.
    fn write<S: Coordinate + Exact>(
        &self,
        terrain: &GraphFile<S>,
        at: Option<(GraphFile<S>, To)>,
        raster: Option<(Destination, RasterFormat)>,
        files: &FilesRead,
    ) -> Result<(), Failure> {
        let destinations = || {
            let at = at.iter().map(|(_, to)| &to.destination);
            at.chain(raster.iter().map(|(destination, _)| destination))
        };
        refuse_read(files, destinations())?;
        refuse_twice(destinations())?;
        say_lost(files, raster.as_ref(), terrain.system.as_ref())?;
        let folder = std::env::temp_dir();
        let points = &terrain.graph.points;
        // There is but one zero.
        let intervals =
            [0, 1].map(|axis| range(points.iter().map(|point| point[axis].approx() + 0.0)));
        let grid = self
            .raster
            .begin(&self.terrain.name(), intervals, &folder, GRID)?;
        let work = Asked {
            places: at.as_ref().map_or(&[], |(points, _)| &points.graph.points),
            within: self.within,
            grid,
        };
        let (heights, grid) = self.terrain.surface(terrain, files, work)?;
        let add_grid = |outputs: &mut Outputs<'_>| -> Result<(), Failure> {
            let Some((raster, (destination, format))) = grid.zip(raster) else {
                return Ok(());
            };
            let heights = terrain.heights().into_iter();
            let heights = heights.flat_map(|column| &column.values);
            let head = (range(heights.copied())[0], terrain.system.clone());
            outputs.add(destination, move |out| {
                write_raster(raster, format, head, &folder, out)
            })
        };
        let Some((mut points, to)) = at else {
            let mut outputs = Outputs::default();
            add_grid(&mut outputs)?;
            return outputs.finish();
        };
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
            mut source,
            has_features,
            format,
            destination,
        } = to;
        if let Some(rows) = source.take_if(|_| has_features) {
            points.columns.truncate(1);
            points.properties = properties_of_rows(&rows)?;
        }
        if format == Format::Geojson && points.system.is_none() {
            points.system.clone_from(&terrain.system);
        }
        let text = source.map(|source| raised(format, &source, &points));
        let text = text.transpose()?.flatten();
        if text.is_none() && Format::OUTPUTS.contains(&format) {
            let lost = not_written(format, &points, None);
            files.say(&destination.name.display().to_string(), lost.as_slice())?;
        }
        let mut outputs = Outputs::default();
        add_grid(&mut outputs)?;
        outputs.add(destination, |out| match &text {
            Some(text) => out.write_all(text),
            None => write_graph(format, &points, out),
        })?;
        outputs.finish()?;
        let off = (missing > 0).then_some(Remark::OffTerrain { missing, places });
        files.say(&name, off.as_slice())
    }
}

fn system_of(input: &Input) -> Option<CoordinateSystem> {
    match input {
        Input::Doubles(file) => file.system.clone(),
        Input::Rationals(file) => file.system.clone(),
    }
}

/// The bytes of a grid that are in memory.
const GRID: usize = 512 << 20;

/// The least and the greatest number, but for NaN; the wrong way round without any.
fn range(numbers: impl Iterator<Item = f64>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    numbers.fold(none, |[least, most], x| [least.min(x), most.max(x)])
}

/// Where points go with their heights.
struct To {
    /// The name of the points in messages.
    name: String,
    /// The file that they were read from, if all else in it stays.
    source: Option<Source>,
    /// Whether rows of that become features.
    has_features: bool,
    format: Format,
    destination: Destination,
}

/// Points that want heights, and a grid.
struct Asked<'a, S> {
    places: &'a [[S; 2]],
    within: Option<f64>,
    grid: Option<Raster<File>>,
}

impl<S: Exact> Work<S> for Asked<'_, S> {
    type Done = (Vec<Option<f64>>, Option<Raster<File>>);

    fn run(mut self, surface: &Surface<'_, S>) -> Result<Self::Done, Failure> {
        if let Some(grid) = &mut self.grid {
            let mut triangles = surface.passing();
            let added = triangles.try_for_each(|corners| grid.add(corners));
            added.map_err(|error| Failure::of_file(&std::env::temp_dir(), &error))?;
        }
        let heights = match self.within {
            Some(distance) => surface.heights_within(self.places, distance),
            None => surface.heights_at(self.places),
        };
        Ok((heights, self.grid))
    }
}

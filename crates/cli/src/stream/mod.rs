//! `sweep-cdt stream`: any number of points and edges in, the triangles out as they become final.

mod bands;
mod beside;
mod join;
mod node;
mod numbers;
mod order;
mod output;
mod report;
mod sweeping;
mod terrain;
mod verify;
mod writing;

use std::io;
use std::num::{NonZeroU64, NonZeroUsize};
use std::path::PathBuf;
use std::time::Duration;

use sweep_cdt_stream::external::{Choice, Input, Statistics};
use sweep_cdt_stream::{StreamError, StreamStats, StreamViolation};

use crate::shared::failure::Failure;
use crate::shared::files::{FileArgument, input_names};
use crate::shared::outputs::{Destination, refuse_read, refuse_twice};
use crate::shared::raster::{say_lost, say_system_lost};
use crate::shared::terrain::no_heights;
pub(crate) use join::Join;
use node::Node;
pub(crate) use order::SortArgs;
use output::Format;
use terrain::TerrainOutputs;
pub(crate) use verify::verify_stream;
use writing::Targets;

/// The bar moves each time that so many vertices have come.
const STEP: u64 = 1 << 16;

/// Triangulate more points than memory holds
///
/// Sorts points and edges with a stated memory and temporary files, and sweeps them. Each triangle is written as soon as
/// nothing to come can change it, and forgotten. As a set, the triangles are those of `sweep-cdt triangulate`.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct StreamCommand {
    /// Points and edges: .f64 (doubles, x and y of each point), .ply, .node, .poly, .csv, .xyz or .txt, or .las and .laz in
    /// a build with the feature `las`; `-` for standard input, which is copied to a temporary file. Several are one input,
    /// as tiles of a terrain are: their points are numbered on through all of them
    #[arg(value_name = "INPUT", required = true)]
    inputs: Vec<FileArgument>,

    #[command(flatten)]
    sort: SortArgs,

    /// File to write the triangles to, counter-clockwise: .u32 or .u64 (raw numbers), .ele, .ply or .cert; `-` for standard
    /// output
    #[arg(short, long = "output", value_name = "OUTPUT")]
    output: Option<FileArgument>,

    /// File to write the distinct vertices to, in the order of the sweep: .f64. The triangles then have their numbers in
    /// this file
    #[arg(long, value_name = "FILE", requires = "output")]
    vertices: Option<PathBuf>,

    #[command(flatten)]
    terrain: TerrainOutputs,

    /// Triangulate nothing, but cut the sorted vertices into bands of so many, each a file in the folder OUTPUT, for
    /// `sweep-cdt join`
    #[arg(long, value_name = "N", requires = "output")]
    #[arg(conflicts_with_all = ["vertices", "contours", "raster", "window", "check", "stats"])]
    band: Option<NonZeroU64>,

    /// Triangulate in windows of so many new vertices [default: seven times as many as are alive]
    #[arg(long, value_name = "N")]
    window: Option<NonZeroUsize>,

    /// Verify the triangles on the way, by exact arithmetic that shares no other code with the sweep
    #[arg(long)]
    check: bool,

    /// The columns of a .csv, .xyz or .txt that are x, y and perhaps z, by their names or their places from 1 on
    #[arg(long, value_name = "X,Y[,Z]", value_delimiter = ',')]
    columns: Vec<String>,

    /// A number that means that there is none, in heights and other columns of points: -9999, for example
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    no_value: Option<f64>,

    /// Of a .las or .laz the points of these classes alone: 2 is the ground. Positions count no others
    #[arg(long = "class", value_name = "CLASS", value_delimiter = ',')]
    classes: Vec<u8>,

    /// Refuse inputs that say more than is read, and outputs that have no room for all that is
    #[arg(long)]
    strict: bool,

    /// Print counts, times and bytes as a table
    #[arg(long)]
    stats: bool,
}

const AFTER_HELP: &str = "\
Input:
  .f64     raw doubles, little-endian: x and y of each point. Edges in a file of their own (--edges)
  .ply     vertices and edges, binary or text
  .node, .poly
           Triangle's vertices and segments
  .csv, .xyz, .txt
           points, one a row
  .las, .laz
           points of laser scanners, in a build with the feature `las`
Output:
  .u32, .u64
           three numbers for each triangle, little-endian, of 32 or 64 bits: the positions of its
           corners among the points of the input, from 0. NumPy reads them by fromfile
  .ele     Triangle's elements, with the numbers of the input. A .node beside it gets the points with
           their heights and other columns, unless it was read, or --vertices is given. One that is
           there must have the same contents
  .ply     binary: the points in the order of the input with all columns, and the triangles. Their z is
           the height, NaN where it is missing, or 0 where the input has no heights
  .cert    a certificate for the proved checker, which reads it in as little memory. Equal points are
           there once, and edges of no length are left out
  .geojson, .wkt
           contour lines (--contours), those of `sweep-cdt contours`, in the order in which they are
           complete
  .asc     a grid of heights (--raster), those of `sweep-cdt heights` at the centres of its cells;
           NODATA_value outside
  .tif     the same as GeoTIFF of doubles, in a build with the feature `geotiff`; NaN outside. It has
           the coordinate system of a .las or .laz that names one by a number of the EPSG
  Where more stays alive than --memory holds, the triangles up to there are written to a file whose
  name ends in .incomplete. A run that fails otherwise writes no file.
Memory:
  --memory is for sorting, and then a half for merging and a half for vertices: those that are
  alive and those of a window. A vertex alive takes 800 bytes of it, and two windows are allowed
  whatever it is. The program itself takes up to 48 MiB more. No option bounds the edges of a vertex
  or window, those open at the sweep line, and what --check and a .cert keep of sides that wait.
  With contour lines or a grid a vertex alive takes 2,240 bytes, and lines that are longer than a
  sixteenth of --memory are written in parts.

Exit status:
  0  done   1  wrong input, or too much alive   2  wrong usage

Examples:
  sweep-cdt stream points.f64 -o triangles.u32 --stats
  sweep-cdt stream points.f64 --edges breaklines.u64 --memory 1GiB -o triangles.u32 --check
  sweep-cdt stream points.f64 --vertices sorted.f64 -o triangles.u32
  sweep-cdt stream tile.ply --contours lines.geojson --every 1 --raster dem.asc --cell 0.5
  sweep-cdt stream tiles/*.laz --class 2 --raster dem.tif --cell 1
  sweep-cdt stream points.f64 --band 1000000 -o bands
  sweep-cdt verify --stream points.f64 triangles.u32";

/// How a stream has ended.
struct Outcome {
    ended: Result<StreamStats, Trouble>,
    sorting: Statistics,
    /// The time from the first vertex to the last triangle.
    sweeping: Duration,
    /// How many triangles are written.
    written: u64,
    /// The contour lines in words.
    lines: Option<String>,
}

/// Why a stream ends early.
enum Trouble {
    Order(sweep_cdt_stream::external::Error),
    Stream(StreamError),
    /// Two edges cross, each with the name of its file and its number there.
    Crossing([(String, u64); 2]),
    Violation(StreamViolation),
    Out(io::Error),
    /// Contour lines or the grid cannot be written.
    Terrain(io::Error),
}

impl From<StreamError> for Trouble {
    fn from(error: StreamError) -> Trouble {
        Trouble::Stream(error)
    }
}

impl Trouble {
    /// The trouble with edges as the files of an input number them.
    fn named(self, input: &dyn Input) -> Trouble {
        match self {
            Trouble::Stream(StreamError::CrossingEdges { edges }) => {
                Trouble::Crossing(edges.map(|edge| input.edge(edge)))
            }
            other => other,
        }
    }
}

impl Outcome {
    /// Whether what was written may be of use: all triangles, or all that are final up to some place.
    fn is_kept(&self) -> bool {
        matches!(
            self.ended,
            Ok(_) | Err(Trouble::Stream(StreamError::TooMuchAlive { .. }))
        )
    }
}

impl StreamCommand {
    pub(crate) fn run(self) -> Result<(), Failure> {
        if let Some(size) = self.band {
            return self.cut(size.get());
        }
        let format = self.output.as_ref().map(Format::of_output).transpose()?;
        output::refuse_vertices(self.vertices.as_deref())?;
        let destination = self.output.as_ref().map(Destination::of).transpose()?;
        let vertices = self
            .vertices
            .clone()
            .map(Destination::of_path)
            .transpose()?;
        if let Some((format, destination)) = format.zip(destination.as_ref()) {
            format.suits(destination, vertices.is_some())?;
        }
        let terrain = self.terrain.targets()?;
        let writes_standard = destination.as_ref().is_some_and(Destination::is_standard);
        if self.stats && writes_standard {
            let message = "--stats and `-o -` would both write to standard output";
            return Err(Failure::Usage(message.to_owned()));
        }
        let part = destination.as_ref().map(Destination::part).transpose()?;
        let part = part.flatten();
        let read = self.sort.files(&self.inputs, self.strict);
        let node = match (format, &destination) {
            (Some(Format::Ele), Some(ele)) if vertices.is_none() => {
                Node::beside(ele, &read, self.inputs.len())?
            }
            _ => None,
        };
        let has_columns = format == Some(Format::Ply) || node.is_some();
        let all = || {
            destination
                .iter()
                .chain(&part)
                .chain(&vertices)
                .chain(terrain.all())
                .chain(node.iter().filter_map(Node::written))
        };
        refuse_read(&read, all())?;
        refuse_twice(all())?;
        let name = self.name();
        let sorted =
            self.sort
                .sorted(&self.inputs, self.choice(has_columns), |name, remarks| {
                    read.say(name, remarks)
                })?;
        let has_points = sorted.order.summary().points > 0;
        if self.terrain.is_asked() && !(has_points && sorted.has_heights) {
            return Err(no_heights(&name, has_points));
        }
        say_lost(&read, terrain.raster.as_ref(), sorted.system.as_ref())?;
        if let (Some(system), Some(Format::Ele | Format::Ply)) = (&sorted.system, format)
            && let Some(destination) = &destination
        {
            say_system_lost(&read, destination, system)?;
        }
        let summary = sorted.order.summary();
        if let Some(format) = format {
            format.holds(summary.points)?;
        }
        let kept = match (&part, &destination) {
            (_, None) => String::new(),
            (Some(part), _) => format!("; what is final up to there is in {}", part.name.display()),
            (None, _) => "; what is final up to there is written".to_owned(),
        };
        let targets = Targets {
            triangles: destination.zip(format),
            vertices,
            node,
            terrain,
        };
        let outcome = self.written(sorted, targets, &read)?;
        match writes_standard && outcome.ended.is_ok() {
            true => Ok(()),
            false => self.report(outcome, &summary, &kept),
        }
    }

    /// The name of the input in messages.
    fn name(&self) -> String {
        input_names(&self.inputs)
    }

    /// The parts of the input that are read.
    fn choice(&self, has_columns: bool) -> Choice {
        Choice {
            columns: self.columns.clone(),
            classes: self.classes.clone(),
            heights: self.terrain.is_asked() || has_columns,
            others: has_columns,
            no_value: self.no_value,
            ..Choice::default()
        }
    }
}

fn to_usize(count: u64) -> usize {
    usize::try_from(count).unwrap_or(usize::MAX)
}

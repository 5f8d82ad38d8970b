//! `sweep-cdt stream`: any number of points and edges in, the triangles out as they become final.

mod bands;
mod beside;
mod join;
mod node;
mod numbers;
mod order;
mod output;
mod report;
mod terrain;
mod verify;
mod writing;

use std::io::{self, Write};
use std::num::{NonZeroU64, NonZeroUsize};
use std::path::PathBuf;
use std::time::Duration;

use sweep_cdt::Triangulator;
use sweep_cdt_stream::external::{Bands, Choice, Input, Statistics, Summary, SweepOrder};
use sweep_cdt_stream::{
    Final, Stream, StreamError, StreamStats, StreamVerifier, StreamViolation, settle_all,
};

use crate::shared::failure::Failure;
use crate::shared::files::{FileArgument, input_names};
use crate::shared::outputs::{Destination, refuse_read, refuse_twice};
use crate::shared::raster::say_lost;
use crate::shared::resources::Progress;
use crate::shared::terrain::no_heights;
pub(crate) use join::Join;
use node::Node;
pub(crate) use order::SortArgs;
use order::is_one_place;
use output::{Format, Triangles};
use terrain::{Passing, Terrain, TerrainOutputs};
pub(crate) use verify::verify_stream;
use writing::Targets;

/// So many bytes of memory a vertex takes, new or alive, while its window is triangulated (some 170 were measured). A
/// window has at least as many new ones as are alive.
const BYTES: u64 = 200;
/// So many new vertices for each that is alive has a window whose size nobody gives, and so many at least.
const SHARE: usize = 7;
const WINDOW: usize = 1 << 15;
/// In bands an edge that is open at the sweep line takes as much memory as so many vertices: each band names it.
const OPEN: usize = 6;
/// No band has more, unless as many are alive.
const BAND: usize = 1 << 19;
/// The bar moves each time that so many vertices have come.
const STEP: u64 = 1 << 16;

/// Triangulate more points than memory holds
///
/// Sorts points and edges with a stated memory and temporary files, and sweeps them. Each triangle is written as soon as
/// nothing to come can change it, and forgotten. As a set, the triangles are those of `sweep-cdt triangulate`.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct StreamCommand {
    /// Points and edges: .f64 (doubles, x and y of each point), .ply, .node, .poly, .csv, .xyz or .txt; `-` for standard
    /// input, which is copied to a temporary file. Several are one input, as tiles of a terrain are: their points are
    /// numbered on through all of them
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
        if self.terrain.is_asked() && !sorted.has_heights {
            return Err(no_heights(&name));
        }
        say_lost(&read, terrain.raster.as_ref(), sorted.system.as_ref())?;
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
        }
    }

    /// Takes all vertices in order, and passes on what is final.
    fn swept(
        &self,
        order: &mut SweepOrder,
        triangles: Option<&mut Triangles<'_, '_, '_>>,
        mut vertices: Option<&mut dyn Write>,
        terrain: Option<&Passing<'_>>,
    ) -> Result<StreamStats, Trouble> {
        let is_renumbered =
            vertices.is_some() || triangles.as_ref().is_some_and(|out| out.is_certificate());
        let of_edges = OPEN.saturating_mul(to_usize(order.summary().open_edges));
        let is_plain = !is_renumbered && terrain.is_none() && !self.check;
        if is_plain && self.window.is_none() && of_edges <= self.most() / 2 {
            return self.swept_in_bands(order, triangles, of_edges);
        }
        // The stream then numbers distinct vertices as they come.
        let is_counted = is_renumbered || terrain.is_some();
        let Summary { points, x, .. } = order.summary();
        let mut progress = Progress::new("sweeping");
        // What the closure meets cannot end the stream from there.
        let trouble = std::cell::RefCell::new(None);
        let verifier = std::cell::RefCell::new(self.check.then(StreamVerifier::new));
        let triangles = std::cell::RefCell::new(triangles);
        let mut found = |found| {
            let mut trouble = trouble.borrow_mut();
            if trouble.is_some() {
                return;
            }
            if let Some(Err(error)) = terrain.map(|terrain| terrain.found(&found)) {
                *trouble = Some(Trouble::Terrain(error));
            }
            let named = match (found, terrain) {
                (Final::Triangle { corners, .. }, Some(terrain)) if !is_renumbered => {
                    Some(corners.map(|v| terrain.number(v)))
                }
                (Final::Triangle { corners, .. }, _) => Some(corners),
                _ => None,
            };
            let mut triangles = triangles.borrow_mut();
            if let Some(Err(error)) = triangles.as_mut().map(|out| out.found(&found, named)) {
                *trouble = Some(Trouble::Out(error));
            }
            if let Final::Triangle {
                corners,
                constrained,
            } = found
            {
                let mut verifier = verifier.borrow_mut();
                let verifier = verifier.as_mut();
                let judged = verifier.map(|verifier| verifier.triangle(corners, Some(constrained)));
                if let Some(Err(violation)) = judged {
                    *trouble = Some(Trouble::Violation(violation));
                }
            }
        };
        let most = self.most();
        let stream = Stream::<f64, _>::new(Triangulator::new(), &mut found);
        let mut stream = stream.limit(most / 2);
        if points > 0 {
            stream = stream.between(x[0], x[1]);
        }
        if let Some(window) = self.window {
            stream = stream.window(window.get());
        }
        let mut done: u64 = 0;
        let mut most_alive = 0;
        let mut last: Option<([f64; 2], u64)> = None;
        while let Some(vertex) = order.next_vertex().map_err(Trouble::Order)? {
            let point = vertex.point;
            let known = last.filter(|&(place, _)| is_one_place(place, point));
            let number = match (terrain, last) {
                (Some(terrain), _) => terrain.vertex(&vertex, known.map(|(_, before)| before)),
                (None, _) if !is_renumbered => vertex.number,
                (None, None) => 0,
                // Equal points are one vertex.
                (None, Some((_, before))) => before + u64::from(known.is_none()),
            };
            if known.is_none()
                && let Some(out) = &mut vertices
            {
                let bytes = point.map(f64::to_le_bytes);
                out.write_all(bytes.as_flattened()).map_err(Trouble::Out)?;
            }
            if known.is_none()
                && let Some(out) = triangles.borrow_mut().as_mut()
            {
                out.vertex(point).map_err(Trouble::Out)?;
            }
            stream.push(number, point).map_err(Trouble::Stream)?;
            if let Some(terrain) = terrain {
                terrain.forget(&stream);
            }
            let alive = stream.stats().most_alive.vertices;
            if self.window.is_none() && alive > most_alive && alive > most / (1 + SHARE) {
                most_alive = alive;
                stream = stream.window(most - alive);
            }
            let first = known.map_or(number, |(_, first)| first);
            if let Some(verifier) = verifier.borrow_mut().as_mut() {
                let judged = match known {
                    None => verifier.vertex(number, point),
                    Some(_) if is_counted => Ok(()),
                    Some(_) => verifier.duplicate(number, &point, first),
                };
                judged.map_err(Trouble::Violation)?;
                for &(edge, upper) in vertex.upper {
                    verifier
                        .edge(edge, first, upper)
                        .map_err(Trouble::Violation)?;
                }
            }
            last = Some((point, first));
            for &(edge, upper) in vertex.upper {
                stream.edge(edge, upper).map_err(Trouble::Stream)?;
                if let Some(out) = triangles.borrow_mut().as_mut() {
                    out.edge(upper);
                }
            }
            done += 1;
            if done.is_multiple_of(STEP) {
                progress.show(to_usize(done), to_usize(points));
                if let Some(trouble) = trouble.take() {
                    return Err(trouble);
                }
            }
        }
        let stats = stream.finish().map_err(Trouble::Stream)?;
        if let Some(trouble) = trouble.take() {
            return Err(trouble);
        }
        if let Some(verifier) = verifier.take() {
            verifier.finish().map_err(Trouble::Violation)?;
        }
        Ok(stats)
    }

    /// Takes all vertices in bands, which all cores triangulate, and passes on what is final. Edges that are open at once
    /// take as much memory as so many vertices.
    fn swept_in_bands(
        &self,
        order: &mut SweepOrder,
        mut triangles: Option<&mut Triangles<'_, '_, '_>>,
        of_edges: usize,
    ) -> Result<StreamStats, Trouble> {
        let Summary { points, edges, .. } = order.summary();
        // All bands in memory take as much as four vertices for each vertex of one, and as three for each edge.
        let weight = to_usize(4 + edges.saturating_mul(3).div_ceil(points.max(1)));
        let points = to_usize(points);
        let mut bands = Bands::new(order, 1).map_err(Trouble::Order)?;
        let mut progress = Progress::new("sweeping");
        // The closure that gets what is final cannot end the stream.
        let trouble = std::cell::RefCell::new(None);
        let most = self.most();
        let next = |alive: usize| -> Result<_, Trouble> {
            trouble.take().map_or(Ok(()), Err)?;
            let room = most.saturating_sub(alive + of_edges);
            let size = (room / weight).min(BAND.max(SHARE * alive / 4));
            bands.resize(size as u64);
            let band = bands.next_band().map_err(Trouble::Order)?;
            progress.show(to_usize(bands.done()), points);
            Ok(band)
        };
        let stats = settle_all(
            next,
            |band| Ok(band.into()),
            most / 2,
            |found| {
                let corners = match found {
                    Final::Triangle { corners, .. } => Some(corners),
                    _ => None,
                };
                let mut trouble = trouble.borrow_mut();
                if let (None, Some(out)) = (&*trouble, &mut triangles) {
                    *trouble = out.found(&found, corners).err().map(Trouble::Out);
                }
            },
        )?;
        trouble.take().map_or(Ok(stats), Err)
    }

    /// How many vertices there may be in memory, of which half may be alive. The other half of the memory is for what is
    /// merged. Two windows are held whatever the memory.
    fn most(&self) -> usize {
        let most = self.sort.memory().saturating_mul(2) / self.bytes();
        let most = usize::try_from(most).unwrap_or(usize::MAX);
        let window = self.window.map_or(WINDOW, NonZeroUsize::get);
        most.max(window.saturating_mul(2))
    }

    /// How many bytes of memory there must be for each vertex that is alive. With a terrain lines and rows have a quarter of
    /// it, since they grow twofold.
    fn bytes(&self) -> u64 {
        match self.terrain.is_asked() {
            false => 4 * BYTES,
            true => 8 * (BYTES + Terrain::BYTES),
        }
    }
}

fn to_usize(count: u64) -> usize {
    usize::try_from(count).unwrap_or(usize::MAX)
}

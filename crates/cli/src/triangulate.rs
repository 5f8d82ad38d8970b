//! `sweep-cdt triangulate`: points and edges in, their triangulation out.

use std::io::{self, Write};
use std::num::NonZeroUsize;

use sweep_cdt::Triangulation;
use sweep_cdt::interior::Interior;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::{Level, Verifier};
use sweep_cdt_engine::{headline, remarks, without_heights};
use sweep_cdt_formats::{Coordinate, Splitting};

use crate::shared::arguments::{OutputArgs, Target, add, completed, has_standard, say_losses};
use crate::shared::arithmetic::{Given, Job, ScalarArgs};
use crate::shared::earlier::Earlier;
use crate::shared::failure::Failure;
use crate::shared::files::{FileArgument, FilesRead, ReadingArgs};
use crate::shared::inside::InsideArgs;
use crate::shared::layers::LayersArgs;
use crate::shared::missing::MissingArgs;
use crate::shared::outputs::{Destination, Outputs, refuse_read, refuse_twice};
use crate::shared::places::located;
use crate::shared::resources::limit_threads;
use crate::shared::settings::Settings;
use crate::shared::splitting::{SplitArgs, triangulated, write_splitting};
use crate::shared::tables::{write_json, write_statistics};
use crate::shared::verification::verify;

/// Triangulate points and edges
///
/// Reads points and edges and writes their constrained Delaunay triangulation. The triangles cover the
/// convex hull of the points. Every edge is a side of triangles, or a chain of sides where points lie on
/// it. Every other side is locally Delaunay. Of these triangles those inside are written, by --inside. Without
/// -o a summary is printed.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct Triangulate {
    #[command(flatten)]
    layers: LayersArgs,

    #[command(flatten)]
    reading: ReadingArgs,

    #[command(flatten)]
    inside: InsideArgs,

    #[command(flatten)]
    missing: MissingArgs,

    #[command(flatten)]
    output: OutputArgs,

    #[command(flatten)]
    split: SplitArgs,

    /// Print counts, times and memory as a table
    #[arg(long)]
    stats: bool,

    /// Write counts, times and memory to this file as JSON; `-` for standard output
    ///
    /// One object, whose members have the names of the fields of `Stats`, `Counters` and `ByCause` in the
    /// documentation of the library: times in seconds, memory in bytes. Besides, `means` has the mean depth of
    /// a legalization in tests and in flips, and the mean length of the front. All but the three times are
    /// the same in every run. See --threads.
    #[arg(long, value_name = "FILE")]
    stats_json: Option<FileArgument>,

    /// Verify the result before anything is written
    ///
    /// The triangles of the whole hull are verified. The verifier shares the signs (filter and exact
    /// predicates) with the sweep and nothing else; see `sweep-cdt verify`.
    #[arg(long)]
    verify: bool,

    /// Threads to work on [default: as many as there are cores]
    ///
    /// A large input is cut into bands, one for each thread, 256 at most. The files are the same, byte for byte. With
    /// --stats or --stats-json one thread triangulates. A bar shows the progress of one thread only.
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,

    #[command(flatten)]
    scalar: ScalarArgs,

    #[command(flatten)]
    settings: Settings,
}

const AFTER_HELP: &str = "\
Input:
  .node    Triangle's vertices; numbered from 0 or 1
  .poly    Triangle's vertices and segments; with 0 vertices, those of the .node beside it.
           Seeds of holes and regions are read for --inside; markers go with vertices and edges
  .json    {\"points\": [[x, y], ...], \"edges\": [[i, j], ...]}; fractions as strings: \"1/3\".
           They may be called vertices and segments. Also holes, regions, markers, columns and crs
  .obj, .off, .ply, .vtk, .vtu, .vtp, .msh
           vertices, and lines for edges; faces with --faces. All but the first two may be binary
  .csv, .xyz, .txt
           points, one a row; the columns x, y and z, or lon, lat and so on, by their names, or in this order
  .las, .laz
           points of laser scanners with their heights, in a build with the feature `las`; see --class
  .npy, .npz
           points as an array of NumPy; or points and edges as arrays with these names
  .geojson, .wkt
           points, and lines and rings of polygons for edges; equal points become one vertex.
           The holes of each polygon are known (--inside polygons)
  Heights (a third coordinate, or the first attribute of a vertex) and other columns of the vertices
  change nothing, and go with the vertices to the outputs that have room for them.
  A note says what else a file says, and what an output has no room for; see --strict.

Output, with the triangles always in the same order:
  .ele     Triangle's triangles, numbered as the input, with the attributes of regions or the numbers
           of features (polygons, from 1). A .node with
           the vertices is written beside it, unless there is one with the same vertices. One with
           others is not overwritten unless it is an output, too
  .node    Triangle's vertices, numbered as the input
  .json    points, edges, triangles, neighbors, constrained sides, hull, duplicates, and the chain
           of vertices along each edge; numbered from 0. With --inside also the boundary, and the
           region or feature of each triangle. With --split-crossings also the chain of each edge of the input
  .obj, .off, .ply, .vtk, .vtu, .vtp, .msh, .stl
           vertices, triangles and constrained sides (not in .off and .stl), as text; z is the height,
           or 0 where no vertex has one
  .cert    a certificate for the proved checker (the folder proof of the repository): integers times a
           power of two, edges, all triangles, which of them are inside (by the rules hull, polygons,
           even-odd and nonzero), and hints
  .geojson, .wkt
           a polygon for each triangle, in .geojson with its region or feature, and the properties of that
  .npy, .npz
           triangles as an array of NumPy; or points, edges and triangles as arrays with these names
  .svg, .png
           a picture: triangles grey, edges blue, hull (or border) orange; with heights, triangles
           coloured by height with hill shading
  Outputs appear when all are complete; a run that fails changes no file. No file is overwritten that
  was read. Symbolic links are followed, FIFOs and devices written to, permissions kept.

Exit status:
  0  done   1  wrong input, nothing written   2  wrong usage

Examples:
  sweep-cdt triangulate terrain.poly -o terrain.svg
  sweep-cdt triangulate terrain.poly -o terrain.ele -o terrain.json --stats
  sweep-cdt triangulate polygon.json --inside even-odd -o polygon.obj
  sweep-cdt triangulate streets.poly --split-crossings -o streets.json --verify
  sweep-cdt triangulate contours.geojson border.geojson breaklines.wkt -o terrain.vtu
  generate | sweep-cdt triangulate - --input-format json -o - --output-format obj | view";

impl Triangulate {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let targets = self.output.targets()?;
        let certificates = targets.iter().filter(|target| target.is_certificate());
        let earlier = Earlier::of(certificates.map(|target| &*target.destination.name));
        earlier.note_if_failed(self.triangulated(targets))
    }

    fn triangulated(&self, targets: Vec<Target>) -> Result<(), Failure> {
        let json = self.stats_json.as_ref().map(Destination::of).transpose()?;
        let to_standard = [
            ("--stats", self.stats),
            (
                "`--stats-json -`",
                json.as_ref().is_some_and(Destination::is_standard),
            ),
            ("`-o -`", has_standard(&targets)),
        ];
        let mut to_standard = to_standard.iter().filter(|(_, is_there)| *is_there);
        if let (Some((one, _)), Some((other, _))) = (to_standard.next(), to_standard.next()) {
            let message = format!("{one} and {other} would both write to standard output");
            return Err(Failure::Usage(message));
        }
        if let Some(threads) = self.threads {
            limit_threads(threads);
        }
        let mut read = self.reading.files();
        read.takes_properties = true;
        let input = self.layers.read(&mut read)?;
        let name = self.layers.name();
        let (input, splitting) = if self.split.is_asked() {
            let input = self.scalar.convert(&name, input)?;
            let (input, splitting) = self.split.apply(&name, input)?;
            (input, Some(splitting))
        } else {
            (input, None)
        };
        let input = self.missing.apply(&name, input, &read)?;
        let run = Run {
            arguments: self,
            targets,
            json,
            read: &read,
            splitting,
        };
        self.scalar.apply(&name, &input, run)
    }
}

/// A run with an input that is read.
struct Run<'a> {
    arguments: &'a Triangulate,
    targets: Vec<Target>,
    /// Where statistics go.
    json: Option<Destination>,
    read: &'a FilesRead,
    splitting: Option<Splitting>,
}

impl Job for Run<'_> {
    fn run<S: Coordinate, T: Scalar + Sync>(self, given: Given<'_, S, T>) -> Result<(), Failure> {
        let Given { file, points, .. } = given;
        let graph = &file.graph;
        let arguments = self.arguments;
        let targets = completed(self.targets, self.read, file)?;
        refuse_read(self.read, &self.json)?;
        let written = targets.iter().map(|target| &target.destination);
        refuse_twice(written.chain(&self.json))?;
        let (result, stats) = arguments
            .settings
            .triangulate(points, &graph.edges, arguments.stats || self.json.is_some())
            .map_err(|error| {
                let advice = SplitArgs::advice(&error);
                given.failure(format!("{}{advice}", located(file, error)))
            })?;
        let duplicates: Vec<[usize; 2]> = result.duplicates().collect();
        let shared = file.sharing(&duplicates);
        let file = shared.as_ref().unwrap_or(file);
        // A result that is wrong ends the run here, before anything is written.
        let verdict = if arguments.verify {
            let triangles: Vec<[usize; 3]> = result.triangles().collect();
            let answer = verify(Verifier::new(), points, &graph.edges, &triangles);
            Some(answer.map_err(|violations| given.failure(violations))?)
        } else {
            None
        };
        let domain = arguments.inside.domain(given.name, file, &result)?;
        let domain = domain.as_ref();
        let summary = targets.is_empty();
        let asks_heights = targets.iter().any(Target::asks_heights);
        self.read.say_of(given.name, file)?;
        say_losses(self.read, &targets, file, domain)?;
        // Standard output holds either a result or a report.
        let report =
            !has_standard(&targets) && !self.json.as_ref().is_some_and(Destination::is_standard);
        let mut outputs = Outputs::default();
        add(&mut outputs, targets, file, &result, domain)?;
        if let (Some(json), Some(stats)) = (self.json, &stats) {
            outputs.add(json, |out| write_json(stats, out))?;
        }
        if report {
            outputs.add(Destination::standard(), |out| {
                if let Some(splitting) = &self.splitting {
                    write_splitting(splitting, given.name, out)?;
                }
                match &stats {
                    Some(stats) if arguments.stats => write_statistics(stats, out)?,
                    _ if summary => summarize(&given, &result, domain, &arguments.inside, out)?,
                    _ => {}
                }
                match verdict {
                    Some(report) => {
                        let (answer, level) = (Ok(report), Level::Delaunay);
                        let splitting = self.splitting.as_ref();
                        let input = splitting.map(|splitting| triangulated(splitting, given.name));
                        let input = input.as_deref().unwrap_or(given.name);
                        writeln!(
                            out,
                            "{}",
                            headline(&answer, level, None, ["the result", input])
                        )
                    }
                    None => Ok(()),
                }
            })?;
        }
        outputs.finish()?;
        let mut found = remarks(file, &result, domain);
        found.extend(asks_heights.then(|| without_heights(file)).flatten());
        self.read.say(given.name, &found)?;
        Ok(())
    }
}

fn summarize<S, T>(
    Given { name, file, .. }: &Given<'_, S, T>,
    result: &Triangulation,
    domain: Option<&Interior<'_>>,
    inside: &InsideArgs,
    out: &mut impl Write,
) -> io::Result<()> {
    let (points, edges) = (file.graph.points.len(), file.graph.edges.len());
    let (triangles, hull) = (result.len(), result.hull().len());
    let duplicates = result.duplicates().len();
    write!(out, "{name}: points {points}, duplicates {duplicates}, ")?;
    writeln!(out, "edges {edges}, triangles {triangles}, hull {hull}")?;
    if file.merged > 0 {
        writeln!(
            out,
            "equal positions that became one vertex with another: {}",
            file.merged
        )?;
    }
    if edges == 0 || triangles == 0 {
        return Ok(());
    }
    let (rule, why) = inside.rule(file);
    let left = domain.map_or(triangles, |domain| domain.inside().len());
    writeln!(
        out,
        "inside {left} of {triangles} triangles: rule {rule}, {why}"
    )
}

//! `sweep-cdt refine`: points and edges in, a mesh within bounds out.

use std::cell::RefCell;
use std::io::{self, Write};

use sweep_cdt::interior::Interior;
use sweep_cdt::scalar::Scalar;
use sweep_cdt_edit::{Left, RefineError, Refinement};
use sweep_cdt_engine::{
    RefinedFile, bounds_or_default, region_areas, size, size_in_words, without_heights,
};
use sweep_cdt_formats::{Coordinate, GraphFile};

use crate::shared::arguments::{OutputArgs, Target, add, completed, has_standard, say_losses};
use crate::shared::arithmetic::{Given, Job, ScalarArgs};
use crate::shared::bounds::BoundsArgs;
use crate::shared::failure::Failure;
use crate::shared::files::FilesRead;
use crate::shared::outputs::{Destination, Outputs};
use crate::shared::resources::Progress;
use crate::shared::terrain::TerrainArgs;

/// Make a mesh of triangles without small angles
///
/// Triangulates points and edges as `sweep-cdt triangulate` does, and adds vertices until no triangle inside breaks a
/// bound: a least angle, a greatest area, a greatest side. Exact signs decide the bounds. Vertices of the input keep their
/// numbers, the new ones follow. The mesh is the constrained Delaunay triangulation of its vertices and edges.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct Refine {
    #[command(flatten)]
    terrain: TerrainArgs,

    #[command(flatten)]
    bounds: BoundsArgs,

    /// Greatest area of a triangle in a region, by the number of the region in the file
    ///
    /// This area counts in place of the area that the file has for the region. A region of a .geojson or .wkt is a feature with
    /// polygons, from 1. May be given several times.
    #[arg(long, value_name = "NUMBER=AREA", value_parser = region_area)]
    region_area: Vec<(usize, f64)>,

    /// End with so many vertices, those of the input among them
    #[arg(long, value_name = "N")]
    max_points: Option<usize>,

    /// Add no vertices on the sides between inside and outside
    #[arg(long)]
    keep_boundary: bool,

    /// How many of the triangles that break a bound still to list
    #[arg(long, value_name = "N", default_value_t = 20)]
    limit: usize,

    #[command(flatten)]
    output: OutputArgs,

    #[command(flatten)]
    scalar: ScalarArgs,
}

const AFTER_HELP: &str = "\
Bounds:
  Without any, --min-angle is 20. A mesh for a least angle of up to 20.7 degrees is proved to end, if no
  edges meet at less than 60 degrees; in practice 33 degrees end, too. Above 34 degrees --max-points must
  be given. The areas of the regions of a .poly, .json or .npz count, too (fourth number of a region), and
  are a reason for --inside holes, as holes are.
  A triangle in or at a sharp corner of the input can be impossible to better. What breaks a bound
  still is listed with the reason; --strict refuses it.

Output: that of `sweep-cdt triangulate`. The edges are the parts of the edges of the input, in their
  order; the list `split` of a .json has the vertices along each edge of the input. A part has the
  marker of its edge. The sides of the hull that bound the inside follow, as edges without a marker:
  rounding may put their new vertices beside the hull. Heights and other columns of new vertices
  are linear on the triangles of the input, their markers are missing.

Exit status:
  0  done   1  wrong input, nothing written   2  wrong usage

Examples:
  sweep-cdt refine part.poly --min-angle 28 --max-area 0.5 -o part.vtu -o part.svg
  sweep-cdt refine lakes.geojson --max-side 100 --region-area 3=50 -o lakes.msh
  sweep-cdt refine part.poly -o part.1.ele
  sweep-cdt verify part.poly part.1.ele --steiner --max-depth 1e-12 --min-angle 20";

/// A region by its number, and an area.
fn region_area(text: &str) -> Result<(usize, f64), String> {
    let parts = text.split_once('=');
    let parts = parts.and_then(|(number, area)| Some((number.parse().ok()?, area.parse().ok()?)));
    let parts = parts.filter(|&(_, area): &(usize, f64)| area > 0.0);
    parts.ok_or_else(|| "it is no number of a region with an area above 0, as 2=0.5 is".to_owned())
}

impl Refine {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let targets = self.output.targets()?;
        let mut read = self.terrain.files();
        read.takes_areas = true;
        read.takes_properties = true;
        let name = self.terrain.name();
        let input = self.scalar.convert(&name, self.terrain.read(&mut read)?)?;
        let run = Run {
            arguments: self,
            targets,
            read: &read,
        };
        self.scalar.apply(&name, &input, run)
    }
}

/// A run with an input that is read.
struct Run<'a> {
    arguments: &'a Refine,
    targets: Vec<Target>,
    read: &'a FilesRead,
}

impl Job for Run<'_> {
    fn run<S: Coordinate, T: Scalar + Sync>(self, given: Given<'_, S, T>) -> Result<(), Failure> {
        let terrain = &self.arguments.terrain;
        let read = self.read;
        terrain.triangulated(given.file, read, |file, domain| {
            self.refined(given.name, file, &domain)
        })
    }
}

impl Run<'_> {
    /// Refines what is inside a domain, and writes it.
    fn refined<S: Coordinate>(
        self,
        name: &str,
        file: &GraphFile<S>,
        domain: &Interior<'_>,
    ) -> Result<(), Failure> {
        let arguments = self.arguments;
        let failure = |error: &dyn std::fmt::Display| Failure::Error(format!("{name}: {error}"));
        let rule = arguments.terrain.rule(file);
        let areas = region_areas(file, rule, domain, &arguments.region_area);
        let (areas, unused) = areas.map_err(|error| {
            let way_out = match domain.has_regions() || file.graph.regions.is_empty() {
                true => String::new(),
                false => format!("; the rule is {rule}: --inside holes has regions"),
            };
            failure(&format!("{error}{way_out}"))
        })?;
        self.read.say(name, unused.as_slice())?;
        let progress = RefCell::new(Progress::new("refining"));
        let show = |points, waiting| progress.borrow_mut().show(points, points + waiting);
        let bounds = arguments.bounds.given().unwrap_or_default();
        let bounds = bounds_or_default(bounds, areas.iter().any(|area| area.is_finite()));
        let how = Refinement::new(bounds).region_areas(&areas).progress(&show);
        let how = match arguments.max_points {
            Some(most) => how.most_points(most),
            None => how,
        };
        let how = if arguments.keep_boundary {
            how.keep_boundary()
        } else {
            how
        };
        let refined = RefinedFile::new(file, domain, &how).map_err(|error| match error {
            RefineError::Bounds(error) => Failure::Usage(error.to_string()),
            RefineError::Endless => Failure::Usage(format!("{error} (--max-points)")),
            error => failure(&error),
        })?;
        drop(progress);
        let mesh = refined.interior(domain);
        let targets = completed(self.targets, self.read, &refined.file)?;
        say_losses(self.read, &targets, &refined.file, Some(&mesh))?;
        let mut said = refined.remarks();
        let asks_heights = targets.iter().any(Target::asks_heights);
        said.extend(
            asks_heights
                .then(|| without_heights(&refined.file))
                .flatten(),
        );
        self.read.say(name, &said)?;
        let is_free = !has_standard(&targets);
        let mut outputs = Outputs::default();
        add(
            &mut outputs,
            targets,
            &refined.file,
            &refined.result,
            Some(&mesh),
        )?;
        if is_free {
            outputs.add(Destination::standard(), |out| {
                summarize(name, file, &refined, out)?;
                let listed = refined.left.iter().take(arguments.limit);
                listed
                    .into_iter()
                    .try_for_each(|left| list(&refined, left, out))?;
                match refined.left.len().saturating_sub(arguments.limit) {
                    0 => Ok(()),
                    more => writeln!(out, "and {more} more"),
                }
            })?;
        }
        outputs.finish()
    }
}

/// Writes what the refinement came to: one line.
fn summarize<S: Coordinate>(
    name: &str,
    file: &GraphFile<S>,
    refined: &RefinedFile<S>,
    out: &mut impl Write,
) -> io::Result<()> {
    let (before, after) = (&file.graph, &refined.file.graph);
    let (points, edges) = (before.points.len(), before.edges.len());
    let new = after.points.len() - points;
    let (parts, triangles) = (after.edges.len(), refined.triangles.len());
    let left = refined.left.len();
    writeln!(
        out,
        "{name}: points {points} and {new} new, edges {edges} in {parts} parts, triangles {triangles}, out of bounds {left}"
    )
}

/// Writes a triangle that breaks a bound: its number in Triangle's format, its corners, its size and the reason.
fn list<S: Coordinate>(
    refined: &RefinedFile<S>,
    left: &Left,
    out: &mut impl Write,
) -> io::Result<()> {
    let points = &refined.file.graph.points;
    let corners = refined.triangles[left.triangle].map(|v| &points[v]);
    let number = left.triangle + refined.file.numbering.vertex;
    let has = size_in_words(left.bound, size(left.bound, corners));
    let places = corners.map(|corner| format!("({}, {})", corner[0].text(), corner[1].text()));
    writeln!(
        out,
        "triangle {number} {} has {has}: {}",
        places.join(" "),
        left.reason
    )
}

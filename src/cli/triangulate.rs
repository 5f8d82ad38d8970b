//! `sweep-cdt triangulate`: the main job.

use std::io::Write;

use clap::ValueEnum;
use sweep_cdt::formats::{Coordinate, Graph, Input, Rational, exact};
use sweep_cdt::{Error, Scalar, Stats, Triangulation};

use super::failure::Failure;
use super::input::InputArgs;
use super::output::{OutputArgs, Target, print, save};
use super::settings::Settings;
use super::statistics;

/// Triangulate points and edges
///
/// Reads points and edges and writes their constrained Delaunay triangulation: triangles that cover
/// the convex hull of the points, every edge a side (or several, where points lie on it), and as near
/// to a Delaunay triangulation as the edges allow. Without -o a summary is printed.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct Triangulate {
    #[command(flatten)]
    input: InputArgs,

    #[command(flatten)]
    output: OutputArgs,

    /// Print counts, times and memory as a table
    #[arg(long)]
    stats: bool,

    /// Arithmetic; by default rational where the input has fractions, else f64
    ///
    /// Both are exact. In an input with a fraction (`p/q`) all numbers are taken as written: 0.1 is
    /// one tenth. In any other input each number is the double nearest to it, for both kinds of
    /// arithmetic, so that they give the same triangles. f64 refuses fractions.
    #[arg(long, value_enum)]
    scalar: Option<Kind>,

    #[command(flatten)]
    settings: Settings,
}

#[derive(Clone, Copy, ValueEnum)]
enum Kind {
    /// Doubles
    F64,
    /// Fractions of whole numbers of any size; slower
    Rational,
}

const AFTER_HELP: &str = "\
Input:
  .node    Triangle's vertices; numbered from 0 or 1
  .poly    Triangle's vertices and segments; with 0 vertices, those of the .node beside it.
           Attributes, markers, holes and regions are read over
  .json    {\"points\": [[x, y], ...], \"edges\": [[i, j], ...]}; fractions as strings: \"1/3\"

Output, triangles always in the same order:
  .ele     Triangle's triangles, numbered as the input. A .node with the vertices is written beside
           it unless one with the same vertices is there
  .json    points, edges, triangles, neighbors, constrained sides, hull, duplicates, and the chain
           of vertices along each edge; numbered from 0
  .obj     for 3D programs, z = 0
  .svg     a picture: triangles grey, edges blue, hull orange

Exit status:
  0  done   1  wrong input, nothing is written   2  wrong usage

Examples:
  sweep-cdt triangulate terrain.poly -o terrain.svg
  sweep-cdt triangulate terrain.poly -o terrain.ele -o terrain.json --stats
  generate | sweep-cdt triangulate - --from json -o - --to obj | view";

impl Triangulate {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let targets = self.output.targets(&self.input)?;
        if self.stats && self.output.has_stdout() {
            let message = "--stats and `-o -` would both write to standard output";
            return Err(Failure::Usage(message.to_owned()));
        }
        match (self.input.read()?, self.scalar) {
            (Input::Doubles(graph), None | Some(Kind::F64)) => {
                self.finish(&targets, &graph, self.sweep(&graph.points, &graph.edges))
            }
            (Input::Doubles(graph), Some(Kind::Rational)) => {
                let points = exact_points(&graph.points);
                let outcome = points.and_then(|points| self.sweep(&points, &graph.edges));
                self.finish(&targets, &graph, outcome)
            }
            (Input::Rationals(graph), None | Some(Kind::Rational)) => {
                self.finish(&targets, &graph, self.sweep(&graph.points, &graph.edges))
            }
            (Input::Rationals(_), Some(Kind::F64)) => {
                let name = self.input.name();
                Err(Failure::Error(format!(
                    "{name}: has fractions, which --scalar f64 refuses"
                )))
            }
        }
    }

    fn sweep<S: Scalar>(&self, points: &[[S; 2]], edges: &[[usize; 2]]) -> Result<Outcome, Error> {
        self.settings.triangulate(points, edges, self.stats)
    }

    fn finish<S: Coordinate>(
        &self,
        targets: &[Target],
        graph: &Graph<S>,
        outcome: Result<Outcome, Error>,
    ) -> Result<(), Failure> {
        let name = self.input.name();
        let (result, stats) = outcome
            .map_err(|error| Failure::Error(format!("{name}: {}", graph.as_numbered(error))))?;
        save(targets, graph, &result)?;
        match stats {
            Some(stats) => print(|out| statistics::write(&stats, out)),
            None if targets.is_empty() => print(|out| {
                let (points, edges) = (graph.points.len(), graph.edges.len());
                write!(
                    out,
                    "{name}: points {points}, duplicates {}, ",
                    result.duplicates().len()
                )?;
                let (triangles, hull) = (result.len(), result.hull().len());
                writeln!(out, "edges {edges}, triangles {triangles}, hull {hull}")
            }),
            None => Ok(()),
        }
    }
}

/// A result, and its numbers where they were asked for.
type Outcome = (Triangulation, Option<Stats>);

/// The exact values of doubles.
fn exact_points(points: &[[f64; 2]]) -> Result<Vec<[Rational; 2]>, Error> {
    let values = points.iter().enumerate().map(|(vertex, &[x, y])| {
        let values = exact(x).zip(exact(y)).map(|(x, y)| [x, y]);
        values.ok_or(Error::NonFiniteCoordinate { vertex })
    });
    values.collect()
}

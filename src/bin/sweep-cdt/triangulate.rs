//! `sweep-cdt triangulate`: points and edges in, their triangulation out.

use std::fmt::Display;
use std::io::{self, Write};

use sweep_cdt::Triangulation;
use sweep_cdt::formats::{Coordinate, Graph};
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::Verifier;

use crate::shared::arithmetic::{Job, ScalarArgs};
use crate::shared::failure::Failure;
use crate::shared::input::InputArgs;
use crate::shared::output::{OutputArgs, Target, print, save};
use crate::shared::report;
use crate::shared::settings::Settings;
use crate::shared::verification::verify;
use crate::statistics;

/// Triangulate points and edges
///
/// Reads points and edges and writes their constrained Delaunay triangulation. The triangles cover the
/// convex hull of the points. Every edge is a side of triangles, or a chain of sides where points lie on
/// it. Every other side is locally Delaunay. Without -o a summary is printed.
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

    /// Verify the result before anything is written
    ///
    /// The verifier shares the signs (filter and exact predicates) with the sweep and nothing else; see
    /// `sweep-cdt verify`.
    #[arg(long)]
    verify: bool,

    #[command(flatten)]
    scalar: ScalarArgs,

    #[command(flatten)]
    settings: Settings,
}

const AFTER_HELP: &str = "\
Input:
  .node    Triangle's vertices; numbered from 0 or 1
  .poly    Triangle's vertices and segments; with 0 vertices, those of the .node beside it.
           Attributes, markers, holes and regions are ignored
  .json    {\"points\": [[x, y], ...], \"edges\": [[i, j], ...]}; fractions as strings: \"1/3\"

Output, with the triangles always in the same order:
  .ele     Triangle's triangles, numbered as the input. A .node with the vertices is written beside
           it, unless there is one with the same vertices
  .json    points, edges, triangles, neighbors, constrained sides, hull, duplicates, and the chain
           of vertices along each edge; numbered from 0
  .obj     vertices and triangles for 3D programs; z is 0
  .svg     a picture: triangles grey, edges blue, hull orange

Exit status:
  0  done   1  wrong input, nothing written   2  wrong usage

Examples:
  sweep-cdt triangulate terrain.poly -o terrain.svg
  sweep-cdt triangulate terrain.poly -o terrain.ele -o terrain.json --stats
  generate | sweep-cdt triangulate - --input-format json -o - --output-format obj | view";

impl Triangulate {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let targets = self.output.targets(&self.input.input)?;
        if self.stats && self.output.has_stdout() {
            let message = "--stats and `-o -` would both write to standard output";
            return Err(Failure::Usage(message.to_owned()));
        }
        let input = self.input.read(|_| ())?;
        let name = self.input.name();
        let run = Run {
            arguments: self,
            name: &name,
            targets: &targets,
        };
        self.scalar.apply(&name, &input, run)
    }
}

/// A run with an input that is read.
struct Run<'a> {
    arguments: &'a Triangulate,
    name: &'a str,
    targets: &'a [Target],
}

impl Job for Run<'_> {
    fn run<S: Coordinate, T: Scalar + Sync>(
        self,
        graph: &Graph<S>,
        points: &[[T; 2]],
        _scalar: &'static str,
    ) -> Result<(), Failure> {
        let Triangulate {
            settings, stats, ..
        } = self.arguments;
        let (result, stats) = settings
            .triangulate(points, &graph.edges, *stats)
            .map_err(|error| self.error(&graph.as_numbered(error)))?;
        // A result that is wrong ends the run here, before anything is written.
        let verdict = if self.arguments.verify {
            let triangles: Vec<[usize; 3]> = result.triangles().collect();
            let answer = verify(Verifier::new(), points, &graph.edges, &triangles);
            Some(answer.map_err(|violations| self.error(&violations))?)
        } else {
            None
        };
        save(self.targets, graph, &result)?;
        // Standard output holds either a result or a report.
        if self.arguments.output.has_stdout() {
            return Ok(());
        }
        print(|out| {
            match stats {
                Some(stats) => statistics::write(&stats, out)?,
                None if self.targets.is_empty() => self.summarize(graph, &result, out)?,
                None => {}
            }
            match verdict {
                Some(report) => report::write_verdict(&Ok(report), "the result", self.name, out),
                None => Ok(()),
            }
        })
    }
}

impl Run<'_> {
    fn error(&self, error: &impl Display) -> Failure {
        Failure::Error(format!("{}: {error}", self.name))
    }

    fn summarize<S>(
        &self,
        graph: &Graph<S>,
        result: &Triangulation,
        out: &mut impl Write,
    ) -> io::Result<()> {
        let (points, edges) = (graph.points.len(), graph.edges.len());
        let (triangles, hull) = (result.len(), result.hull().len());
        let duplicates = result.duplicates().len();
        write!(
            out,
            "{}: points {points}, duplicates {duplicates}, ",
            self.name
        )?;
        writeln!(out, "edges {edges}, triangles {triangles}, hull {hull}")
    }
}

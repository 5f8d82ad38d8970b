//! `sweep-cdt replay`: the triangles that a trace builds, and whether it is that of its input.

use std::io::Write;

use sweep_cdt::scalar::Scalar;
use sweep_cdt_formats::{Coordinate, Format};
use sweep_cdt_trace::read_trace;
use sweep_cdt_trace::{BadTrace, Trace};

use crate::shared::arguments::InputArgs;
use crate::shared::arithmetic::{Given, Job, ScalarArgs};
use crate::shared::failure::Failure;
use crate::shared::files::{FileArgument, ReadingArgs, format_parser};
use crate::shared::outputs::print;
use crate::shared::settings::Settings;

/// Rebuild the triangles from a trace
///
/// Repeats the steps of a trace on an empty mesh, without any geometry, and prints the triangles. If no
/// run can have made the trace (it is cut short, shuffled or edited), names the first wrong line. With
/// --input it must be the trace of that input, line by line.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct Replay {
    /// Trace to read, text or JSON Lines; `-` for standard input
    #[arg(value_name = "TRACE")]
    trace: FileArgument,

    /// Input to compare with: it is traced anew, and any difference is refused
    #[arg(long, value_name = "INPUT")]
    input: Option<FileArgument>,

    /// Format of the input [default: by its extension]
    #[arg(long, value_name = "FORMAT", requires = "input", value_parser = format_parser(Format::INPUTS))]
    input_format: Option<Format>,

    #[command(flatten)]
    reading: ReadingArgs,

    #[command(flatten)]
    scalar: ScalarArgs,

    #[command(flatten)]
    settings: Settings,
}

const AFTER_HELP: &str = "\
Output: one triangle a line, its vertices counter-clockwise from the lowest, numbered from 0. The
lines are sorted, as in the .json that `sweep-cdt triangulate` writes.

What is checked:
  Each step must be one that the sweep could take after those before it; in the end the triangles
  must fill one simple polygon, and each fixed edge must be a side. Without the input's coordinates
  some edits cannot be noticed. None of them changes a triangle:
    - a test that swaps nothing is left out, added, or comes at another time
    - steps that do not touch each other are swapped, or a switch of a mixed part is left out
    - an edge has another new number, or is said to be part of another one
    - the names of the two pseudo-polygons, or of the two heuristics, are swapped
  With --input every edit is noticed. Give the heuristics that the trace was made with; scalars and
  fronts do not change the steps.

Exit status:
  0  done   1  no complete trace, another one than that of the input, or it cannot be read
  2  wrong usage";

impl Replay {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let mut read = self.reading.files();
        if self.trace.is_standard() && self.input.as_ref().is_some_and(FileArgument::is_standard) {
            let message = "the trace and the input cannot both come from standard input";
            return Err(Failure::Usage(message.to_owned()));
        }
        let source = read.load(&self.trace)?;
        let text = String::from_utf8_lossy(source.text()?);
        // Lines may end with carriage returns alone.
        let text = text.replace("\r\n", "\n").replace('\r', "\n");
        let refused = |bad: BadTrace| {
            Failure::Error(format!("{}:{}: {}", source.name, bad.line, bad.message))
        };
        let trace = read_trace(&text).map_err(refused)?;
        if let Some(file) = &self.input {
            let input = InputArgs::new(file.clone(), self.input_format);
            let comparison = Comparison {
                settings: &self.settings,
                trace: &trace,
                refused: &refused,
            };
            let read = input.read(&mut read, |_| ())?;
            self.scalar.apply(&input.name(), &read, comparison)?;
        }
        let triangles = trace.replay().map_err(refused)?;
        print(|out| {
            triangles
                .iter()
                .try_for_each(|[a, b, c]| writeln!(out, "{a} {b} {c}"))
        })
    }
}

/// A trace that must be that of the input.
struct Comparison<'a> {
    settings: &'a Settings,
    trace: &'a Trace,
    refused: &'a dyn Fn(BadTrace) -> Failure,
}

impl Job for Comparison<'_> {
    fn run<S: Coordinate, T: Scalar + Sync>(self, given: Given<'_, S, T>) -> Result<(), Failure> {
        let mut events = Vec::new();
        let observer = |event| events.push(event);
        let (points, edges) = (given.points, &given.file.graph.edges);
        let result = self.settings.observe(points, edges, observer);
        self.trace.compare(&events).map_err(self.refused)?;
        result.map_err(|error| given.refused(error))?;
        Ok(())
    }
}

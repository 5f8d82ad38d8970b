//! `sweep-cdt trace`: every step of the sweep, in the paper's words. And `sweep-cdt replay`: the triangles that a trace
//! builds.

use std::io::{self, Write};
use std::num::NonZeroUsize;
use std::ops::RangeInclusive;

use strum::{EnumString, IntoStaticStr, VariantArray};
use sweep_cdt::draw::{StepsPage, StepsSheet};
use sweep_cdt::formats::{Coordinate, Graph};
use sweep_cdt::scalar::Scalar;
use sweep_cdt::trace::Event;

use crate::shared::arguments::InputArgs;
use crate::shared::arithmetic::{Given, Job, ScalarArgs};
use crate::shared::failure::Failure;
use crate::shared::files::{FileArgument, FilesRead, format_of_output, format_parser};
use crate::shared::outputs::{Destination, Outputs, print, refuse_read};
use crate::shared::settings::Settings;

/// Record every step of the sweep
///
/// Triangulates and writes each step on a line, in the words of the paper (Domiter and Žalik 2008):
/// sweep order, point events, triangles, legalization, edge events, finalization. Vertices and edges
/// are numbered from 0, however the input numbers them.
#[derive(clap::Args)]
#[command(after_long_help = TRACE_AFTER_HELP)]
pub(crate) struct Trace {
    #[command(flatten)]
    input: InputArgs,

    /// File to write: .txt, .jsonl, .html or .svg; `-` for standard output
    #[arg(short, long, value_name = "OUTPUT", default_value = "-")]
    output: FileArgument,

    /// Format of an output whose extension tells none [default for standard output: txt]
    #[arg(long, value_name = "FORMAT", value_parser = format_parser::<TraceFormat>())]
    output_format: Option<TraceFormat>,

    /// First step to write, counted from 1
    #[arg(long, value_name = "K", default_value_t = NonZeroUsize::MIN)]
    from: NonZeroUsize,

    /// Last step to write [default: the last one]
    #[arg(long, value_name = "K", default_value_t = NonZeroUsize::MAX, hide_default_value = true)]
    to: NonZeroUsize,

    #[command(flatten)]
    scalar: ScalarArgs,

    #[command(flatten)]
    settings: Settings,
}

const TRACE_AFTER_HELP: &str = "\
Output:
  .txt     text, to read beside the paper: `point 7: middle case, projected on segment 3 5`
  .jsonl   JSON Lines, for programs
  .html    a page that draws up to 20,000 steps in a browser: slider, play, keys, zoom
  .svg     a picture of up to 60 steps
  .txt and .jsonl begin with a line that gives the version, so step k is on line k + 1. Scalars and
  fronts do not change the steps; heuristics do.

Exit status:
  0  done   1  wrong input, nothing written   2  wrong usage

Examples:
  sweep-cdt trace terrain.poly --heuristics paper | less
  sweep-cdt trace terrain.poly -o steps.jsonl && sweep-cdt replay steps.jsonl
  sweep-cdt trace terrain.poly -o steps.html
  sweep-cdt trace terrain.poly -o steps.svg --from 120 --to 131";

/// What `trace` writes. Each format is named by the extension of its files.
#[derive(Clone, Copy, EnumString, IntoStaticStr, VariantArray)]
#[strum(ascii_case_insensitive)]
enum TraceFormat {
    #[strum(serialize = "txt")]
    Text,
    #[strum(serialize = "jsonl")]
    JsonLines,
    #[strum(serialize = "html")]
    Page,
    #[strum(serialize = "svg")]
    Sheet,
}

impl TraceFormat {
    /// Whether all steps are needed: a picture shows the result of the steps before it, and a page says
    /// how many steps there are.
    fn needs_all(self) -> bool {
        matches!(self, TraceFormat::Page | TraceFormat::Sheet)
    }

    /// Writes `events`, which begin at step `first`, or at 1 where all are needed.
    fn write<S: Scalar>(
        self,
        graph: &Graph<S>,
        events: Vec<Event>,
        steps: RangeInclusive<usize>,
        mut out: impl Write,
    ) -> io::Result<()> {
        let skipped = steps.start() - 1;
        let trace = |events| sweep_cdt::trace::Trace { skipped, events };
        match self {
            TraceFormat::Text => trace(events).write_text(out),
            TraceFormat::JsonLines => trace(events).write_lines(out),
            TraceFormat::Page => StepsPage::new(graph, &events).steps(steps).write(&mut out),
            TraceFormat::Sheet => StepsSheet::new(graph, &events).steps(steps).write(&mut out),
        }
    }
}

impl Trace {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        if self.from > self.to {
            let (first, last) = (self.from, self.to);
            let message = format!("--to {last} is before --from {first}");
            return Err(Failure::Usage(message));
        }
        let text = self.output.is_standard().then_some(TraceFormat::Text);
        let format = format_of_output(&self.output, self.output_format.or(text))?;
        let destination = Destination::of(&self.output)?;
        let mut read = FilesRead::default();
        let input = self.input.read(&mut read, |_| ())?;
        refuse_read(&read, [&destination])?;
        let run = Run {
            arguments: self,
            destination,
            format,
        };
        self.scalar.apply(&self.input.name(), &input, run)
    }
}

/// A run with an input that is read.
struct Run<'a> {
    arguments: &'a Trace,
    destination: Destination,
    format: TraceFormat,
}

impl Job for Run<'_> {
    fn run<S: Coordinate, T: Scalar + Sync>(self, given: Given<'_, S, T>) -> Result<(), Failure> {
        let Given { graph, points, .. } = given;
        let [first, last] = [self.arguments.from, self.arguments.to].map(NonZeroUsize::get);
        // Only the steps that are written are kept.
        let mut events = Vec::new();
        let mut step = 0;
        let observer = |event| {
            step += 1;
            if self.format.needs_all() || (first..=last).contains(&step) {
                events.push(event);
            }
        };
        let settings = &self.arguments.settings;
        let result = settings.observe(points, &graph.edges, observer);
        result.map_err(|error| given.refused(error))?;
        if first > step {
            let message = format!("there is no step {first}; the last step is {step}");
            return Err(given.failure(message));
        }
        let mut outputs = Outputs::default();
        outputs.add(self.destination, |out| {
            self.format.write(graph, events, first..=last, out)
        })?;
        outputs.finish()
    }
}

/// Rebuild the triangles from a trace
///
/// Repeats the steps of a trace on an empty mesh, without any geometry, and prints the triangles. If no
/// run can have made the trace (it is cut short, shuffled or edited), names the first wrong line.
#[derive(clap::Args)]
#[command(after_long_help = REPLAY_AFTER_HELP)]
pub(crate) struct Replay {
    /// Trace to read, text or JSON Lines; `-` for standard input
    #[arg(value_name = "TRACE")]
    trace: FileArgument,
}

const REPLAY_AFTER_HELP: &str = "\
Output: one triangle a line, its vertices counter-clockwise from the lowest, numbered from 0. The
lines are sorted, as in the .json that `sweep-cdt triangulate` writes.

Exit status:
  0  done   1  no complete trace, or it cannot be read   2  wrong usage";

impl Replay {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let source = FilesRead::default().load(&self.trace)?;
        let text = String::from_utf8_lossy(source.text()?);
        // Lines may end with carriage returns alone.
        let text = text.replace("\r\n", "\n").replace('\r', "\n");
        let trace = sweep_cdt::trace::Trace::parse(&text);
        let triangles = trace.and_then(|trace| trace.replay()).map_err(|bad| {
            Failure::Error(format!("{}:{}: {}", source.name, bad.line, bad.message))
        })?;
        print(|out| {
            triangles
                .iter()
                .try_for_each(|[a, b, c]| writeln!(out, "{a} {b} {c}"))
        })
    }
}

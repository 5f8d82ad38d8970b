//! `sweep-cdt trace`: every step of the sweep, in the paper's words.

use std::io::{self, Write};
use std::num::NonZeroUsize;
use std::ops::RangeInclusive;

use sweep_cdt::scalar::Scalar;
use sweep_cdt::trace::Event;
use sweep_cdt::{Error, Pslg};
use sweep_cdt_draw::{StepsPage, StepsSheet};
use sweep_cdt_formats::{Coordinate, Format};
use sweep_cdt_trace::write_trace;

use crate::shared::arguments::InputArgs;
use crate::shared::arithmetic::{Given, Job, ScalarArgs};
use crate::shared::around::Around;
use crate::shared::failure::{Failure, printable};
use crate::shared::files::{FileArgument, ReadingArgs, format_of_output, format_parser};
use crate::shared::outputs::{Destination, Outputs, refuse_read};
use crate::shared::places::located;
use crate::shared::settings::Settings;

/// Record every step of the sweep
///
/// Triangulates and writes each step on a line, in the words of the paper (Domiter and Žalik 2008):
/// sweep order, point events, triangles, legalization, edge events, finalization. Vertices and edges
/// are numbered from 0, however the input numbers them.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct Trace {
    #[command(flatten)]
    input: InputArgs,

    #[command(flatten)]
    reading: ReadingArgs,

    /// File to write: .txt, .jsonl, .html or .svg; `-` for standard output
    #[arg(short, long, value_name = "OUTPUT", default_value = "-")]
    output: FileArgument,

    /// Format of an output whose extension tells none [default for standard output: txt]
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(FORMATS))]
    output_format: Option<Format>,

    /// First step to write, counted from 1
    #[arg(long, value_name = "K", default_value_t = NonZeroUsize::MIN)]
    from: NonZeroUsize,

    /// Last step to write [default: the last one]
    #[arg(long, value_name = "K", default_value_t = NonZeroUsize::MAX, hide_default_value = true)]
    to: NonZeroUsize,

    /// Where a page opens, and what it keeps if it cannot hold every step: `vertex:N`, `edge:N` or `step:N`
    ///
    /// The step at which the sweep line meets the vertex, or at which the edge is inserted; of a .svg the
    /// 60 steps around it. Vertices and edges are numbered from 0.
    #[arg(long, value_name = "PLACE", conflicts_with_all = ["from", "to"])]
    around: Option<Around>,

    #[command(flatten)]
    scalar: ScalarArgs,

    #[command(flatten)]
    settings: Settings,
}

const AFTER_HELP: &str = "\
Output:
  .txt     text, to read beside the paper: `point 7: middle case, projected on segment 3 5`
  .jsonl   JSON Lines, for programs
  .html    a page to walk through the steps in a browser: slider, play, keys, zoom, search. It has at most
           20 MB, which a browser shows in a second or two: some 400,000 steps. Of a longer run it
           holds those from the first point event on, or those around the place that --around names
  .svg     a picture of up to 60 steps
  .txt and .jsonl begin with a line that gives the version, so step k is on line k + 1. Scalars and
  fronts do not change the steps; heuristics do.

Exit status:
  0  done   1  wrong input, nothing written; where edges cross, the steps up to there are written
  2  wrong usage

Examples:
  sweep-cdt trace terrain.poly --heuristics paper | less
  sweep-cdt trace terrain.poly -o steps.jsonl && sweep-cdt replay steps.jsonl
  sweep-cdt trace terrain.poly -o steps.html --around vertex:17
  sweep-cdt trace terrain.poly -o steps.svg --from 120 --to 131";

/// The formats that `trace` writes.
const FORMATS: &[Format] = &[Format::Txt, Format::Jsonl, Format::Html, Format::Svg];

/// Whether a format needs all steps: a picture shows the result of the steps before it, and a page says how many steps
/// there are.
fn needs_all(format: Format) -> bool {
    matches!(format, Format::Html | Format::Svg)
}

/// The panels of a sheet.
const MOST_PANELS: usize = 60;

/// The part of a run that is written: `events`, which begin at step `first`, or at 1 where all are needed.
struct Written<'a, S> {
    graph: &'a Pslg<S>,
    events: Vec<Event>,
    steps: RangeInclusive<usize>,
    around: Option<usize>,
    refused: Option<Error>,
}

impl<S: Scalar> Written<'_, S> {
    fn page(&self) -> StepsPage<'_, S> {
        let page = StepsPage::new(self.graph, &self.events).steps(self.steps.clone());
        let page = match self.around {
            Some(step) => page.around(step),
            None => page,
        };
        match &self.refused {
            Some(error) => page.refused(error),
            None => page,
        }
    }

    fn write(&mut self, format: Format, mut out: impl Write) -> io::Result<()> {
        match format {
            Format::Txt => self.trace().write_text(out),
            Format::Jsonl => write_trace(&self.trace(), out),
            Format::Html => self.page().write(&mut out),
            _ => StepsSheet::new(self.graph, &self.events)
                .steps(self.steps.clone())
                .most(MOST_PANELS)
                .write(&mut out),
        }
    }

    fn trace(&mut self) -> sweep_cdt_trace::Trace {
        let skipped = self.steps.start() - 1;
        let events = std::mem::take(&mut self.events);
        sweep_cdt_trace::Trace { skipped, events }
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
        let text = self.output.is_standard().then_some(Format::Txt);
        let format = format_of_output(&self.output, self.output_format.or(text), FORMATS)?;
        if self.around.is_some() && !needs_all(format) {
            let message = "--around is for .html and .svg; --from and --to are for all formats";
            return Err(Failure::Usage(message.to_owned()));
        }
        let destination = Destination::of(&self.output)?;
        let mut read = self.reading.files();
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
    format: Format,
}

impl Job for Run<'_> {
    fn run<S: Coordinate, T: Scalar + Sync>(self, given: Given<'_, S, T>) -> Result<(), Failure> {
        let Given { file, points, .. } = given;
        let graph = &file.graph;
        let [first, last] = [self.arguments.from, self.arguments.to].map(NonZeroUsize::get);
        // Only the steps that are written are kept.
        let mut events = Vec::new();
        let mut step = 0;
        let observer = |event| {
            step += 1;
            if needs_all(self.format) || (first..=last).contains(&step) {
                events.push(event);
            }
        };
        let settings = &self.arguments.settings;
        let result = settings.observe(points, &graph.edges, observer);
        let refused = result.err();
        let failure = refused.map(|error| located(file, error));
        if step == 0
            && let Some(failure) = failure
        {
            return Err(given.failure(failure));
        }
        if first > step {
            let message = match failure {
                Some(failure) => format!("{failure}; the last step is {step}"),
                None => format!("there is no step {first}; the last step is {step}"),
            };
            return Err(given.failure(message));
        }
        let around = match self.arguments.around {
            Some(place) => {
                let missing = || given.failure(format!("there is no step at {place}"));
                Some(place.step(&events).ok_or_else(missing)?)
            }
            None => None,
        };
        let steps = match (self.format, around) {
            (Format::Svg, Some(step)) => {
                let first = step.saturating_sub(MOST_PANELS / 2).max(1);
                first..=first + MOST_PANELS - 1
            }
            _ => first..=last,
        };
        let mut written = Written {
            graph,
            events,
            steps,
            around,
            refused,
        };
        let name = self.destination.name.display().to_string();
        let note = match self.format {
            Format::Html => note(&name, &written.page().shown(), first..=last.min(step)),
            _ => None,
        };
        let mut outputs = Outputs::default();
        outputs.add(self.destination, |out| written.write(self.format, out))?;
        outputs.finish()?;
        if let Some(note) = note {
            // If standard error is closed, the note has no reader.
            let _ = writeln!(io::stderr(), "note: {}", printable(&note));
        }
        match failure {
            Some(failure) => {
                let end = last.min(step);
                let part = match (first, end) {
                    (1, end) if end == step => String::new(),
                    _ => format!("steps {first} to {end} of "),
                };
                let message = format!("{failure}; {name} has {part}the {step} steps up to there");
                Err(given.failure(message))
            }
            None => Ok(()),
        }
    }
}

/// The words for a page that does not hold all steps that were asked for.
fn note(name: &str, shown: &RangeInclusive<usize>, asked: RangeInclusive<usize>) -> Option<String> {
    let (first, last) = (shown.start(), shown.end());
    let (_, total) = asked.clone().into_inner();
    let megabytes = StepsPage::<f64>::MOST_BYTES / 1_000_000;
    (*shown != asked).then(|| {
        format!(
            "{name} holds steps {first} to {last} of {total}, as many as fit into {megabytes} MB; \
             --around chooses others"
        )
    })
}

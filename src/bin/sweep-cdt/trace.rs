//! `sweep-cdt trace`: every step of the sweep, in the paper's words.

use std::io::{self, Write};
use std::num::NonZeroUsize;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use sweep_cdt::Scalar;
use sweep_cdt::formats::{Coordinate, Graph, write_page, write_sheet};
use sweep_cdt::trace::Event;

use crate::shared::arithmetic::{Job, ScalarArgs};
use crate::shared::atomic_files::Drafts;
use crate::shared::failure::Failure;
use crate::shared::input::InputArgs;
use crate::shared::output::{print, refuse_overwriting};
use crate::shared::settings::Settings;

/// What names standard output.
const STDOUT: &str = "-";

/// Record every step of the sweep
///
/// Triangulates and writes what is done, one step a line, in the words of the paper (Domiter and Žalik
/// 2008): sweep order, point events, triangles, legalization, edge events, finalization. Vertices and
/// edges are numbered from 0, in whatever way the input numbers them.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct Trace {
    #[command(flatten)]
    input: InputArgs,

    /// File to write: .txt, .jsonl, .html or .svg; `-` for standard output, as by default
    #[arg(short, long, value_name = "OUTPUT", default_value = STDOUT)]
    output: PathBuf,

    /// Format of standard output
    #[arg(long, value_name = "FORMAT", default_value = "txt", value_parser = crate::shared::format::names(Format::ALL, Format::name))]
    output_format: Format,

    /// First step to write, counted from 1
    #[arg(long, value_name = "K", default_value_t = NonZeroUsize::MIN)]
    from: NonZeroUsize,

    /// Last step to write; the end, if there are fewer
    #[arg(long, value_name = "K", default_value_t = NonZeroUsize::MAX, hide_default_value = true)]
    to: NonZeroUsize,

    #[command(flatten)]
    scalar: ScalarArgs,

    #[command(flatten)]
    settings: Settings,
}

const AFTER_HELP: &str = "\
Output:
  .txt     to be read beside the paper: `point 7: middle case, projected on segment 3 5`
  .jsonl   JSON Lines, for programs
  .html    one page that draws the steps, for a browser: slider, play, keys, zoom; up to 20,000 steps
  .svg     one step, or a sheet of up to 60
  The first two begin with a line that gives the version, so that step k is line k + 1. The same input gives
  the same steps for every scalar and front; heuristics change them.

Exit status:
  0  done   1  wrong input, nothing is written   2  wrong usage

Examples:
  sweep-cdt trace terrain.poly --heuristics paper | less
  sweep-cdt trace terrain.poly -o steps.jsonl && sweep-cdt replay steps.jsonl
  sweep-cdt trace terrain.poly -o steps.html
  sweep-cdt trace terrain.poly -o steps.svg --from 120 --to 131";

#[derive(Clone, Copy)]
enum Format {
    Text,
    JsonLines,
    Page,
    Sheet,
}

impl Format {
    const ALL: [Format; 4] = [Format::Text, Format::JsonLines, Format::Page, Format::Sheet];

    fn name(self) -> &'static str {
        match self {
            Format::Text => "txt",
            Format::JsonLines => "jsonl",
            Format::Page => "html",
            Format::Sheet => "svg",
        }
    }

    /// Whether all steps are needed: a picture shows what those before it left, a page tells how many
    /// there are.
    fn needs_all(self) -> bool {
        matches!(self, Format::Page | Format::Sheet)
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
            Format::Text => trace(events).write_text(out),
            Format::JsonLines => trace(events).write_lines(out),
            Format::Page => write_page(graph, &events, steps, &mut out),
            Format::Sheet => write_sheet(graph, &events, steps, &mut out),
        }
    }
}

impl Trace {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        if self.from > self.to {
            let (first, last) = (self.from, self.to);
            let message = format!("the last step, {last}, is before the first one, {first}");
            return Err(Failure::Usage(message));
        }
        refuse_overwriting(&[&self.input.input], [&self.output])?;
        let format = self.format()?;
        let input = self.input.read(|_| ())?;
        let name = self.input.name();
        let run = Run {
            arguments: self,
            name: &name,
            format,
        };
        self.scalar.apply(&name, &input, run)
    }

    fn is_stdout(&self) -> bool {
        self.output == Path::new(STDOUT)
    }

    fn format(&self) -> Result<Format, Failure> {
        if self.is_stdout() {
            return Ok(self.output_format);
        }
        let extension = self.output.extension().unwrap_or_default();
        let is_named = |format: &Format| extension.eq_ignore_ascii_case(format.name());
        let format = Format::ALL.into_iter().find(is_named);
        format.ok_or_else(|| {
            let path = self.output.display();
            Failure::Usage(format!(
                "{path}: only .txt, .jsonl, .html and .svg can be written"
            ))
        })
    }
}

/// A run with an input that is read.
struct Run<'a> {
    arguments: &'a Trace,
    name: &'a str,
    format: Format,
}

impl Job for Run<'_> {
    fn run<S: Coordinate, T: Scalar + Sync>(
        self,
        graph: &Graph<S>,
        points: &[[T; 2]],
        _scalar: &'static str,
    ) -> Result<(), Failure> {
        let Trace {
            settings, output, ..
        } = self.arguments;
        let [first, last] = [self.arguments.from, self.arguments.to].map(NonZeroUsize::get);
        let mut events = Vec::new();
        let mut step = 0;
        let observer = |event| {
            step += 1;
            if self.format.needs_all() || (first..=last).contains(&step) {
                events.push(event);
            }
        };
        let result = settings.observe(points, &graph.edges, observer);
        result.map_err(|error| {
            Failure::Error(format!("{}: {}", self.name, graph.as_numbered(error)))
        })?;
        if first > step {
            let name = self.name;
            let message = format!("{name}: there is no step {first}, the last one is {step}");
            return Err(Failure::Error(message));
        }
        let write = |out: &mut dyn Write| self.format.write(graph, events, first..=last, out);
        if self.arguments.is_stdout() {
            return print(|out| write(out));
        }
        let mut drafts = Drafts::default();
        drafts.add(output, |out| write(out))?;
        drafts.persist()
    }
}

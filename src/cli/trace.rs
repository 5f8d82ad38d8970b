//! `sweep-cdt trace`: every step of the sweep, in the paper's words.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use sweep_cdt::Scalar;
use sweep_cdt::formats::{Coordinate, Graph};

use super::draft::Drafts;
use super::failure::Failure;
use super::input::InputArgs;
use super::output::{print, refuse_overwriting};
use super::scalar::{Job, ScalarArgs};
use super::settings::Settings;

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

    /// File to write: .txt or .jsonl; `-` for standard output, as by default
    #[arg(short, long, value_name = "OUTPUT", default_value = STDOUT)]
    output: PathBuf,

    /// Format of standard output
    #[arg(long, value_name = "FORMAT", default_value = "txt", value_parser = super::names(Format::ALL, Format::name))]
    to: Format,

    /// First step to write, counted from 1
    #[arg(long, value_name = "K", default_value_t = 1)]
    first: usize,

    /// Last step to write
    #[arg(long, value_name = "K", default_value_t = usize::MAX, hide_default_value = true)]
    last: usize,

    #[command(flatten)]
    scalar: ScalarArgs,

    #[command(flatten)]
    settings: Settings,
}

const AFTER_HELP: &str = "\
Output:
  .txt     to be read beside the paper: `point 7: middle case, projected on segment 3 5`
  .jsonl   JSON Lines, for programs
  Both begin with a line that gives the version, so that step k is line k + 1. The same input gives
  the same steps for every scalar and front; heuristics change them.

Exit status:
  0  done   1  wrong input, nothing is written   2  wrong usage

Examples:
  sweep-cdt trace terrain.poly --heuristics paper | less
  sweep-cdt trace terrain.poly -o steps.jsonl && sweep-cdt replay steps.jsonl";

#[derive(Clone, Copy)]
enum Format {
    Text,
    JsonLines,
}

impl Format {
    const ALL: [Format; 2] = [Format::Text, Format::JsonLines];

    fn name(self) -> &'static str {
        match self {
            Format::Text => "txt",
            Format::JsonLines => "jsonl",
        }
    }

    fn write(self, trace: &sweep_cdt::trace::Trace, out: impl Write) -> io::Result<()> {
        match self {
            Format::Text => trace.write_text(out),
            Format::JsonLines => trace.write_lines(out),
        }
    }
}

impl Trace {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
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
            return Ok(self.to);
        }
        let extension = self.output.extension().unwrap_or_default();
        let is_named = |format: &Format| extension.eq_ignore_ascii_case(format.name());
        let format = Format::ALL.into_iter().find(is_named);
        format.ok_or_else(|| {
            let path = self.output.display();
            Failure::Usage(format!("{path}: only .txt and .jsonl can be written"))
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
            settings,
            first,
            last,
            output,
            ..
        } = self.arguments;
        let mut trace = sweep_cdt::trace::Trace {
            skipped: first.saturating_sub(1),
            events: Vec::new(),
        };
        let mut step = 0;
        let observer = |event| {
            step += 1;
            if (*first..=*last).contains(&step) {
                trace.events.push(event);
            }
        };
        let result = settings.observe(points, &graph.edges, observer);
        result.map_err(|error| {
            Failure::Error(format!("{}: {}", self.name, graph.as_numbered(error)))
        })?;
        if self.arguments.is_stdout() {
            return print(|out| self.format.write(&trace, out));
        }
        let mut drafts = Drafts::default();
        drafts.add(output, |out| self.format.write(&trace, out))?;
        drafts.persist()
    }
}

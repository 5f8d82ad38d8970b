//! `sweep-cdt replay`: the triangles that a trace builds.

use std::io::Write;

use sweep_cdt::trace::Trace;

use crate::shared::failure::Failure;
use crate::shared::files::{FileArgument, FilesRead};
use crate::shared::outputs::print;

/// Rebuild the triangles from a trace
///
/// Repeats the steps of a trace on an empty mesh, without any geometry, and prints the triangles. If no
/// run can have made the trace (it is cut short, shuffled or edited), names the first wrong line.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct Replay {
    /// Trace to read, text or JSON Lines; `-` for standard input
    #[arg(value_name = "TRACE")]
    trace: FileArgument,
}

const AFTER_HELP: &str = "\
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
        let trace = Trace::parse(&text);
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

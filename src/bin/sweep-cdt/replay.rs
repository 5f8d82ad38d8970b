//! `sweep-cdt replay`: a trace, taken step by step on an empty mesh.

use std::io::Write;

use sweep_cdt::trace::Trace;

use crate::shared::failure::Failure;
use crate::shared::file_argument::FileArg;
use crate::shared::output::print;

/// Rebuild the triangles from a trace
///
/// Takes the steps of a trace on an empty mesh, without any geometry, and prints the triangles, or says
/// in which line the trace is one that no run can have made: cut short, shuffled or edited.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct Replay {
    /// Trace to read, text or JSON Lines; `-` for standard input
    #[arg(value_name = "TRACE")]
    trace: FileArg,
}

const AFTER_HELP: &str = "\
Output: one triangle a line, its vertices counter-clockwise from the lowest, numbered from 0; sorted,
as in the .json that `sweep-cdt triangulate` writes.

Exit status:
  0  done   1  no whole trace, or unreadable   2  wrong usage";

impl Replay {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let source = self.trace.load()?;
        let text = String::from_utf8_lossy(&source.bytes);
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

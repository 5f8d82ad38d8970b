//! What a stream says in the end: why it has failed, or counts and times as a table.

use std::io::{self, Write};
use std::time::Duration;

use sweep_cdt::verify::Level;
use sweep_cdt_stream::external::{Statistics, Summary};
use sweep_cdt_stream::{StreamError, StreamStats};

use super::{Outcome, StreamCommand, Trouble};
use crate::shared::failure::{Failure, printable};
use crate::shared::files::FileArgument;
use crate::shared::outputs::print;

impl StreamCommand {
    /// Prints what has come of it; `kept` says where the triangles are of a stream that keeps too much alive.
    pub(super) fn report(
        &self,
        outcome: Outcome,
        summary: &Summary,
        kept: &str,
    ) -> Result<(), Failure> {
        let input = self.name();
        let stats = match outcome.ended {
            Ok(stats) => stats,
            Err(Trouble::Order(error)) => return Err(self.sort.failure(&error)),
            Err(Trouble::Stream(error)) => {
                let advice = match error {
                    StreamError::TooMuchAlive { alive, .. } => {
                        let bytes = (alive.vertices as u64).saturating_mul(self.bytes());
                        format!(" (--memory {}MiB allows so many)", bytes.div_ceil(1 << 20))
                    }
                    _ => String::new(),
                };
                let kept = match error {
                    StreamError::TooMuchAlive { .. } => kept,
                    _ => "",
                };
                return Err(Failure::Error(format!("{input}: {error}{advice}{kept}")));
            }
            Err(Trouble::Crossing([(file, e), (other, g)])) => {
                let crossing = match file == other {
                    true => format!("{}: edges {e} and {g} cross", printable(&file)),
                    false => {
                        let [file, other] = [file, other].map(|name| printable(&name));
                        format!("edge {e} of {file} and edge {g} of {other} cross")
                    }
                };
                return Err(Failure::Error(format!(
                    "{crossing} (where memory holds them, `sweep-cdt crossings` lists all that do)"
                )));
            }
            Err(Trouble::Violation(violation)) => {
                return Err(Failure::Error(format!(
                    "{input}: a bug of sweep-cdt: {violation}"
                )));
            }
            // A reader that has closed its end of the pipe has what it needs.
            Err(Trouble::Out(error)) if error.kind() == io::ErrorKind::BrokenPipe => return Ok(()),
            Err(Trouble::Out(error)) => {
                let name = self.output.as_ref().and_then(FileArgument::path);
                let name = name.unwrap_or("standard output".as_ref());
                return Err(Failure::of_file(name, &error));
            }
            Err(Trouble::Terrain(error)) => {
                return Err(Failure::of_file(self.terrain.name(), &error));
            }
        };
        let is_asked = self.stats || self.output.is_none() && !self.terrain.is_asked();
        print(|out| {
            if is_asked {
                write_table(&stats, &outcome.sorting, outcome.sweeping, summary, out)?;
            }
            if let Some(lines) = &outcome.lines {
                writeln!(out, "{input}: {lines}")?;
            }
            if self.check {
                let what = Level::Canonical.title();
                writeln!(out, "correct: the result is {what} of {input}")?;
            }
            Ok(())
        })
    }
}

/// Writes counts, times and bytes.
fn write_table(
    stats: &StreamStats,
    sorting: &Statistics,
    sweeping: Duration,
    summary: &Summary,
    out: &mut impl Write,
) -> io::Result<()> {
    let alive = stats.most_alive;
    let seconds = |time: Duration| format!("{:.2} s", time.as_secs_f64());
    let rows = [
        ("points", summary.points.to_string()),
        ("edges", summary.edges.to_string()),
        ("triangles", stats.triangles.to_string()),
        ("sides of the hull", stats.hull_sides.to_string()),
        ("equal points", stats.duplicates.to_string()),
        ("windows", stats.windows.to_string()),
        ("vertices alive at most", alive.vertices.to_string()),
        (
            "  triangles waiting for the line",
            alive.circles.to_string(),
        ),
        ("  triangles waiting for edges", alive.edges.to_string()),
        ("  sides of the hull waiting", alive.hull_sides.to_string()),
        ("runs sorted", sorting.runs.to_string()),
        ("bytes of temporary files", sorting.written.to_string()),
        (
            "time of sorting",
            seconds(sorting.reading + sorting.joining),
        ),
        (
            "time of merging, beside the sweep",
            seconds(sorting.merging),
        ),
        ("time of sweeping", seconds(sweeping)),
    ];
    for (name, value) in rows {
        writeln!(out, "{name:<34} {value:>14}")?;
    }
    Ok(())
}

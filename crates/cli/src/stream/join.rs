//! `sweep-cdt join`: bands, and rests of bands, in; triangles that are final, and what is left, out.

use std::error::Error;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use sweep_cdt::Triangulator;
use sweep_cdt_stream::{Final, Rest};

use super::numbers::Width;
use crate::shared::failure::Failure;
use crate::shared::files::FilesRead;
use crate::shared::outputs::{Destination, Outputs, refuse_read, refuse_twice};

/// Triangulate bands of a larger input, and join what is left of them
///
/// Bands of `sweep-cdt stream --band` are triangulated one by one, on any machine. Triangles that no other band can change
/// are written, and the rest is a file, which is joined to the rests above and below. As a set, the triangles of all runs
/// are those of `sweep-cdt triangulate`.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct Join {
    /// Bands and rests that follow each other, from below: .rest
    #[arg(value_name = "REST", required = true)]
    rests: Vec<PathBuf>,

    /// File to write the triangles to that are final now, counter-clockwise: .u32 or .u64 (raw numbers)
    #[arg(short, long = "output", value_name = "OUTPUT")]
    output: PathBuf,

    /// File to write what is left to: .rest. Nothing is left once all bands are joined
    #[arg(long, value_name = "FILE")]
    rest: Option<PathBuf>,
}

const AFTER_HELP: &str = "\
Output:
  .u32, .u64
           three numbers for each triangle, little-endian, of 32 or 64 bits: the positions of its
           corners among the points of the input, from 0. The files of all runs, one after the
           other, are the triangulation
  .rest    what is not final, with a checksum; docs/streaming.md says what is in it
  The same inputs give the same bytes. All outputs are written, or none: a run that was stopped
  may be repeated.

Exit status:
  0  done   1  wrong input: damaged, or bands that do not follow each other   2  wrong usage

Examples:
  sweep-cdt stream points.f64 --band 1000000 -o bands
  sweep-cdt join bands/1.rest -o 1.u32 --rest left/1.rest
  sweep-cdt join bands/2.rest -o 2.u32 --rest left/2.rest
  sweep-cdt join left/1.rest left/2.rest -o last.u32
  cat 1.u32 2.u32 last.u32 > triangles.u32";

impl Join {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let Some(width) = Width::of_path(&self.output) else {
            let name = self.output.display();
            let message =
                format!("{name} is no name for triangles of bands: let it end in .u32 or .u64");
            return Err(Failure::Usage(message));
        };
        let destination = Destination::of_path(self.output.clone())?;
        let left = self.rest.clone().map(Destination::of_path).transpose()?;
        let mut read = FilesRead::in_pieces(false);
        for path in &self.rests {
            read.add(path);
        }
        refuse_read(&read, [&destination].into_iter().chain(&left))?;
        refuse_twice([&destination].into_iter().chain(&left))?;
        let rest = self.joined()?;
        let of = rest.total();
        width.holds(of)?;
        if left.is_none() && !rest.is_complete() {
            let covered = rest.covered();
            let message = format!(
                "these are vertices {} to {} of {of} in the order, so something is left: name its file with --rest",
                covered.start,
                covered.end - 1
            );
            return Err(Failure::Usage(message));
        }
        // The triangles of a band fit in memory as its vertices do.
        let mut triangles = Vec::new();
        let mut session = Triangulator::new().session();
        let settled = rest.settle(&mut session, |found| {
            if let Final::Triangle { corners, .. } = found {
                let written = width.write(corners, &mut triangles);
                written.expect("memory takes all");
            }
        });
        let settled = settled.map_err(|error| Failure::Error(error.to_string()))?;
        let mut outputs = Outputs::default();
        outputs.add(destination, |out| out.write_all(&triangles))?;
        if let Some(left) = left {
            outputs.add(left, |out| out.write_all(&settled.to_bytes()))?;
        }
        outputs.finish()
    }

    /// All rests as one, of which nothing more is final yet.
    fn joined(&self) -> Result<Rest<f64>, Failure> {
        let failure =
            |path: &Path, error: &dyn Error| Failure::Error(format!("{}: {error}", path.display()));
        let mut joined: Option<Rest<f64>> = None;
        for path in &self.rests {
            let bytes = fs::read(path).map_err(|error| Failure::of_file(path, &error))?;
            let rest = Rest::from_bytes(&bytes).map_err(|error| failure(path, &error))?;
            joined = Some(match joined {
                None => rest,
                Some(below) => below
                    .followed_by(rest)
                    .map_err(|error| failure(path, &error))?,
            });
        }
        Ok(joined.expect("at least one is required"))
    }
}

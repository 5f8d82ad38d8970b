//! `sweep-cdt contours`: the contour lines of triangulated terrain.

use std::io::Write;

use num_rational::BigRational;
use sweep_cdt::crossings::Exact;
use sweep_cdt::scalar::Scalar;
use sweep_cdt_formats::{Coordinate, Format, GraphFile, Input, write_lines};
use sweep_cdt_terrain::{Contour, LevelsError, Surface, levels};

use crate::shared::failure::Failure;
use crate::shared::files::{FileArgument, FilesRead, format_of_output, format_parser};
use crate::shared::outputs::{Destination, Outputs, refuse_read};
use crate::shared::terrain::{TerrainArgs, Work};

/// Draw contour lines of triangulated terrain
///
/// Triangulates points and edges that have heights, as `sweep-cdt triangulate` does, and follows each level through
/// the triangles. Lines are closed, or end where the triangles do; the higher ground is on the left of each. Without
/// -o a summary is printed.
#[derive(clap::Args)]
#[command(after_long_help = AFTER_HELP)]
pub(crate) struct Contours {
    #[command(flatten)]
    terrain: TerrainArgs,

    /// How far levels are apart: 50, 0.1 or 1/3
    #[arg(long, value_name = "DISTANCE", value_parser = number)]
    every: BigRational,

    /// A height that is a level; the others are whole distances above and below it
    #[arg(long, value_name = "HEIGHT", value_parser = number, default_value = "0", allow_negative_numbers = true)]
    from: BigRational,

    /// File to write: .geojson, .wkt, .poly, .json, .obj or any other format with lines; `-` for standard output
    #[arg(short, long, value_name = "OUTPUT")]
    output: Option<FileArgument>,

    /// Format of standard output, and of an output whose extension tells none
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(Format::GRAPHS))]
    output_format: Option<Format>,
}

const AFTER_HELP: &str = "\
Heights are the third coordinate, the first attribute of the vertices of a .node or .poly, or a
property of the features of a .geojson or column of a .csv (--height-property).
A triangle with a corner that has no height has no lines, and none are outside of --inside.

A vertex that is exactly at a level counts as a little higher. So no line ever breaks or branches;
a plateau at a level has a line around it, a ridge one that goes there and back, a peak none.

Output:
  .geojson  a feature for each line, with its height as the property elev and as third coordinate
  .wkt      lines, with their heights as third coordinate
  others    a chain of edges for each line; the heights as in the output of `sweep-cdt generate`
  The lines come level by level from the lowest, always in the same order.

Exit status:
  0  done   1  wrong input, nothing written   2  wrong usage

Examples:
  sweep-cdt contours terrain.poly --every 50 -o lines.geojson
  sweep-cdt contours survey.geojson --every 0.5 --from 0.25 --inside even-odd -o lines.wkt";

/// Reads a number exactly.
pub(crate) fn number(text: &str) -> Result<BigRational, String> {
    BigRational::from_text(text).map_err(|error| format!("`{text}` {error}"))
}

impl Contours {
    /// Runs the subcommand.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        if self.every <= BigRational::default() {
            let error = LevelsError::NotPositive;
            return Err(Failure::Usage(format!("--every: {error}")));
        }
        let target = |file: &FileArgument| -> Result<_, Failure> {
            let format = format_of_output(file, self.output_format, Format::GRAPHS)?;
            Ok((format, Destination::of(file)?))
        };
        let target = self.output.as_ref().map(target).transpose()?;
        let mut files = self.terrain.files();
        let input = self.terrain.read(&mut files)?;
        refuse_read(&files, target.iter().map(|(_, output)| output))?;
        match input {
            Input::Doubles(file) => self.write(&file, &files, target),
            Input::Rationals(file) => self.write(&file, &files, target),
        }
    }

    fn write<S: Coordinate + Exact>(
        &self,
        file: &GraphFile<S>,
        files: &FilesRead,
        target: Option<(Format, Destination)>,
    ) -> Result<(), Failure> {
        let name = self.terrain.name();
        let (lines, summary) = self.terrain.surface(file, files, self)?;
        let is_free = target
            .as_ref()
            .is_none_or(|(_, output)| !output.is_standard());
        let closed = lines.iter().filter(|line| line.is_closed()).count();
        let count = lines.len();
        let lines: Vec<(f64, Vec<[f64; 2]>)> = lines
            .into_iter()
            .map(|Contour { level, points }| (level, points))
            .collect();
        let mut outputs = Outputs::default();
        if let Some((format, output)) = target {
            let lines = &lines;
            outputs.add(output, move |out| {
                write_lines(format, lines, file.system.as_ref(), out)
            })?;
        }
        if is_free {
            outputs.add(Destination::standard(), move |out| {
                writeln!(out, "{name}: {summary}, lines {count}, closed {closed}")
            })?;
        }
        outputs.finish()
    }
}

impl<S: Scalar> Work<S> for &Contours {
    type Done = (Vec<Contour>, String);

    fn run(self, surface: &Surface<'_, S>) -> Result<Self::Done, Failure> {
        let name = self.terrain.name();
        let Some([low, high]) = surface.range() else {
            return Ok((Vec::new(), "no triangles with heights".to_owned()));
        };
        let levels = levels(&self.from, &self.every, [low, high])
            .map_err(|error| Failure::Error(format!("{name}: {error}")))?;
        let lines = surface
            .contours(&levels)
            .map_err(|error| Failure::Error(format!("{name}: {error}")))?;
        let (low, high) = (low.text(), high.text());
        let summary = format!("heights {low} to {high}, levels {}", levels.len());
        Ok((lines, summary))
    }
}

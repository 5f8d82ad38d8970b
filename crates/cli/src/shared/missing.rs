//! Vertices without a height, where the outputs need one: what stands in its place.

use std::str::FromStr;

use sweep_cdt_engine::{Missing, MissingError};
use sweep_cdt_formats::{Coordinate, GraphFile, Input};

use super::failure::Failure;
use super::files::FilesRead;
use super::places::located;
use super::splitting::SplitArgs;

/// Arguments that choose it.
#[derive(clap::Args)]
pub(crate) struct MissingArgs {
    /// Height of vertices that have none, if others have: a number, interpolate, or refuse [default: none]
    ///
    /// interpolate takes the height in the triangulation of the vertices that have heights, with the edges between
    /// them: along an edge, or within a triangle. Outside of their hull there is none. refuse ends the run and names
    /// the first such vertex. By default the height stays missing: it is left out, or NaN, as a format has it.
    #[arg(long, value_name = "VALUE|interpolate|refuse", value_parser = Missing::from_str, allow_negative_numbers = true)]
    missing: Option<Missing>,
}

impl MissingArgs {
    /// The input called `name` with these heights.
    pub(crate) fn apply(
        &self,
        name: &str,
        input: Input,
        files: &FilesRead,
    ) -> Result<Input, Failure> {
        let Some(missing) = self.missing else {
            return Ok(input);
        };
        Ok(match input {
            Input::Doubles(file) => Input::Doubles(filled(missing, name, file, files)?),
            Input::Rationals(file) => Input::Rationals(filled(missing, name, file, files)?),
        })
    }
}

fn filled<S: Coordinate>(
    missing: Missing,
    name: &str,
    mut file: GraphFile<S>,
    files: &FilesRead,
) -> Result<GraphFile<S>, Failure> {
    let remark = missing.fill(&mut file).map_err(|error| {
        let error = match error {
            MissingError::Refused { vertex, others } => {
                let vertex = file.vertex_in_words(vertex);
                format!(
                    "{vertex} has no height, and {others} others have none \
                     (--missing interpolate makes them)"
                )
            }
            MissingError::NotTriangulated(error) => {
                format!("{}{}", located(&file, error), SplitArgs::advice(&error))
            }
        };
        Failure::Error(format!("{name}: {error}"))
    });
    files.say(name, remark?.as_slice())?;
    Ok(file)
}

//! The input of a subcommand: a file, or several that are its layers.

use sweep_cdt_formats::{Format, GraphFile, Input, Source};

use super::arguments::InputArgs;
use super::arithmetic::{as_rationals, refuse_non_finite};
use super::failure::Failure;
use super::files::{FileArgument, FilesRead, format_parser, given_format, input_names};

/// Arguments that name the files of an input.
#[derive(clap::Args)]
pub(crate) struct LayersArgs {
    /// File to read: .node, .poly, .json, .obj, .off, .csv, .xyz, .txt, .ply, .vtk, .vtu, .vtp, .msh, .geojson, .wkt, .npy,
    /// .npz, or .las and .laz in a build with the feature `las`; `-` for standard input. Several are layers of one input: contour lines, a border and breaklines, for example
    #[arg(value_name = "INPUT", required = true)]
    inputs: Vec<FileArgument>,

    /// Format of the input; of several inputs, of those whose extension tells none [default: by its extension]
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(Format::INPUTS))]
    input_format: Option<Format>,
}

impl LayersArgs {
    /// Files that another argument names.
    pub(crate) fn new(inputs: &[FileArgument], input_format: Option<Format>) -> LayersArgs {
        LayersArgs {
            inputs: inputs.to_vec(),
            input_format,
        }
    }

    /// The name of the input in messages.
    pub(crate) fn name(&self) -> String {
        input_names(&self.inputs)
    }

    /// Reads the input.
    pub(crate) fn read(&self, files: &mut FilesRead) -> Result<Input, Failure> {
        self.read_shown(files, |_| ())
    }

    /// Reads the input; `show` is called with each file that is read.
    pub(crate) fn read_shown(
        &self,
        files: &mut FilesRead,
        mut show: impl FnMut(&Source),
    ) -> Result<Input, Failure> {
        let columns = std::mem::take(&mut files.columns);
        let classes = std::mem::take(&mut files.classes);
        let input = |file: &FileArgument| {
            let count = self.inputs.len();
            let format = given_format(file, count, self.input_format, Format::INPUTS);
            InputArgs::new(file.clone(), format)
        };
        let inputs: Vec<InputArgs> = self.inputs.iter().map(input).collect();
        let has_clouds = inputs.iter().any(InputArgs::is_cloud);
        let mut layers = Vec::with_capacity(inputs.len());
        for input in inputs {
            files.columns.clone_from(&columns);
            // Classes are those of clouds; where there is none, they are refused.
            if input.is_cloud() || !has_clouds {
                files.classes.clone_from(&classes);
            }
            layers.push((input.name(), input.read(files, &mut show)?));
        }
        if layers.len() == 1 {
            let (_, input) = layers.remove(0);
            return Ok(input);
        }
        put_together(layers)
    }
}

/// Puts layers together, each with its name; with the exact values of all numbers, if one has fractions.
fn put_together(layers: Vec<(String, Input)>) -> Result<Input, Failure> {
    let (mut doubles, mut rationals) = (Vec::new(), Vec::new());
    let has_fractions = layers
        .iter()
        .any(|(_, input)| matches!(input, Input::Rationals(_)));
    for (name, input) in layers {
        match input {
            Input::Doubles(file) if !has_fractions => {
                refuse_non_finite(&name, &file)?;
                doubles.push((name, file));
            }
            input => rationals.push((name.clone(), as_rationals(&name, input)?)),
        }
    }
    Ok(if has_fractions {
        Input::Rationals(GraphFile::of_layers(rationals)?)
    } else {
        Input::Doubles(GraphFile::of_layers(doubles)?)
    })
}

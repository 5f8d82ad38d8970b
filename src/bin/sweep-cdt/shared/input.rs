//! What a subcommand reads: a graph, and a result to verify.

use sweep_cdt::formats::{Input, InputFormat, ResultFormat, Source, read};

use super::failure::Failure;
use super::files::{FileArgument, FilesRead, format_of_input, format_parser};

/// Arguments that name an input.
#[derive(clap::Args)]
pub(crate) struct InputArgs {
    /// File to read: .node, .poly or .json; `-` for standard input
    #[arg(value_name = "INPUT")]
    pub(crate) input: FileArgument,

    /// Format of the input [default: by its extension]
    #[arg(long, value_name = "FORMAT", value_parser = format_parser::<InputFormat>())]
    input_format: Option<InputFormat>,
}

impl InputArgs {
    /// What messages call the input.
    pub(crate) fn name(&self) -> String {
        self.input.input_name()
    }

    /// Reads the input; `show` is called with each file that is read.
    pub(crate) fn read(
        &self,
        files: &mut FilesRead,
        mut show: impl FnMut(&Source),
    ) -> Result<Input, Failure> {
        let format = format_of_input(&self.input, "--input-format", self.input_format)?;
        let source = files.load(&self.input)?;
        show(&source);
        // The `.node` beside a `.poly` is loaded only if the `.poly` turns out to need it.
        match (read(format, &source, None), self.input.beside("node")) {
            (Err(error), Some(file)) if error.missing_node => {
                let node = files.load(&file)?;
                show(&node);
                Ok(read(format, &source, Some(&node))?)
            }
            (input, _) => Ok(input?),
        }
    }
}

/// Arguments that name a result.
#[derive(clap::Args)]
pub(crate) struct ResultArgs {
    /// Triangulation of the input: .ele (and the .node beside it), .json or .obj; `-` for standard
    /// input
    #[arg(value_name = "RESULT")]
    pub(crate) result: FileArgument,

    /// Format of the result [default: by its extension]
    #[arg(long, value_name = "FORMAT", value_parser = format_parser::<ResultFormat>())]
    result_format: Option<ResultFormat>,
}

/// A result in memory.
pub(crate) struct ResultFiles {
    pub(crate) format: ResultFormat,
    pub(crate) source: Source,
    /// The `.node` beside a `.ele`.
    pub(crate) node: Option<Source>,
}

impl ResultArgs {
    /// Loads the result; `show` is called with each file of it.
    pub(crate) fn load(
        &self,
        files: &mut FilesRead,
        mut show: impl FnMut(&Source),
    ) -> Result<ResultFiles, Failure> {
        let format = format_of_input(&self.result, "--result-format", self.result_format)?;
        let source = files.load(&self.result)?;
        show(&source);
        let node = match format {
            ResultFormat::Ele => self.result.beside("node").filter(FileArgument::exists),
            _ => None,
        };
        let node = node
            .map(|file| files.load(&file).inspect(show))
            .transpose()?;
        Ok(ResultFiles {
            format,
            source,
            node,
        })
    }
}

//! What a subcommand reads: a graph, and a result to verify.

use sweep_cdt::formats::{Input, InputFormat, ReadError, ResultFormat, Source, read};

use super::failure::Failure;
use super::file_argument::{FileArg, load};

/// Arguments that name an input.
#[derive(clap::Args)]
pub(crate) struct InputArgs {
    /// File to read: .node, .poly or .json; `-` for standard input
    #[arg(value_name = "INPUT")]
    pub(crate) input: FileArg,

    /// Format of the input, where its name does not end in it
    #[arg(long, value_name = "FORMAT", value_parser = super::format::names(InputFormat::ALL, InputFormat::name))]
    input_format: Option<InputFormat>,
}

impl InputArgs {
    /// How messages call the input.
    pub(crate) fn name(&self) -> String {
        self.input.name()
    }

    /// Reads the input, and shows each file that it is read from.
    pub(crate) fn read(&self, mut show: impl FnMut(&Source)) -> Result<Input, Failure> {
        let given = ("--input-format", self.input_format);
        let format = self
            .input
            .format(given, InputFormat::ALL, InputFormat::name)?;
        let source = self.input.load()?;
        show(&source);
        let node = || {
            let path = self.input.beside("node").ok_or_else(|| {
                ReadError::of_file(self.name(), "no vertices, and no .node beside it")
            })?;
            load(&path).inspect(show)
        };
        Ok(read(format, &source, node)?)
    }
}

/// Arguments that name a result.
#[derive(clap::Args)]
pub(crate) struct ResultArgs {
    /// Triangulation of it: .ele (and the .node beside it), .json or .obj; `-` for standard input
    #[arg(value_name = "RESULT")]
    pub(crate) result: FileArg,

    /// Format of the result, where its name does not end in it
    #[arg(long, value_name = "FORMAT", value_parser = super::format::names(ResultFormat::ALL, ResultFormat::name))]
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
    /// Loads the result, and shows each file of it.
    pub(crate) fn load(&self, mut show: impl FnMut(&Source)) -> Result<ResultFiles, Failure> {
        let given = ("--result-format", self.result_format);
        let format = self
            .result
            .format(given, ResultFormat::ALL, ResultFormat::name)?;
        let source = self.result.load()?;
        show(&source);
        let node = self
            .result
            .beside("node")
            .filter(|path| format == ResultFormat::Ele && path.exists());
        let node = node.map(|path| load(&path).inspect(show)).transpose()?;
        Ok(ResultFiles {
            format,
            source,
            node,
        })
    }
}

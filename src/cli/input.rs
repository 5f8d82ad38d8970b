//! The input of a subcommand: a file or standard input.

use std::io::{self, Read};
use std::path::{Path, PathBuf};

use sweep_cdt::formats::{Input, InputFormat, ReadError, Source, read};

use super::failure::{Failure, reason};

/// Arguments that name an input.
#[derive(clap::Args)]
pub(crate) struct InputArgs {
    /// File to read: .node, .poly or .json; `-` for standard input
    #[arg(value_name = "INPUT")]
    path: PathBuf,

    /// Format of the input, where its name does not end in it
    #[arg(long, value_name = "FORMAT", value_parser = super::names(InputFormat::ALL, InputFormat::name))]
    from: Option<InputFormat>,
}

impl InputArgs {
    /// How messages call the input.
    pub(crate) fn name(&self) -> String {
        if self.is_stdin() {
            "standard input".to_owned()
        } else {
            self.path.display().to_string()
        }
    }

    /// Whether the input is this file.
    pub(crate) fn is_file(&self, path: &Path) -> bool {
        let place = |path: &Path| std::fs::canonicalize(path).ok();
        !self.is_stdin() && place(path).is_some_and(|other| place(&self.path) == Some(other))
    }

    /// Reads the input.
    pub(crate) fn read(&self) -> Result<Input, Failure> {
        let format = self.format()?;
        let source = if self.is_stdin() {
            self.read_stdin()?
        } else {
            load(&self.path)?
        };
        let node = || {
            if self.is_stdin() {
                return Err(ReadError::of_file(
                    self.name(),
                    "no vertices, and no .node beside it",
                ));
            }
            load(&self.path.with_extension("node"))
        };
        Ok(read(format, &source, node)?)
    }

    fn is_stdin(&self) -> bool {
        self.path == Path::new("-")
    }

    fn format(&self) -> Result<InputFormat, Failure> {
        let by_extension = || {
            let extension = self.path.extension()?;
            InputFormat::ALL
                .into_iter()
                .find(|format| extension.eq_ignore_ascii_case(format.name()))
        };
        self.from.or_else(by_extension).ok_or_else(|| {
            let name = self.name();
            Failure::Usage(format!(
                "the format of {name} is not known by its name: add --from"
            ))
        })
    }

    fn read_stdin(&self) -> Result<Source, ReadError> {
        let mut bytes = Vec::new();
        match io::stdin().lock().read_to_end(&mut bytes) {
            Ok(_) => Ok(Source {
                name: self.name(),
                bytes,
            }),
            Err(error) => Err(ReadError::of_file(self.name(), reason(&error))),
        }
    }
}

/// Reads a file to memory.
pub(crate) fn load(path: &Path) -> Result<Source, ReadError> {
    let name = path.display().to_string();
    match std::fs::read(path) {
        Ok(bytes) => Ok(Source { name, bytes }),
        Err(error) => Err(ReadError::of_file(name, reason(&error))),
    }
}

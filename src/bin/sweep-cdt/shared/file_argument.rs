//! A path on the command line, where `-` stands for standard input or output.

use std::ffi::OsString;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use sweep_cdt::formats::{ReadError, Source};

use super::failure::reason;

/// A file, or standard input or output.
#[derive(Clone)]
pub(crate) enum FileArgument {
    Standard,
    File(PathBuf),
}

impl From<OsString> for FileArgument {
    fn from(text: OsString) -> Self {
        if text == "-" {
            FileArgument::Standard
        } else {
            FileArgument::File(text.into())
        }
    }
}

impl FileArgument {
    /// What messages call it where it is an input.
    pub(crate) fn input_name(&self) -> String {
        match self {
            FileArgument::Standard => "standard input".to_owned(),
            FileArgument::File(path) => path.display().to_string(),
        }
    }

    pub(crate) fn is_standard(&self) -> bool {
        matches!(self, FileArgument::Standard)
    }

    /// The path, if it is a file.
    pub(crate) fn path(&self) -> Option<&Path> {
        match self {
            FileArgument::Standard => None,
            FileArgument::File(path) => Some(path),
        }
    }

    /// Whether it is a file that exists.
    pub(crate) fn exists(&self) -> bool {
        self.path().is_some_and(Path::exists)
    }

    /// Whether it is the file of this path.
    pub(crate) fn is_file(&self, path: &Path) -> bool {
        let place = |path: &Path| std::fs::canonicalize(path).ok();
        let own = self.path().and_then(place);
        own.is_some() && own == place(path)
    }

    /// Reads all of it to memory.
    pub(crate) fn load(&self) -> Result<Source, ReadError> {
        match self {
            FileArgument::File(path) => load(path),
            FileArgument::Standard => {
                let mut bytes = Vec::new();
                let read = io::stdin().lock().read_to_end(&mut bytes);
                source(self.input_name(), read.map(|_| bytes))
            }
        }
    }

    /// The file beside it with another extension; standard input has none.
    pub(crate) fn beside(&self, extension: &str) -> Option<FileArgument> {
        self.path()
            .map(|path| FileArgument::File(path.with_extension(extension)))
    }
}

/// Reads a file to memory.
pub(crate) fn load(path: &Path) -> Result<Source, ReadError> {
    source(path.display().to_string(), std::fs::read(path))
}

fn source(name: String, bytes: io::Result<Vec<u8>>) -> Result<Source, ReadError> {
    match bytes {
        Ok(bytes) => Ok(Source { name, bytes }),
        Err(error) => Err(ReadError::of_file(name, reason(&error))),
    }
}

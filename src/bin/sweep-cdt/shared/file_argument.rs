//! A path on the command line, where `-` stands for standard input or output.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use super::printable::printable;

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
    /// What reports call it where it is an input.
    pub(crate) fn input_name(&self) -> String {
        printable(&self.raw_name())
    }

    /// The same, with all its characters.
    pub(crate) fn raw_name(&self) -> String {
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

    /// The file beside it with another extension; standard input has none.
    pub(crate) fn beside(&self, extension: &str) -> Option<FileArgument> {
        self.path()
            .map(|path| FileArgument::File(path.with_extension(extension)))
    }
}

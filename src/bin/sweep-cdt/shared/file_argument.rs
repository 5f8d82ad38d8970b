//! A file to read, or standard input.

use std::ffi::OsString;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use sweep_cdt::formats::{ReadError, Source};

use super::failure::{Failure, reason};

/// A path from the command line; `-` stands for standard input.
#[derive(Clone)]
pub(crate) struct FileArg(PathBuf);

impl From<OsString> for FileArg {
    fn from(path: OsString) -> Self {
        FileArg(path.into())
    }
}

impl FileArg {
    /// How messages call it.
    pub(crate) fn name(&self) -> String {
        if self.is_stdin() {
            "standard input".to_owned()
        } else {
            self.0.display().to_string()
        }
    }

    pub(crate) fn is_stdin(&self) -> bool {
        self.0 == Path::new("-")
    }

    /// Whether it is this file.
    pub(crate) fn is_file(&self, path: &Path) -> bool {
        let place = |path: &Path| std::fs::canonicalize(path).ok();
        !self.is_stdin() && place(path).is_some_and(|other| place(&self.0) == Some(other))
    }

    /// The path of the file beside it with another extension; standard input has none.
    pub(crate) fn beside(&self, extension: &str) -> Option<PathBuf> {
        (!self.is_stdin()).then(|| self.0.with_extension(extension))
    }

    /// The format, given by an `option` or by the extension.
    pub(crate) fn format<F: Copy, const N: usize>(
        &self,
        (option, given): (&str, Option<F>),
        all: [F; N],
        name: fn(F) -> &'static str,
    ) -> Result<F, Failure> {
        let by_extension = || {
            let extension = self.0.extension()?;
            let is_named = |&format: &F| extension.eq_ignore_ascii_case(name(format));
            all.into_iter().find(is_named)
        };
        given.or_else(by_extension).ok_or_else(|| {
            let name = self.name();
            Failure::Usage(format!(
                "the format of {name} is not known by its name: add {option}"
            ))
        })
    }

    /// Reads all of it to memory.
    pub(crate) fn load(&self) -> Result<Source, ReadError> {
        if !self.is_stdin() {
            return load(&self.0);
        }
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

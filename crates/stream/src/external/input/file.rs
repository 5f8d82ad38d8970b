//! A file that is read in pieces, and must stay as it is meanwhile.

use std::fs::{File, Metadata};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;
use std::time::SystemTime;

use sweep_cdt_formats::{ReadError, reason};

/// The bytes that are read at once.
pub(super) const PIECE: usize = 1 << 18;

/// A file that is open.
#[derive(Debug)]
pub(super) struct InputFile {
    pub(super) name: String,
    file: File,
    /// How long it was when it was opened, and when it had been changed.
    pub(super) length: u64,
    modified: Option<SystemTime>,
    /// How many bytes are read.
    pub(super) at: u64,
}

impl InputFile {
    pub(super) fn open(path: &Path) -> Result<InputFile, ReadError> {
        InputFile::begun(path.display().to_string(), || File::open(path))
    }

    /// A file that is open, from its beginning.
    pub(super) fn of(name: &str, file: &File) -> Result<InputFile, ReadError> {
        InputFile::begun(name.to_owned(), || {
            let mut file = file.try_clone()?;
            file.rewind()?;
            Ok(file)
        })
    }

    fn begun(
        name: String,
        open: impl FnOnce() -> io::Result<File>,
    ) -> Result<InputFile, ReadError> {
        let opened = || -> io::Result<(File, Metadata)> {
            let file = open()?;
            let metadata = file.metadata()?;
            Ok((file, metadata))
        };
        match opened() {
            Err(error) => Err(ReadError::of_file(name, reason(&error))),
            Ok((_, metadata)) if !metadata.is_file() => {
                let message =
                    "is no file: what is read in pieces must be one, not a pipe or a folder";
                Err(ReadError::of_file(name, message))
            }
            Ok((file, metadata)) => Ok(InputFile {
                name,
                file,
                length: metadata.len(),
                modified: metadata.modified().ok(),
                at: 0,
            }),
        }
    }

    /// How many bytes follow.
    pub(super) fn left(&self) -> u64 {
        self.length - self.at
    }

    /// Appends the next bytes, `most` or as many as the file has.
    pub(super) fn read(&mut self, most: usize, bytes: &mut Vec<u8>) -> Result<(), ReadError> {
        let count = usize::try_from(self.left()).map_or(most, |left| left.min(most));
        let from = bytes.len();
        bytes.resize(from + count, 0);
        match self.file.read_exact(&mut bytes[from..]) {
            Ok(()) => {}
            Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => {
                return Err(self.changed());
            }
            Err(error) => return Err(self.error(reason(&error))),
        }
        self.at += count as u64;
        Ok(())
    }

    /// Goes on at this byte.
    pub(super) fn go_to(&mut self, at: u64) -> Result<(), ReadError> {
        match self.file.seek(SeekFrom::Start(at)) {
            Ok(_) => {
                self.at = at;
                Ok(())
            }
            Err(error) => Err(self.error(reason(&error))),
        }
    }

    /// The file, for a reader of its own.
    #[cfg(feature = "las")]
    pub(super) fn handle(&self) -> Result<File, ReadError> {
        let handle = self.file.try_clone();
        handle.map_err(|error| self.error(reason(&error)))
    }

    /// Checks that the file is as long as it was, and as old: what was read of it counts only then.
    pub(super) fn check(&self) -> Result<(), ReadError> {
        match self.file.metadata() {
            Ok(now) if now.len() == self.length && now.modified().ok() == self.modified => Ok(()),
            Ok(_) => Err(self.changed()),
            Err(error) => Err(self.error(reason(&error))),
        }
    }

    fn changed(&self) -> ReadError {
        self.error("the file was changed while it was read: run it again when the file is complete")
    }

    /// An error of the file.
    pub(super) fn error(&self, message: impl Into<String>) -> ReadError {
        ReadError::of_file(&self.name, message)
    }

    /// An error in this line, counted from 1.
    pub(super) fn error_in_line(&self, line: usize, message: impl Into<String>) -> ReadError {
        let mut error = self.error(message);
        error.line = Some(line);
        error
    }
}

//! A temporary file, to which pieces are appended, and from which they are read at their places.
//!
//! On Unix the file has no name (`O_TMPFILE`, or removed when it is opened), elsewhere the system removes it when it is
//! closed. So nothing of it is left, however the process ends.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use crate::external::error::Error;

/// A temporary file.
#[derive(Debug)]
pub(crate) struct Temporary {
    folder: PathBuf,
    file: Option<File>,
    /// How long it is.
    end: u64,
    /// Where the system reads or writes next.
    at: u64,
    read: u64,
}

impl Temporary {
    /// A file that will be made in this folder when something is written.
    pub(crate) fn new(folder: &Path) -> Temporary {
        Temporary {
            folder: folder.to_owned(),
            file: None,
            end: 0,
            at: 0,
            read: 0,
        }
    }

    /// How many bytes it holds.
    pub(crate) fn written(&self) -> u64 {
        self.end
    }

    /// How many bytes were read of it.
    pub(crate) fn read(&self) -> u64 {
        self.read
    }

    /// Appends bytes, and returns where they stand.
    pub(crate) fn append(&mut self, bytes: &[u8]) -> Result<u64, Error> {
        let place = self.end;
        let written = self.move_to(place).and_then(|file| file.write_all(bytes));
        written.map_err(|error| self.error(error))?;
        self.end += bytes.len() as u64;
        self.at = self.end;
        Ok(place)
    }

    /// Fills `bytes` with what stands at a place.
    pub(crate) fn read_at(&mut self, place: u64, bytes: &mut [u8]) -> Result<(), Error> {
        let read = self.move_to(place).and_then(|file| file.read_exact(bytes));
        read.map_err(|error| self.error(error))?;
        self.at = place + bytes.len() as u64;
        self.read += bytes.len() as u64;
        Ok(())
    }

    /// The file, which goes on at this place.
    fn move_to(&mut self, place: u64) -> io::Result<&mut File> {
        let file = match &mut self.file {
            Some(file) => file,
            none => none.insert(tempfile::tempfile_in(&self.folder)?),
        };
        if self.at != place {
            file.seek(SeekFrom::Start(place))?;
            self.at = place;
        }
        Ok(file)
    }

    fn error(&self, error: io::Error) -> Error {
        Error::Temporary {
            folder: self.folder.clone(),
            error,
            written: self.end,
        }
    }
}

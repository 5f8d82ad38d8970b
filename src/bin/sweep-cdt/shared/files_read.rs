//! The files that a run has read, named or by implication: none of them may be overwritten.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use sweep_cdt::formats::{ReadError, Source};

use super::failure::reason;
use super::file_argument::FileArgument;
use super::identity::{Identity, standard_input};
use super::memory::has_room;

/// Regular files that were read.
#[derive(Default)]
pub(crate) struct FilesRead(Vec<Identity>);

impl FilesRead {
    /// Reads all of a file to memory, and notes which one it is.
    pub(crate) fn load(&mut self, file: &FileArgument) -> Result<Source, ReadError> {
        let name = file.raw_name();
        let read = match file {
            FileArgument::File(path) => read(path),
            FileArgument::Standard => {
                let mut bytes = Vec::new();
                let read = io::stdin().lock().read_to_end(&mut bytes);
                let which = standard_input().filter(|(kind, _)| kind.is_file());
                read.map(|_| (bytes, which.map(|(_, identity)| identity)))
            }
        };
        match read {
            // What is read from text takes about as much memory as the text.
            Ok((bytes, _)) if !has_room(bytes.len() as u64) => {
                Err(ReadError::of_file(name, "out of memory"))
            }
            Ok((bytes, identity)) => {
                self.0.extend(identity);
                Ok(Source { name, bytes })
            }
            Err(error) => Err(ReadError::of_file(name, reason(&error))),
        }
    }

    /// Whether this file was read.
    pub(crate) fn has(&self, identity: &Identity) -> bool {
        self.0.contains(identity)
    }
}

fn read(path: &Path) -> io::Result<(Vec<u8>, Option<Identity>)> {
    let mut file = File::open(path)?;
    let metadata = file.metadata()?;
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)?;
    let identity = metadata
        .is_file()
        .then(|| Identity::there(path, &metadata))
        .transpose()?;
    Ok((bytes, identity))
}

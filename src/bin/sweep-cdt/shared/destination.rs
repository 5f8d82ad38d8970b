//! Where an output goes, found out before the work begins.

use std::ffi::OsStr;
use std::fs::{self, Metadata, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

use super::failure::Failure;
use super::file_argument::FileArgument;
use super::identity::{Identity, standard_output};
use super::unnamed::{Unnamed, folder};

/// An output that can be written.
pub(crate) struct Destination {
    /// What messages call it.
    pub(crate) name: PathBuf,
    pub(crate) place: Place,
    /// Which file it is, where the system tells; a device is none.
    pub(crate) identity: Option<Identity>,
}

pub(crate) enum Place {
    Standard,
    /// A FIFO or a device: it is written to.
    Stream,
    /// A file, new or replaced when all outputs are complete.
    File(Box<Unnamed>),
}

impl Destination {
    /// Standard output.
    pub(crate) fn standard() -> Destination {
        Destination {
            name: PathBuf::from("standard output"),
            place: Place::Standard,
            identity: standard_output()
                .filter(|(metadata, _)| !is_device(metadata))
                .map(|(_, identity)| identity),
        }
    }

    /// The place that an argument names.
    pub(crate) fn of(file: &FileArgument) -> Result<Destination, Failure> {
        match file {
            FileArgument::Standard => Ok(Destination::standard()),
            FileArgument::File(path) => Destination::of_path(path.clone()),
        }
    }

    /// Finds out what a path stands for. Directories, read-only files and new ones in folders that are not
    /// there are refused.
    pub(crate) fn of_path(name: PathBuf) -> Result<Destination, Failure> {
        let found = match fs::metadata(&name) {
            Ok(metadata) => there(&name, &metadata),
            Err(error) if error.kind() == io::ErrorKind::NotFound => absent(&name),
            Err(error) => Err(error),
        };
        match found {
            Err(error) => Err(Failure::of_file(&name, &error)),
            Ok((place, identity)) => Ok(Destination {
                name,
                place,
                identity,
            }),
        }
    }

    pub(crate) fn is_standard(&self) -> bool {
        matches!(self.place, Place::Standard)
    }

    pub(crate) fn is_file(&self) -> bool {
        matches!(self.place, Place::File(_))
    }
}

fn there(path: &Path, metadata: &Metadata) -> io::Result<(Place, Option<Identity>)> {
    let identity = Identity::there(path, metadata)?;
    if metadata.is_dir() {
        return Err(io::ErrorKind::IsADirectory.into());
    }
    if is_device(metadata) {
        return Ok((Place::Stream, None));
    }
    // What standard output was redirected to is written through it, from where it stands.
    if standard_output().is_some_and(|(_, standard)| standard == identity) {
        return Ok((Place::Standard, Some(identity)));
    }
    if !metadata.is_file() {
        return Ok((Place::Stream, Some(identity)));
    }
    // Replacing needs no right to write to the file, but who took it away meant the contents.
    if metadata.permissions().readonly() {
        return Err(io::Error::other("is read-only"));
    }
    OpenOptions::new().write(true).open(path)?;
    let path = fs::canonicalize(path)?;
    let file = Unnamed::new(path, Some(metadata.clone()))?;
    Ok((Place::File(Box::new(file)), Some(identity)))
}

/// Whether it is a terminal, `/dev/null` or the like. Any number of outputs may go there.
fn is_device(metadata: &Metadata) -> bool {
    #[cfg(unix)]
    return std::os::unix::fs::FileTypeExt::is_char_device(&metadata.file_type());
    #[cfg(not(unix))]
    return !metadata.is_file() && !metadata.is_dir();
}

/// A new file, at the end of the symbolic links if the path is one: they lead somewhere, if to no file.
fn absent(path: &Path) -> io::Result<(Place, Option<Identity>)> {
    let mut path = path.to_owned();
    while let Ok(target) = fs::read_link(&path) {
        path = folder(&path).join(target);
    }
    let name = path.file_name().map(OsStr::to_owned);
    let name = name.ok_or(io::ErrorKind::NotFound)?;
    let identity = Identity::new(&folder(&path), name)?;
    let file = Unnamed::new(path, None)?;
    Ok((Place::File(Box::new(file)), Some(identity)))
}

//! Which file a path or a standard stream is, whatever it is called.
//!
//! On Unix a file is its device and inode, so symbolic and hard links lead to the same one. Elsewhere it is
//! its canonical path. A file that is still to be made is its folder and its name.

use std::ffi::OsString;
use std::fs::{self, Metadata};
use std::io;
use std::path::Path;

#[cfg(unix)]
type Key = (u64, u64);
#[cfg(not(unix))]
type Key = std::path::PathBuf;

/// A file, there or still to be made.
#[derive(Clone, PartialEq, Eq)]
pub(crate) enum Identity {
    There(Key),
    New { folder: Key, name: OsString },
}

impl Identity {
    /// The file of this path, links followed; `metadata` are its own.
    pub(crate) fn there(path: &Path, metadata: &Metadata) -> io::Result<Identity> {
        key(path, metadata).map(Identity::There)
    }

    /// The file of this name that will be made in this folder.
    pub(crate) fn new(folder: &Path, name: OsString) -> io::Result<Identity> {
        let folder = key(folder, &fs::metadata(folder)?)?;
        Ok(Identity::New { folder, name })
    }
}

/// What kind of file standard input is, and which; only Unix tells.
pub(crate) fn standard_input() -> Option<(Metadata, Identity)> {
    #[cfg(unix)]
    return open(io::stdin());
    #[cfg(not(unix))]
    None
}

/// What kind of file standard output is, and which; only Unix tells.
pub(crate) fn standard_output() -> Option<(Metadata, Identity)> {
    #[cfg(unix)]
    return open(io::stdout());
    #[cfg(not(unix))]
    None
}

#[cfg(unix)]
fn open(stream: impl std::os::fd::AsFd) -> Option<(Metadata, Identity)> {
    let file = fs::File::from(stream.as_fd().try_clone_to_owned().ok()?);
    let metadata = file.metadata().ok()?;
    let identity = Identity::there(Path::new(""), &metadata).ok()?;
    Some((metadata, identity))
}

#[cfg(unix)]
#[expect(clippy::unnecessary_wraps, reason = "elsewhere it can fail")]
fn key(_path: &Path, metadata: &Metadata) -> io::Result<Key> {
    use std::os::unix::fs::MetadataExt;
    Ok((metadata.dev(), metadata.ino()))
}

#[cfg(not(unix))]
fn key(path: &Path, _metadata: &Metadata) -> io::Result<Key> {
    fs::canonicalize(path)
}

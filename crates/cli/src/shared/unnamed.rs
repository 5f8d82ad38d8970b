//! A file that has no name until it is complete.
//!
//! However a process ends, the system removes a file without a name. On Linux the file gets a temporary
//! name beside its own and is renamed at once, since only renaming replaces a file in one step. Where a
//! file without a name cannot get one (other systems, some file systems), it is copied to one that has a
//! temporary name. A file that is replaced passes on its owner and its permissions, and none is ever
//! readable for more users than it is in the end. Its other hard links keep the old contents.

use std::fs::{File, Metadata};
use std::io::{self, BufWriter, Seek, Write};
use std::path::{Path, PathBuf};
use std::thread::{self, JoinHandle};

use tempfile::{Builder, TempPath};

/// So many bytes are written at once.
const BUFFER: usize = 1 << 18;

/// The target to which contents are written.
pub(crate) type Out<'w> = BufWriter<&'w mut (dyn Write + Send)>;

/// A file without a name, and the path where it will be.
pub(crate) struct Unnamed {
    file: File,
    path: PathBuf,
    replaced: Option<Metadata>,
    /// The thread that brings it to the disk. If the run fails before, it ends by itself or with the process.
    syncing: Option<JoinHandle<io::Result<()>>>,
}

/// A complete file under a temporary name, which is removed when this is dropped.
pub(crate) struct Named {
    temporary: TempPath,
    path: PathBuf,
}

impl Unnamed {
    /// An empty one. `replaced` is about the file that is at the path now, which is no link.
    pub(crate) fn new(path: PathBuf, replaced: Option<Metadata>) -> io::Result<Unnamed> {
        Ok(Unnamed {
            file: unnamed_in(&folder(&path))?,
            path,
            replaced,
            syncing: None,
        })
    }

    /// Writes all of it, and begins to bring it to the disk; [`Unnamed::sync`] waits until it is there.
    pub(crate) fn write(
        &mut self,
        contents: impl FnOnce(&mut Out<'_>) -> io::Result<()>,
    ) -> io::Result<()> {
        let mut out = BufWriter::with_capacity(BUFFER, &mut self.file as &mut (dyn Write + Send));
        contents(&mut out)?;
        out.flush()?;
        drop(out);
        if let Some(replaced) = &self.replaced {
            pass_on(replaced, &self.file)?;
        }
        let sync = |file: File| thread::Builder::new().spawn(move || file.sync_all());
        self.syncing = self.file.try_clone().and_then(sync).ok();
        Ok(())
    }

    /// Writes over the beginning.
    pub(crate) fn rewrite_beginning(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.sync()?;
        self.file.rewind()?;
        self.file.write_all(bytes)?;
        self.file.seek(io::SeekFrom::End(0))?;
        Ok(())
    }

    /// Puts it at another path in the end, where no file is replaced but in whole.
    pub(crate) fn rename(&mut self, path: PathBuf) {
        self.path = path;
    }

    /// Waits until it is on the disk. Some file systems notice only now that they are full.
    pub(crate) fn sync(&mut self) -> io::Result<()> {
        match self.syncing.take().map(JoinHandle::join) {
            Some(Ok(synced)) => synced,
            // No thread has done it.
            _ => self.file.sync_all(),
        }
    }

    /// Gives the file a temporary name.
    pub(crate) fn named(self) -> io::Result<Named> {
        let folder = folder(&self.path);
        let mut builder = Builder::new();
        builder.prefix(".sweep-cdt-");
        let temporary = match builder.make_in(&folder, |path| give_name(&self.file, path)) {
            Ok(named) => named.into_temp_path(),
            Err(_) => copied(self.file, self.replaced.as_ref(), &mut builder, &folder)?,
        };
        Ok(Named {
            temporary,
            path: self.path,
        })
    }
}

impl Named {
    /// Puts it in its place.
    pub(crate) fn replace(self) -> io::Result<()> {
        self.temporary
            .persist(self.path)
            .map_err(|error| error.error)
    }
}

/// The folder of a path.
pub(crate) fn folder(path: &Path) -> PathBuf {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder.to_owned(),
        _ => PathBuf::from("."),
    }
}

/// A file without a name, with the permissions that a new file gets.
fn unnamed_in(folder: &Path) -> io::Result<File> {
    #[cfg(target_os = "linux")]
    {
        use rustix::fs::{Mode, OFlags, open};
        let flags = OFlags::TMPFILE | OFlags::RDWR | OFlags::CLOEXEC;
        if let Ok(file) = open(folder, flags, Mode::from_raw_mode(0o666)) {
            return Ok(file.into());
        }
    }
    tempfile::tempfile_in(folder)
}

/// Gives it a name, where the system can do that.
#[cfg(target_os = "linux")]
fn give_name(file: &File, path: &Path) -> io::Result<()> {
    use rustix::fs::{AtFlags, CWD, linkat};
    use std::os::fd::AsRawFd;
    let unnamed = format!("/proc/self/fd/{}", file.as_raw_fd());
    Ok(linkat(CWD, unnamed, CWD, path, AtFlags::SYMLINK_FOLLOW)?)
}

#[cfg(not(target_os = "linux"))]
fn give_name(_file: &File, _path: &Path) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

/// A copy that has a name.
fn copied(
    mut file: File,
    replaced: Option<&Metadata>,
    builder: &mut Builder<'_, '_>,
    folder: &Path,
) -> io::Result<TempPath> {
    #[cfg(unix)]
    if replaced.is_none() {
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    }
    let mut copy = builder.tempfile_in(folder)?;
    file.rewind()?;
    io::copy(&mut file, &mut copy)?;
    if let Some(replaced) = replaced {
        pass_on(replaced, copy.as_file())?;
    }
    copy.as_file().sync_all()?;
    Ok(copy.into_temp_path())
}

/// Passes on owner, group and permissions, as far as this user may.
#[cfg(unix)]
fn pass_on(replaced: &Metadata, file: &File) -> io::Result<()> {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, fchown};
    let owners = |of: &Metadata| (of.uid(), of.gid());
    let mut mode = replaced.mode();
    if owners(&file.metadata()?) != owners(replaced) {
        let (user, group) = owners(replaced);
        let passed = fchown(file, Some(user), Some(group));
        if passed.or_else(|_| fchown(file, None, Some(group))).is_err() {
            // Another group gets nothing of what that of the old file was allowed.
            mode &= !0o070;
        }
    }
    file.set_permissions(PermissionsExt::from_mode(mode))
}

#[cfg(not(unix))]
fn pass_on(_replaced: &Metadata, _file: &File) -> io::Result<()> {
    Ok(())
}

//! Files of which all are written, or none.
//!
//! Each is written to a temporary file in its folder. Only when all are complete are they renamed. If
//! one rename fails, the files renamed before it are removed again.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use super::failure::Failure;

/// Complete files under temporary names; they are removed when this is dropped.
#[derive(Default)]
pub(crate) struct AtomicFiles(Vec<(NamedTempFile, PathBuf)>);

impl AtomicFiles {
    /// Writes one more file, under its temporary name.
    pub(crate) fn add(
        &mut self,
        path: &Path,
        write: impl FnOnce(&mut BufWriter<&mut NamedTempFile>) -> io::Result<()>,
    ) -> Result<(), Failure> {
        let complete = || {
            let mut file = temporary_beside(path)?;
            let mut out = BufWriter::new(&mut file);
            write(&mut out)?;
            out.flush()?;
            drop(out);
            Ok(file)
        };
        let file = complete().map_err(|error| Failure::of_file(path, &error))?;
        self.0.push((file, path.to_owned()));
        Ok(())
    }

    /// Renames all files to their own names.
    pub(crate) fn persist(self) -> Result<(), Failure> {
        let mut done = Vec::new();
        for (file, path) in self.0 {
            if let Err(error) = file.persist(&path) {
                for path in done {
                    // Best effort: the failure to report is the first one.
                    let _ = fs::remove_file(path);
                }
                return Err(Failure::of_file(&path, &error.error));
            }
            done.push(path);
        }
        Ok(())
    }
}

/// A new file in the folder of `path`, with the permissions that any new file gets.
fn temporary_beside(path: &Path) -> io::Result<NamedTempFile> {
    let folder = path.parent().filter(|folder| *folder != Path::new(""));
    let mut builder = tempfile::Builder::new();
    builder.prefix(".sweep-cdt-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder.unwrap_or(Path::new(".")))
}

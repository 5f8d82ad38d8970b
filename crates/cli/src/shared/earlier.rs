//! Files of an earlier run, where this one should have written and did not.
//!
//! A run that fails changes no file. So a certificate of an earlier run stays, and could be taken for one of this run: a note
//! tells them apart.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use super::failure::{Failure, note};

/// The files that are there, each with the time of its last change.
pub(crate) struct Earlier(Vec<(PathBuf, SystemTime)>);

impl Earlier {
    pub(crate) fn of<'a>(paths: impl IntoIterator<Item = &'a Path>) -> Earlier {
        let there = paths
            .into_iter()
            .filter_map(|path| Some((path.to_owned(), changed(path)?)));
        Earlier(there.collect())
    }

    /// Says of each file that it is of an earlier run, if this run failed and did not write it.
    pub(crate) fn note_if_failed(self, result: Result<(), Failure>) -> Result<(), Failure> {
        for (path, time) in self.0.iter().filter(|_| result.is_err()) {
            if changed(path) == Some(*time) {
                let name = path.display();
                note(format_args!(
                    "{name} is of an earlier run: this one wrote no certificate"
                ));
            }
        }
        result
    }
}

/// When a file was changed last; `None` of what is no file.
fn changed(path: &Path) -> Option<SystemTime> {
    let metadata = fs::metadata(path).ok()?;
    metadata.is_file().then(|| metadata.modified().ok())?
}

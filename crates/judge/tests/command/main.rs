//! What a user of `sweep-cdt-judge` sees: adapters in Python with planted faults, and the suite of conformance.

mod adapters;
mod document;
mod schema;
mod suite;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A file of the repository.
fn path(inside: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(inside)
}

/// Runs the command in a folder.
fn judge(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sweep-cdt-judge"));
    command.args(arguments).current_dir(folder);
    command.output().expect("the command can be run")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

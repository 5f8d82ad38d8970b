//! Why a subcommand ends early.

use std::io;
use std::path::Path;

use sweep_cdt::formats::ReadError;

/// What the process prints and how it exits.
pub(crate) enum Failure {
    /// The arguments contradict each other, or would have the run overwrite what it must not.
    Usage(String),
    /// The input is wrong, or a file cannot be read or written.
    Error(String),
    /// The verifier found violations; they are printed already.
    Wrong,
}

impl Failure {
    /// A failure to read or write a file.
    pub(crate) fn of_file(path: &Path, error: &io::Error) -> Failure {
        Failure::Error(format!("{}: {}", path.display(), reason(error)))
    }
}

impl From<ReadError> for Failure {
    fn from(error: ReadError) -> Self {
        Failure::Error(error.to_string())
    }
}

/// The system's message without its error number.
pub(crate) fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    text.split(" (os error")
        .next()
        .unwrap_or(&text)
        .to_lowercase()
}

//! Why a subcommand ends early, and messages that a terminal shows and does not obey.

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

/// The text with its control characters escaped. File names may hold any of them but zero.
pub(crate) fn printable(text: &str) -> String {
    escaped(text, char::is_control)
}

/// The same for text of several lines.
pub(crate) fn printable_lines(text: &str) -> String {
    escaped(text, |character| {
        character != '\n' && character.is_control()
    })
}

fn escaped(text: &str, is_unsafe: impl Fn(char) -> bool) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        if is_unsafe(character) {
            escaped.extend(character.escape_default());
        } else {
            escaped.push(character);
        }
    }
    escaped
}

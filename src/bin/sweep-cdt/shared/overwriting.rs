//! Outputs that would overwrite what they must not. All are refused before anything is written.

use super::destination::Destination;
use super::failure::Failure;
use super::files_read::FilesRead;

/// Refuses outputs that were read, whatever they are called.
pub(crate) fn refuse<'a>(
    read: &FilesRead,
    outputs: impl IntoIterator<Item = &'a Destination>,
) -> Result<(), Failure> {
    let was_read =
        |output: &&Destination| output.identity.as_ref().is_some_and(|file| read.has(file));
    match outputs.into_iter().find(was_read) {
        None => Ok(()),
        Some(output) => Err(Failure::Usage(format!(
            "{} is an input and would be overwritten",
            output.name.display()
        ))),
    }
}

/// Refuses two outputs that are one file.
pub(crate) fn refuse_twice<'a>(
    outputs: impl IntoIterator<Item = &'a Destination>,
) -> Result<(), Failure> {
    let mut seen: Vec<&Destination> = Vec::new();
    for output in outputs {
        let is_same = |other: &&&Destination| {
            output.identity.is_some() && output.identity == other.identity
                || output.is_standard() && other.is_standard()
        };
        if let Some(other) = seen.iter().find(is_same) {
            let [first, second] = [other, output].map(|output| output.name.display());
            let message =
                format!("{first} and {second} are the same file and would both be written");
            return Err(Failure::Usage(message));
        }
        seen.push(output);
    }
    Ok(())
}

//! The outputs of a run: all of them are written, or none.
//!
//! Files are written whole while they have no names. Then standard output, FIFOs and devices are written,
//! which nobody can take back. Last, when nothing else can fail, the files get temporary names, and then
//! their own ones. Should one of them fail even so, the error says which are in place already.

use std::fs::OpenOptions;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::destination::{Destination, Place};
use super::failure::{Failure, reason};
use super::signals::undivided;
use super::unnamed::{Out, Unnamed};

type Contents<'a> = Box<dyn FnOnce(&mut Out<'_>) -> io::Result<()> + 'a>;

/// Outputs that are ready to be put in their places.
#[derive(Default)]
pub(crate) struct Outputs<'a> {
    files: Vec<(PathBuf, Unnamed)>,
    streams: Vec<(Destination, Contents<'a>)>,
}

impl<'a> Outputs<'a> {
    /// Adds an output. A file is written now, under no name; a stream when all files are.
    pub(crate) fn add(
        &mut self,
        destination: Destination,
        contents: impl FnOnce(&mut Out<'_>) -> io::Result<()> + 'a,
    ) -> Result<(), Failure> {
        let Destination { name, place, .. } = destination;
        if let Place::File(mut file) = place {
            let written = file.write(contents);
            written.map_err(|error| Failure::of_file(&name, &error))?;
            self.files.push((name, *file));
        } else {
            let stream = Destination {
                name,
                place,
                ..destination
            };
            self.streams.push((stream, Box::new(contents)));
        }
        Ok(())
    }

    /// Puts all of them in their places.
    pub(crate) fn finish(self) -> Result<(), Failure> {
        for (destination, contents) in self.streams {
            let written = match destination.place {
                Place::Standard => write(&mut io::stdout().lock(), contents),
                _ => OpenOptions::new()
                    .write(true)
                    .open(&destination.name)
                    .and_then(|mut stream| write(&mut stream, contents)),
            };
            written.map_err(|error| Failure::of_file(&destination.name, &error))?;
        }
        undivided(|changed| replace(self.files, changed))
    }
}

/// Writes to standard output.
pub(crate) fn print(contents: impl FnOnce(&mut Out<'_>) -> io::Result<()>) -> Result<(), Failure> {
    let mut outputs = Outputs::default();
    outputs.add(Destination::standard(), contents)?;
    outputs.finish()
}

/// Writes to a stream. A reader that has closed its end of it is no failure.
fn write(
    stream: &mut dyn Write,
    contents: impl FnOnce(&mut Out<'_>) -> io::Result<()>,
) -> io::Result<()> {
    let mut out = BufWriter::new(stream);
    match contents(&mut out).and_then(|()| out.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        written => written,
    }
}

/// Puts files in their places, and notes when the first one is there.
fn replace(files: Vec<(PathBuf, Unnamed)>, changed: &mut bool) -> Result<(), Failure> {
    let named = files.into_iter().map(|(name, file)| match file.named() {
        Ok(file) => Ok((name, file)),
        Err(error) => Err(Failure::of_file(&name, &error)),
    });
    let named = named.collect::<Result<Vec<_>, _>>()?;
    let mut done = Vec::new();
    for (name, file) in named {
        if let Err(error) = file.replace() {
            return Err(half_done(&name, &error, &done));
        }
        *changed = true;
        done.push(name.display().to_string());
    }
    Ok(())
}

fn half_done(name: &Path, error: &io::Error, done: &[String]) -> Failure {
    if done.is_empty() {
        return Failure::of_file(name, error);
    }
    let (name, reason, done) = (name.display(), reason(error), done.join(", "));
    Failure::Error(format!("{name}: {reason}; written already: {done}"))
}

//! The outputs of a run: all of them are written, or none. Where they go is found out before the work begins, and
//! what would overwrite what it must not is refused before anything is written.
//!
//! Files are written whole while they have no names, and brought to the disk. Then standard output, FIFOs and devices are written,
//! which nobody can take back. Last, when nothing else can fail, the files get temporary names, and then
//! their own ones. Should one of them fail even so, the error says which are in place already.

use std::ffi::OsStr;
use std::fs::{self, Metadata, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use sweep_cdt_formats::reason;

use super::failure::{Failure, undivided};
use super::files::{FileArgument, FilesRead, Identity, standard_output};
use super::unnamed::{Unnamed, folder};

pub(crate) use super::unnamed::Out;

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

    /// Adds an output of which a part may be of use: `contents` tells whether it is whole. The name of a file that is not
    /// ends in `.incomplete`.
    pub(crate) fn add_part(
        &mut self,
        destination: Destination,
        contents: impl FnOnce(&mut Out<'_>) -> io::Result<bool>,
    ) -> Result<(), Failure> {
        let Destination {
            mut name, place, ..
        } = destination;
        let mut is_whole = true;
        let contents = |out: &mut Out<'_>| {
            is_whole = contents(out)?;
            Ok(())
        };
        match place {
            Place::File(mut file) => {
                let written = file.write(contents);
                written.map_err(|error| Failure::of_file(&name, &error))?;
                if !is_whole {
                    name = of_part(&name);
                    file.rename(name.clone());
                }
                self.files.push((name, *file));
                Ok(())
            }
            place => write_to(&name, &place, contents),
        }
    }

    /// Writes over the beginning of the file that was added last.
    pub(crate) fn rewrite_beginning(&mut self, text: &str) -> Result<(), Failure> {
        match self.files.last_mut() {
            Some((name, file)) if !text.is_empty() => {
                let written = file.rewrite_beginning(text.as_bytes());
                written.map_err(|error| Failure::of_file(name, &error))
            }
            _ => Ok(()),
        }
    }

    /// Adds other outputs, whose files are written.
    pub(crate) fn append(&mut self, others: Outputs<'a>) {
        self.files.extend(others.files);
        self.streams.extend(others.streams);
    }

    /// Puts all of them in their places.
    pub(crate) fn finish(mut self) -> Result<(), Failure> {
        for (name, file) in &mut self.files {
            file.sync()
                .map_err(|error| Failure::of_file(name, &error))?;
        }
        for (destination, contents) in self.streams {
            write_to(&destination.name, &destination.place, contents)?;
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

/// Writes to standard output, a FIFO or a device.
fn write_to(
    name: &Path,
    place: &Place,
    contents: impl FnOnce(&mut Out<'_>) -> io::Result<()>,
) -> Result<(), Failure> {
    let written = match place {
        Place::Standard => write(&mut io::stdout(), contents),
        _ => OpenOptions::new()
            .write(true)
            .open(name)
            .and_then(|mut stream| write(&mut stream, contents)),
    };
    written.map_err(|error| Failure::of_file(name, &error))
}

/// Writes to a stream. A reader that has closed its end of it is no failure.
fn write(
    stream: &mut (dyn Write + Send),
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

/// An output that can be written.
pub(crate) struct Destination {
    /// The name in messages.
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

    /// The file for a part of what was to be written here, if it is a file.
    pub(crate) fn part(&self) -> Result<Option<Destination>, Failure> {
        let part = self.is_file().then(|| of_part(&self.name));
        part.map(Destination::of_path).transpose()
    }

    pub(crate) fn is_standard(&self) -> bool {
        matches!(self.place, Place::Standard)
    }

    pub(crate) fn is_file(&self) -> bool {
        matches!(self.place, Place::File(_))
    }
}

/// The name of a file that holds a part of what was to be written.
fn of_part(name: &Path) -> PathBuf {
    let mut name = name.to_owned();
    name.as_mut_os_string().push(".incomplete");
    name
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

/// Refuses outputs that were read, whatever they are called.
pub(crate) fn refuse_read<'a>(
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

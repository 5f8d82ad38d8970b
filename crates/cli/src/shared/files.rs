//! Files: as arguments name them, in which format they are (by an option, or else by the extension), which of them a
//! run has read, and which file a path or a standard stream is, whatever it is called.

use std::ffi::OsString;
use std::fs::{self, File, Metadata};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use bytesize::ByteSize;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use sweep_cdt_formats::{Coordinate, Format, GraphFile, ReadError, Remark, Source, reason};

use sweep_cdt_stream::external::Choice;

use super::failure::{Failure, note, printable};
use super::resources::has_room;
use super::unread;

/// A path on the command line: a file, or for `-` standard input or output.
#[derive(Clone)]
pub(crate) enum FileArgument {
    Standard,
    File(PathBuf),
}

impl From<OsString> for FileArgument {
    fn from(text: OsString) -> Self {
        if text == "-" {
            FileArgument::Standard
        } else {
            FileArgument::File(text.into())
        }
    }
}

impl FileArgument {
    /// The name in reports where it is an input.
    pub(crate) fn input_name(&self) -> String {
        printable(&self.raw_name())
    }

    /// The name in reports, with all its characters.
    fn raw_name(&self) -> String {
        match self {
            FileArgument::Standard => "standard input".to_owned(),
            FileArgument::File(path) => path.display().to_string(),
        }
    }

    pub(crate) fn is_standard(&self) -> bool {
        matches!(self, FileArgument::Standard)
    }

    /// The path, if it is a file.
    pub(crate) fn path(&self) -> Option<&Path> {
        match self {
            FileArgument::Standard => None,
            FileArgument::File(path) => Some(path),
        }
    }

    /// Whether it is a file that exists.
    pub(crate) fn exists(&self) -> bool {
        self.path().is_some_and(Path::exists)
    }

    /// The file beside it with another extension; standard input has none.
    pub(crate) fn beside(&self, extension: &str) -> Option<FileArgument> {
        self.path()
            .map(|path| FileArgument::File(path.with_extension(extension)))
    }
}

/// The name of an input in several files.
pub(crate) fn input_names(files: &[FileArgument]) -> String {
    let names: Vec<String> = files.iter().map(FileArgument::input_name).collect();
    match &names[..] {
        [first, _, _, ..] => format!("{first} and {} others", names.len() - 1),
        _ => names.join(" and "),
    }
}

/// The format that is given for one of so many inputs: of several, it is that of those whose extension tells none.
pub(crate) fn given_format(
    file: &FileArgument,
    inputs: usize,
    given: Option<Format>,
    formats: &[Format],
) -> Option<Format> {
    given.filter(|_| inputs == 1 || by_extension(file, formats).is_none())
}

/// Reads the name of one of these formats that is given by an option.
pub(crate) fn format_parser(formats: &'static [Format]) -> impl TypedValueParser<Value = Format> {
    PossibleValuesParser::new(names(formats))
        .map(|name| Format::named(&name, formats).expect("one of the possible values"))
}

/// The format of an input, one of these, which `option` may give.
pub(crate) fn format_of_input(
    file: &FileArgument,
    option: &str,
    given: Option<Format>,
    formats: &[Format],
) -> Result<Format, Failure> {
    given
        .or_else(|| by_extension(file, formats))
        .ok_or_else(|| {
            let name = file.input_name();
            if let Some(command) = file.path().and_then(unread::command) {
                // Where points alone are read, those of clouds are.
                let feature = file.path().filter(|_| formats.contains(&Format::Csv));
                let build = feature.and_then(unread::build).unwrap_or_default();
                return Failure::Error(format!("{name} is not read{build}: convert it, {command}"));
            }
            let other = file.path().and_then(unread::other_name);
            if let Some(format) = other.and_then(|name| Format::named(name, formats)) {
                let format = format.name();
                return Failure::Usage(format!(
                    "the format of {name} is not known by its name: add {option} {format}"
                ));
            }
            let known = names(formats).join(", ");
            let format = by_extension(file, Format::INPUTS).filter(|_| option == "--stream-format");
            if let Some(format) = format {
                let format = format.name();
                return Failure::Usage(format!(
                    "{name}: a stream reads no .{format}, but {known}. In memory `sweep-cdt contours` and `heights` read it"
                ));
            }
            Failure::Usage(format!(
                "the format of {name} is not known: add {option} with one of {known}"
            ))
        })
}

/// The format of an output, one of these; `given` is that of outputs whose extension tells none.
pub(crate) fn format_of_output(
    file: &FileArgument,
    given: Option<Format>,
    formats: &[Format],
) -> Result<Format, Failure> {
    by_extension(file, formats).or(given).ok_or_else(|| {
        let known = names(formats).join(", ");
        let name = match file {
            FileArgument::Standard => "standard output".to_owned(),
            FileArgument::File(path) => path.display().to_string(),
        };
        Failure::Usage(format!(
            "the format of {name} is not known: add --output-format with one of {known}"
        ))
    })
}

/// The format that the extension of a file tells, if it is one of these.
pub(crate) fn by_extension(file: &FileArgument, formats: &[Format]) -> Option<Format> {
    Format::named(file.path()?.extension()?.to_str()?, formats)
}

fn names(formats: &[Format]) -> Vec<&'static str> {
    formats.iter().map(|format| format.name()).collect()
}

/// Arguments that say how files are read.
#[derive(clap::Args)]
pub(crate) struct ReadingArgs {
    /// Take the faces of a mesh for polygons: their sides for edges, and --inside polygons for what they cover
    #[arg(long)]
    faces: bool,

    /// The property of the features of a .geojson that is the height of their positions, or the column of a .csv, .xyz or
    /// .txt [default: the first of z, elevation, elev, height and such names; of a .geojson for points and lines without a
    /// third coordinate]
    #[arg(long, value_name = "NAME")]
    height_property: Option<String>,

    /// The columns of a .csv, .xyz or .txt that are x, y and perhaps z, by their names or their places from 1 on
    #[arg(long, value_name = "X,Y[,Z]", value_delimiter = ',')]
    columns: Vec<String>,

    /// Of a .las or .laz the points of these classes alone: 2 is the ground. Numbers of points count no others
    #[arg(long = "class", value_name = "CLASS", value_delimiter = ',')]
    classes: Vec<u8>,

    /// A number that means that there is none, in heights and other columns of vertices: -9999, for example
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    no_value: Option<f64>,

    /// Refuse files that say more than is read, and outputs that have no room for all that is
    #[arg(long)]
    strict: bool,

    /// Most bytes that what is packed in a .vtu, .vtp, .npz or .laz may unpack to: 500M, 16G or 2GiB, for example [default: 16MiB,
    /// or 32 times the file's size]
    #[arg(long, value_name = "SIZE", value_parser = size)]
    unpacked_limit: Option<ByteSize>,
}

/// A number of bytes.
pub(crate) fn size(text: &str) -> Result<ByteSize, String> {
    let size = text.parse();
    size.map_err(|_| "it is no number of bytes, as 500M, 16G, 2GiB or 4096 are".to_owned())
}

impl ReadingArgs {
    /// The columns and classes that are taken of a file that is read in pieces.
    pub(crate) fn choice(&self) -> Choice {
        Choice {
            columns: self.columns.clone(),
            classes: self.classes.clone(),
            ..Choice::default()
        }
    }

    /// No files; those that will be read are read so.
    pub(crate) fn files(&self) -> FilesRead {
        FilesRead {
            identities: Vec::new(),
            unpacked_limit: self.unpacked_limit,
            height_property: self.height_property.clone(),
            columns: self.columns.clone(),
            classes: self.classes.clone(),
            no_value: self.no_value,
            has_faces: self.faces,
            takes_areas: false,
            takes_properties: false,
            keeps_text: false,
            has_settings: true,
            is_strict: self.strict,
        }
    }
}

/// The regular files that a run has read, named or by implication: none of them may be overwritten.
#[derive(Default)]
pub(crate) struct FilesRead {
    identities: Vec<Identity>,
    unpacked_limit: Option<ByteSize>,
    height_property: Option<String>,
    /// The columns of the next file.
    pub(crate) columns: Vec<String>,
    /// The classes of the points of the next file that are read, if they are chosen.
    pub(crate) classes: Vec<u8>,
    no_value: Option<f64>,
    has_faces: bool,
    /// Whether greatest areas of regions count.
    pub(crate) takes_areas: bool,
    /// Whether properties of features count.
    pub(crate) takes_properties: bool,
    /// Whether the next file is written as it was read, but for heights: nothing of it gets lost, and none is read.
    pub(crate) keeps_text: bool,
    /// Whether the settings that remarks name can be given, beside --no-value.
    has_settings: bool,
    is_strict: bool,
}

impl FilesRead {
    /// No files; those that will be read are read in pieces, and nothing can be chosen of them.
    pub(crate) fn in_pieces(is_strict: bool) -> FilesRead {
        FilesRead {
            is_strict,
            ..FilesRead::default()
        }
    }

    /// Reads all of a file to memory, and notes which one it is.
    pub(crate) fn load(&mut self, file: &FileArgument) -> Result<Source, ReadError> {
        let name = file.raw_name();
        let read = match file {
            FileArgument::File(path) => read(&name, path),
            FileArgument::Standard => read_standard_input(&name),
        };
        match read {
            // What is read from text takes about as much memory as the text, and while it grows twice as much more.
            Ok((source, _)) if !has_room(source.bytes.len() as u64 / 2 * 5) => {
                Err(ReadError::of_file(name, "out of memory"))
            }
            Ok((source, identity)) => {
                self.identities.extend(identity);
                let source = match self.unpacked_limit {
                    Some(ByteSize(bytes)) => source.unpacked_limit(bytes),
                    None => source,
                };
                // The chosen columns and classes are those of the input, which is read first.
                let source = source.columns(std::mem::take(&mut self.columns));
                let source = source.classes(std::mem::take(&mut self.classes));
                Ok(match &self.height_property {
                    Some(name) => source.height_property(name),
                    None => source,
                })
            }
            Err(error) => Err(ReadError::of_file(name, reason(&error))),
        }
    }

    /// An input called `name` as it was asked for: with its faces or without them. What its reader has to say is said.
    pub(crate) fn complete<S: Coordinate>(
        &self,
        name: &str,
        mut file: GraphFile<S>,
    ) -> Result<GraphFile<S>, Failure> {
        if self.has_faces {
            file = file.with_faces().map_err(|corner| {
                Failure::Error(format!(
                    "{name}: a face has a corner that is no vertex, number {corner} from 0"
                ))
            })?;
        }
        file = file.without_faces();
        if !self.takes_properties && !self.keeps_text {
            file = file.without_properties();
        }
        if !self.takes_areas {
            file = file.without_areas();
        }
        if let Some(value) = self.no_value.filter(|_| !self.keeps_text) {
            file = file.without_value(value);
        }
        if !self.keeps_text {
            file = file.with_voids_said();
        }
        let is_of_text = |remark: &Remark| {
            use Remark::{Conflict, HeightProperty, Ignored};
            matches!(
                remark,
                Ignored { .. } | Conflict { .. } | HeightProperty { .. }
            )
        };
        file.remarks
            .retain(|remark| !(self.keeps_text && is_of_text(remark)));
        self.say_of(name, &file)?;
        file.remarks.clear();
        Ok(file)
    }

    /// Says the remarks on a file; a strict run refuses one that something gets lost of.
    pub(crate) fn say_of<S: Coordinate>(
        &self,
        name: &str,
        file: &GraphFile<S>,
    ) -> Result<(), Failure> {
        self.say_in_words(name, &file.remarks, |remark| file.in_words(remark))
    }

    /// Says remarks that need no file.
    pub(crate) fn say(&self, name: &str, remarks: &[Remark]) -> Result<(), Failure> {
        self.say_in_words(name, remarks, Remark::to_string)
    }

    fn say_in_words(
        &self,
        name: &str,
        remarks: &[Remark],
        words: impl Fn(&Remark) -> String,
    ) -> Result<(), Failure> {
        let mut said: Vec<(&Remark, String)> = Vec::new();
        for remark in remarks {
            let setting = remark.setting();
            let setting = setting.filter(|(option, _)| self.has_settings || *option == "no-value");
            let way_out = setting.map(|(option, does)| format!(" (--{option} {does})"));
            let way_out = way_out.unwrap_or_default();
            let mut others = said.iter_mut();
            let is_ignored = |other: &Remark| matches!(other, Remark::Ignored { .. });
            // All that is ignored is one line.
            match (remark, others.find(|(other, _)| is_ignored(other))) {
                (Remark::Ignored { count, what }, Some((_, line))) => {
                    line.push_str(&format!(", {count} {what}"));
                }
                _ => said.push((remark, words(remark) + &way_out)),
            }
        }
        for (remark, line) in said {
            if self.is_strict && remark.is_loss() {
                return Err(Failure::Error(format!(
                    "{name}: {line}; --strict refuses that"
                )));
            }
            note(format_args!("{name}: {line}"));
        }
        Ok(())
    }

    /// Notes a file that is read in pieces, if it is there.
    pub(crate) fn add(&mut self, path: &Path) {
        let metadata = fs::metadata(path).ok().filter(Metadata::is_file);
        let identity = metadata.and_then(|metadata| Identity::there(path, &metadata).ok());
        self.identities.extend(identity);
    }

    /// Notes the file that standard input is, if it is one.
    pub(crate) fn add_standard(&mut self) {
        let which = standard_input().filter(|(kind, _)| kind.is_file());
        self.identities.extend(which.map(|(_, identity)| identity));
    }

    /// Whether this file was read.
    pub(crate) fn has(&self, identity: &Identity) -> bool {
        self.identities.contains(identity)
    }
}

fn read(name: &str, path: &Path) -> io::Result<(Source, Option<Identity>)> {
    let mut file = File::open(path)?;
    let metadata = file.metadata()?;
    let source = Source::of_file(name, &mut file)?;
    let identity = metadata
        .is_file()
        .then(|| Identity::there(path, &metadata))
        .transpose()?;
    Ok((source, identity))
}

fn read_standard_input(name: &str) -> io::Result<(Source, Option<Identity>)> {
    let mut bytes = Vec::new();
    io::stdin().lock().read_to_end(&mut bytes)?;
    let which = standard_input().filter(|(kind, _)| kind.is_file());
    let name = name.to_owned();
    Ok((
        Source::new(name, bytes),
        which.map(|(_, identity)| identity),
    ))
}

#[cfg(unix)]
type Key = (u64, u64);
#[cfg(not(unix))]
type Key = std::path::PathBuf;

/// A file, there or still to be made.
///
/// On Unix a file is its device and inode, so symbolic and hard links lead to the same one. Elsewhere it is
/// its canonical path. A file that is still to be made is its folder and its name.
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

/// The kind of file that standard input is, and which; only Unix tells.
fn standard_input() -> Option<(Metadata, Identity)> {
    #[cfg(unix)]
    return open(io::stdin());
    #[cfg(not(unix))]
    None
}

/// The kind of file that standard output is, and which; only Unix tells.
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

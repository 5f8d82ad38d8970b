//! The outputs of a run: all of them are written, or none.
//!
//! Each goes to a temporary file in its folder; only when all are complete are they renamed. Should a
//! rename fail, the files renamed before it are removed again.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use sweep_cdt::Triangulation;
use sweep_cdt::formats::{
    Coordinate, Graph, Input, InputFormat, OutputFormat, read, write, write_node,
};
use tempfile::NamedTempFile;

use super::failure::Failure;
use super::input::{InputArgs, load};

/// What names standard output among the outputs.
const STDOUT: &str = "-";

/// Arguments that name outputs.
#[derive(clap::Args)]
pub(crate) struct OutputArgs {
    /// File to write: .ele, .json, .obj or .svg; may be given several times; `-` for standard output
    #[arg(short, long = "output", value_name = "OUTPUT")]
    output: Vec<PathBuf>,

    /// Format of standard output
    #[arg(long, value_name = "FORMAT", value_parser = super::names(OutputFormat::ALL, OutputFormat::name))]
    to: Option<OutputFormat>,
}

/// A place to write to, and what.
pub(crate) struct Target {
    path: PathBuf,
    format: OutputFormat,
}

impl OutputArgs {
    /// The outputs, each with its format. None of them may be the input.
    pub(crate) fn targets(&self, input: &InputArgs) -> Result<Vec<Target>, Failure> {
        if let Some(path) = self.output.iter().find(|path| input.is_file(path)) {
            let message = format!("{} is the input and would be overwritten", path.display());
            return Err(Failure::Usage(message));
        }
        self.output.iter().map(|path| self.target(path)).collect()
    }

    /// Whether one of the outputs is standard output.
    pub(crate) fn has_stdout(&self) -> bool {
        self.output.iter().any(|path| path == Path::new(STDOUT))
    }

    fn target(&self, path: &Path) -> Result<Target, Failure> {
        let extension = path.extension().unwrap_or_default();
        let named = |format: &OutputFormat| extension.eq_ignore_ascii_case(format.name());
        let format = if path == Path::new(STDOUT) {
            self.to
                .ok_or_else(|| "standard output needs a format: add --to".to_owned())
        } else {
            OutputFormat::ALL.into_iter().find(named).ok_or_else(|| {
                format!(
                    "{}: only .ele, .json, .obj and .svg can be written",
                    path.display()
                )
            })
        };
        Ok(Target {
            path: path.to_owned(),
            format: format.map_err(Failure::Usage)?,
        })
    }
}

/// Writes all targets, or none.
pub(crate) fn save<S: Coordinate>(
    targets: &[Target],
    graph: &Graph<S>,
    result: &Triangulation,
) -> Result<(), Failure> {
    let mut drafts = Vec::new();
    for Target { path, format } in targets {
        if path == Path::new(STDOUT) {
            print(|out| write(*format, graph, result, out))?;
            continue;
        }
        drafts.push(Draft::new(path, |out| write(*format, graph, result, out))?);
        let node = path.with_extension("node");
        if *format == OutputFormat::Ele && !is_node_of(&node, graph) {
            drafts.push(Draft::new(&node, |out| write_node(graph, out))?);
        }
    }
    let mut done = Vec::new();
    for Draft { file, path } in drafts {
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

/// Writes to standard output. That nobody reads it any more is no failure.
pub(crate) fn print(
    write: impl FnOnce(&mut BufWriter<io::StdoutLock<'_>>) -> io::Result<()>,
) -> Result<(), Failure> {
    let mut out = BufWriter::new(io::stdout().lock());
    match write(&mut out).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::of_file(Path::new("standard output"), &error))
        }
        _ => Ok(()),
    }
}

/// Whether a `.node` is there already and holds the vertices of `graph`.
fn is_node_of<S: Coordinate>(path: &Path, graph: &Graph<S>) -> bool {
    let no_other = || unreachable!("a .node refers to no other file");
    let Ok(source) = load(path) else { return false };
    let Ok(there) = read(InputFormat::Node, &source, no_other) else {
        return false;
    };
    let there = match there {
        Input::Doubles(there) => node_text(&there),
        Input::Rationals(there) => node_text(&there),
    };
    there == node_text(graph)
}

fn node_text<S: Coordinate>(graph: &Graph<S>) -> Vec<u8> {
    let mut text = Vec::new();
    write_node(graph, &mut text).expect("memory takes all that is written");
    text
}

/// A complete file under a temporary name, which goes when the draft does.
struct Draft {
    file: NamedTempFile,
    path: PathBuf,
}

impl Draft {
    fn new(
        path: &Path,
        write: impl FnOnce(&mut BufWriter<&mut NamedTempFile>) -> io::Result<()>,
    ) -> Result<Draft, Failure> {
        let complete = || {
            let mut file = temporary_beside(path)?;
            let mut out = BufWriter::new(&mut file);
            write(&mut out)?;
            out.flush()?;
            drop(out);
            Ok(file)
        };
        let file = complete().map_err(|error| Failure::of_file(path, &error))?;
        Ok(Draft {
            file,
            path: path.to_owned(),
        })
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

//! The outputs of a run: all of them are written, or none.

use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use sweep_cdt::Triangulation;
use sweep_cdt::formats::{
    Coordinate, Graph, Input, InputFormat, OutputFormat, read, write, write_node,
};

use super::atomic_files::Drafts;
use super::failure::Failure;
use super::file_argument::{FileArg, load};

/// What names standard output among the outputs.
const STDOUT: &str = "-";

/// Arguments that name outputs.
#[derive(clap::Args)]
pub(crate) struct OutputArgs {
    /// File to write: .ele, .json, .obj or .svg; may be given several times; `-` for standard output
    #[arg(short, long = "output", value_name = "OUTPUT")]
    output: Vec<PathBuf>,

    /// Format of standard output
    #[arg(long, value_name = "FORMAT", value_parser = super::format::names(OutputFormat::ALL, OutputFormat::name))]
    output_format: Option<OutputFormat>,
}

/// A place to write to, and what.
pub(crate) struct Target {
    path: PathBuf,
    format: OutputFormat,
}

impl OutputArgs {
    /// The outputs, each with its format. None of them may be the input.
    pub(crate) fn targets(&self, input: &FileArg) -> Result<Vec<Target>, Failure> {
        refuse_overwriting(&[input], &self.output)?;
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
            self.output_format
                .ok_or_else(|| "standard output needs a format: add --output-format".to_owned())
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

/// Refuses outputs that are one of the inputs.
pub(crate) fn refuse_overwriting<'a>(
    inputs: &[&FileArg],
    outputs: impl IntoIterator<Item = &'a PathBuf>,
) -> Result<(), Failure> {
    let is_input = |path: &&PathBuf| inputs.iter().any(|input| input.is_file(path));
    match outputs.into_iter().find(is_input) {
        None => Ok(()),
        Some(path) => Err(Failure::Usage(format!(
            "{} is the input and would be overwritten",
            path.display()
        ))),
    }
}

/// Writes all targets, or none.
pub(crate) fn save<S: Coordinate>(
    targets: &[Target],
    graph: &Graph<S>,
    result: &Triangulation,
) -> Result<(), Failure> {
    let mut drafts = Drafts::default();
    for Target { path, format } in targets {
        if path == Path::new(STDOUT) {
            print(|out| write(*format, graph, result, out))?;
            continue;
        }
        drafts.add(path, |out| write(*format, graph, result, out))?;
        let node = path.with_extension("node");
        if *format == OutputFormat::Ele && !is_node_of(&node, graph) {
            drafts.add(&node, |out| write_node(graph, out))?;
        }
    }
    drafts.persist()
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

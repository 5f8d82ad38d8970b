//! The outputs of a run: all of them are written, or none.

use std::io::{self, BufWriter, Write};
use std::path::Path;

use sweep_cdt::Triangulation;
use sweep_cdt::formats::{
    Coordinate, Graph, Input, InputFormat, OutputFormat, read, write, write_node,
};

use super::atomic_files::AtomicFiles;
use super::failure::Failure;
use super::file_argument::{FileArgument, load};
use super::format;

/// Arguments that name outputs.
#[derive(clap::Args)]
pub(crate) struct OutputArgs {
    /// File to write: .ele, .json, .obj or .svg; may be given several times; `-` for standard output
    #[arg(short, long = "output", value_name = "OUTPUT")]
    output: Vec<FileArgument>,

    /// Format of standard output
    #[arg(long, value_name = "FORMAT", value_parser = format::parser::<OutputFormat>())]
    output_format: Option<OutputFormat>,
}

/// A place to write to, and what.
pub(crate) struct Target {
    file: FileArgument,
    format: OutputFormat,
}

impl OutputArgs {
    /// The outputs, each with its format. None of them may be the input.
    pub(crate) fn targets(&self, input: &FileArgument) -> Result<Vec<Target>, Failure> {
        refuse_overwriting(&[input], self.output.iter().filter_map(FileArgument::path))?;
        let target = |file: &FileArgument| {
            Ok(Target {
                file: file.clone(),
                format: format::of_output(file, self.output_format)?,
            })
        };
        self.output.iter().map(target).collect()
    }

    /// Whether one of the outputs is standard output.
    pub(crate) fn has_stdout(&self) -> bool {
        self.output.iter().any(FileArgument::is_standard)
    }
}

/// Refuses outputs that are one of the inputs.
pub(crate) fn refuse_overwriting<'a>(
    inputs: &[&FileArgument],
    outputs: impl IntoIterator<Item = &'a Path>,
) -> Result<(), Failure> {
    let is_input = |path: &&Path| inputs.iter().any(|input| input.is_file(path));
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
    let mut files = AtomicFiles::default();
    for Target { file, format } in targets {
        let Some(path) = file.path() else {
            print(|out| write(*format, graph, result, out))?;
            continue;
        };
        files.add(path, |out| write(*format, graph, result, out))?;
        let node = path.with_extension("node");
        if *format == OutputFormat::Ele && !holds_vertices(&node, graph) {
            files.add(&node, |out| write_node(graph, out))?;
        }
    }
    files.persist()
}

/// Writes to standard output. A reader that has closed its end of the pipe is no failure.
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

/// Whether there is a `.node` of this path already that holds the vertices of `graph`.
fn holds_vertices<S: Coordinate>(path: &Path, graph: &Graph<S>) -> bool {
    let Ok(source) = load(path) else { return false };
    let there = match read(InputFormat::Node, &source, None) {
        Ok(Input::Doubles(there)) => node_text(&there),
        Ok(Input::Rationals(there)) => node_text(&there),
        Err(_) => return false,
    };
    there == node_text(graph)
}

fn node_text<S: Coordinate>(graph: &Graph<S>) -> Vec<u8> {
    let mut text = Vec::new();
    write_node(graph, &mut text).expect("memory takes all that is written");
    text
}

//! Arguments that name what a subcommand reads, a graph and a result to verify, and what `triangulate` writes and where
//! to.

use std::fs;
use std::path::Path;

use sweep_cdt::Triangulation;
use sweep_cdt::interior::Interior;
use sweep_cdt_draw::{write, write_interior};
use sweep_cdt_formats::{
    Coordinate, Format, GraphFile, Input, ReadErrorKind, Remark, Source, not_written, read,
    write_node,
};

use super::failure::{Failure, way_out};
use super::files::{
    FileArgument, FilesRead, Identity, format_of_input, format_of_output, format_parser,
};
use super::outputs::{Destination, Outputs, refuse_read, refuse_twice};

/// Arguments that name an input.
#[derive(clap::Args)]
pub(crate) struct InputArgs {
    /// File to read: .node, .poly, .json, .obj, .off, .csv, .xyz, .txt, .ply, .vtk, .vtu, .vtp, .msh, .geojson, .wkt, .npy,
    /// .npz, or .las and .laz in a build with the feature `las`; `-` for standard input
    #[arg(value_name = "INPUT")]
    pub(crate) input: FileArgument,

    /// Format of the input [default: by its extension]
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(Format::INPUTS))]
    input_format: Option<Format>,

    /// The beginning of options for this input alone, in messages: of the one for the format, and of that for columns.
    #[arg(skip = ["--input-", "--"])]
    options: [&'static str; 2],
}

impl InputArgs {
    /// An input that another argument names.
    pub(crate) fn new(input: FileArgument, input_format: Option<Format>) -> InputArgs {
        InputArgs {
            input,
            input_format,
            options: ["--input-", "--"],
        }
    }

    /// The input, where options for it alone begin so.
    pub(crate) fn options(self, begin: &'static str) -> InputArgs {
        InputArgs {
            options: [begin; 2],
            ..self
        }
    }

    /// The name of the input in messages.
    pub(crate) fn name(&self) -> String {
        self.input.input_name()
    }

    /// The format of the input.
    pub(crate) fn format(&self) -> Result<Format, Failure> {
        format_of_input(
            &self.input,
            &format!("{}format", self.options[0]),
            self.input_format,
            Format::INPUTS,
        )
    }

    /// Whether it is a cloud of points, which have classes.
    pub(crate) fn is_cloud(&self) -> bool {
        matches!(self.format(), Ok(Format::Las | Format::Laz))
    }

    /// Reads the input; `show` is called with each file that is read.
    pub(crate) fn read(
        &self,
        files: &mut FilesRead,
        mut show: impl FnMut(&Source),
    ) -> Result<Input, Failure> {
        let format = self.format()?;
        let source = files.load(&self.input)?;
        show(&source);
        // The `.node` beside a `.poly` is loaded only if the `.poly` turns out to need it.
        let input = match (read(format, &source, None), self.input.beside("node")) {
            (Err(error), Some(file)) if error.kind == ReadErrorKind::MissingNode => {
                let node = files.load(&file)?;
                show(&node);
                read(format, &source, Some(&node))?
            }
            (input, _) => input.map_err(|error| {
                let columns = format!("{}columns", self.options[1]);
                let way_out = way_out(&error).replace("--columns", &columns);
                Failure::Error(format!("{error}{way_out}"))
            })?,
        };
        let name = self.name();
        Ok(match input {
            Input::Doubles(file) => Input::Doubles(files.complete(&name, file)?),
            Input::Rationals(file) => Input::Rationals(files.complete(&name, file)?),
        })
    }
}

/// Arguments that say how a result is read.
#[derive(clap::Args)]
pub(crate) struct ResultArgs {
    /// Format of the result [default: by its extension]
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(Format::RESULTS))]
    result_format: Option<Format>,
}

/// A result in memory.
pub(crate) struct ResultFiles {
    pub(crate) format: Format,
    pub(crate) source: Source,
    /// The `.node` beside a `.ele`.
    pub(crate) node: Option<Source>,
}

impl ResultArgs {
    /// Loads a file as the result; `show` is called with each file of it.
    pub(crate) fn load(
        &self,
        file: &FileArgument,
        files: &mut FilesRead,
        mut show: impl FnMut(&Source),
    ) -> Result<ResultFiles, Failure> {
        let format = format_of_input(file, "--result-format", self.result_format, Format::RESULTS)?;
        let source = files.load(file)?;
        show(&source);
        let node = match format {
            Format::Ele => file.beside("node").filter(FileArgument::exists),
            _ => None,
        };
        let node = node
            .map(|file| files.load(&file).inspect(show))
            .transpose()?;
        Ok(ResultFiles {
            format,
            source,
            node,
        })
    }
}

/// Arguments that name outputs.
#[derive(clap::Args)]
pub(crate) struct OutputArgs {
    /// File to write: .ele, .node, .json, .obj, .off, .ply, .vtk, .vtu, .vtp, .msh, .stl, .geojson, .wkt, .npy, .npz,
    /// .svg or .png; may be given several times; `-` for standard output
    #[arg(short, long = "output", value_name = "OUTPUT")]
    output: Vec<FileArgument>,

    /// Format of standard output, and of outputs whose extension tells none
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(Format::OUTPUTS))]
    output_format: Option<Format>,
}

/// A place to write to, and what.
pub(crate) struct Target {
    pub(crate) destination: Destination,
    format: Format,
}

impl Target {
    pub(crate) fn is_certificate(&self) -> bool {
        self.format == Format::Cert
    }

    /// What the format has no room for.
    pub(crate) fn losses<S: Coordinate>(
        &self,
        file: &GraphFile<S>,
        domain: Option<&Interior<'_>>,
    ) -> Option<Remark> {
        match self.format {
            Format::Svg | Format::Png => None,
            format => not_written(format, file, domain),
        }
    }

    /// The name of the output in messages.
    pub(crate) fn name(&self) -> String {
        self.destination.name.display().to_string()
    }

    /// Whether those who read the format may take a missing height for 0.
    pub(crate) fn asks_heights(&self) -> bool {
        use Format::{Geojson, Msh, Obj, Off, Ply, Stl, Vtk, Vtp, Vtu, Wkt};
        matches!(
            self.format,
            Obj | Off | Ply | Vtk | Vtu | Vtp | Msh | Stl | Geojson | Wkt
        )
    }
}

impl OutputArgs {
    /// The outputs, each with its format. No two may be one file.
    pub(crate) fn targets(&self) -> Result<Vec<Target>, Failure> {
        let target = |file| {
            Ok(Target {
                format: format_of_output(file, self.output_format, Format::OUTPUTS)?,
                destination: Destination::of(file)?,
            })
        };
        let targets: Result<Vec<Target>, Failure> = self.output.iter().map(target).collect();
        let targets = targets?;
        refuse_twice(targets.iter().map(|target| &target.destination))?;
        Ok(targets)
    }
}

/// Whether one of the outputs is standard output.
pub(crate) fn has_standard(targets: &[Target]) -> bool {
    targets
        .iter()
        .any(|target| target.destination.is_standard())
}

/// Refuses targets that were read, and adds the `.node` that a `.ele` needs beside it. One that is there
/// already is overwritten only if it is a target itself.
pub(crate) fn completed<S: Coordinate>(
    mut targets: Vec<Target>,
    read: &FilesRead,
    file: &GraphFile<S>,
) -> Result<Vec<Target>, Failure> {
    let paths = targets
        .iter()
        .filter(|target| target.format == Format::Ele && target.destination.is_file())
        .map(|target| target.destination.name.with_extension("node"));
    for path in paths.collect::<Vec<_>>() {
        let is_target = |identity: &Identity| {
            let mut identities = targets.iter().map(|target| &target.destination.identity);
            identities.any(|target| target.as_ref() == Some(identity))
        };
        if let Ok(metadata) = fs::metadata(&path) {
            let identity = Identity::there(&path, &metadata).ok();
            let is_there = metadata.is_file() && holds_vertices(&path, file);
            if !is_there && !identity.as_ref().is_some_and(is_target) {
                let path = path.display();
                let message = format!(
                    "{path} would be overwritten, since the .ele needs its vertices beside it: \
                     give the .ele another name, or allow it by `-o {path}`"
                );
                return Err(Failure::Usage(message));
            }
            continue;
        }
        let destination = Destination::of_path(path)?;
        if !destination.identity.as_ref().is_some_and(is_target) {
            targets.push(Target {
                destination,
                format: Format::Node,
            });
        }
    }
    refuse_read(read, targets.iter().map(|target| &target.destination))?;
    Ok(targets)
}

/// Says what targets have no room for, of the whole result or of what is inside a domain.
pub(crate) fn say_losses<S: Coordinate>(
    read: &FilesRead,
    targets: &[Target],
    file: &GraphFile<S>,
    domain: Option<&Interior<'_>>,
) -> Result<(), Failure> {
    let mut losses: Vec<(String, Remark)> = Vec::new();
    for target in targets {
        let (name, lost) = (target.name(), target.losses(file, domain));
        match (losses.last_mut(), lost) {
            (_, None) => {}
            // A `.ele` and its `.node` lose one and the same.
            (Some((names, last)), Some(lost)) if *last == lost => {
                names.push_str(&format!(", {name}"));
            }
            (_, Some(lost)) => losses.push((name, lost)),
        }
    }
    for (names, lost) in losses {
        read.say(&names, &[lost])?;
    }
    Ok(())
}

/// Adds all targets to the outputs: the whole result, or what is inside a domain of it.
pub(crate) fn add<'a, S: Coordinate>(
    outputs: &mut Outputs<'a>,
    targets: Vec<Target>,
    file: &'a GraphFile<S>,
    result: &'a Triangulation,
    domain: Option<&'a Interior<'a>>,
) -> Result<(), Failure> {
    targets.into_iter().try_for_each(|target| {
        let Target {
            destination,
            format,
        } = target;
        outputs.add(destination, move |out| match domain {
            Some(domain) => write_interior(format, file, domain, out),
            None => write(format, file, result, out),
        })
    })
}

/// Whether the `.node` of this path holds the vertices of `file`.
fn holds_vertices<S: Coordinate>(path: &Path, file: &GraphFile<S>) -> bool {
    let there = FileArgument::File(path.to_owned());
    let Ok(source) = FilesRead::default().load(&there) else {
        return false;
    };
    let text = node_text(file);
    // It has the same bytes if it was written with a result of the same vertices.
    if source.bytes == text {
        return true;
    }
    match read(Format::Node, &source, None) {
        Ok(Input::Doubles(there)) => is_written(there, &text),
        Ok(Input::Rationals(there)) => is_written(there, &text),
        Err(_) => false,
    }
}

/// Whether the vertices of a file are written so, with its columns or without them.
fn is_written<S: Coordinate>(file: GraphFile<S>, text: &[u8]) -> bool {
    let with_columns = node_text(&file) == text;
    let columns = Vec::new();
    with_columns || node_text(&GraphFile { columns, ..file }) == text
}

fn node_text<S: Coordinate>(file: &GraphFile<S>) -> Vec<u8> {
    let mut text = Vec::new();
    write_node(file, &mut text).expect("memory takes all that is written");
    text
}

/// Parses a distance.
pub(crate) fn distance(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() && value >= 0.0 => Ok(value),
        Ok(_) => Err("not a finite number from 0 on".to_owned()),
        Err(_) => Err("not a number".to_owned()),
    }
}

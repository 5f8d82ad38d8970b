//! Input of a stream: which files are read, with which memory it is sorted, and where its temporary files go.

use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

use bytesize::ByteSize;
use sweep_cdt_engine::Remark;
use sweep_cdt_formats::{CoordinateSystem, ReadError};
use sweep_cdt_stream::external::{
    Choice, Error, FORMATS, Format, Input, Sorting, SweepOrder, chained, open_chosen, read_chosen,
};

use crate::shared::failure::Failure;
use crate::shared::files::{
    FileArgument, FilesRead, format_of_input, format_parser, given_format, size,
};
use crate::shared::resources::Progress;

/// The memory, if it is not given.
const MEMORY: ByteSize = ByteSize::mib(512);

/// Options of what is sorted outside memory.
#[derive(clap::Args)]
pub(crate) struct SortArgs {
    /// Edges of points that come without: pairs of whole numbers of 64 bits, little-endian, the positions of both ends
    /// among the points of all inputs
    #[arg(long, value_name = "FILE")]
    pub(crate) edges: Option<PathBuf>,

    /// Memory for sorting, and then a half of it for vertices of a stream that are alive: 200M or 2GiB, for example
    /// [default: 512MiB]
    #[arg(long, value_name = "SIZE", value_parser = size)]
    pub(crate) memory: Option<ByteSize>,

    /// Folder for temporary files, of which nothing is left in the end [default: that of the system]
    #[arg(long, value_name = "FOLDER")]
    pub(crate) temporary: Option<PathBuf>,

    /// Format of the input; of several inputs, of those whose extension tells none [default: by its extension]
    #[arg(long, value_name = "FORMAT", value_parser = format_parser(FORMATS))]
    pub(crate) stream_format: Option<Format>,
}

/// An input that is sorted.
pub(super) struct Sorted {
    pub(super) order: SweepOrder,
    /// The number of the first point in the first file.
    pub(super) first_point: u64,
    /// What was read.
    pub(super) input: Box<dyn Input>,
    /// Whether the vertices come with heights.
    pub(super) has_heights: bool,
    /// The names of the other columns.
    pub(super) columns: Vec<String>,
    pub(super) system: Option<CoordinateSystem>,
    files: Vec<(From, Format)>,
    choice: Choice,
}

/// Where an input is.
enum From {
    Path(PathBuf),
    /// In a temporary file, to which standard input was copied.
    Spooled(File),
}

impl From {
    fn open(&self, format: Format, choice: &Choice) -> Result<Box<dyn Input>, ReadError> {
        match self {
            From::Path(path) => open_chosen(path, format, None, choice),
            From::Spooled(file) => {
                let name = FileArgument::Standard.input_name();
                read_chosen(&name, file, format, None, choice)
            }
        }
    }
}

/// Opens files as one input. Classes are those of clouds; where there is none, they are refused.
fn open(
    files: &[(From, Format)],
    edges: Option<&Path>,
    choice: &Choice,
) -> Result<Box<dyn Input>, ReadError> {
    let is_cloud = |format: Format| matches!(format, Format::Las | Format::Laz);
    let has_clouds = files.iter().any(|&(_, format)| is_cloud(format));
    let choice = &Choice {
        may_lack_classes: files.len() > 1,
        ..choice.clone()
    };
    let without_classes = Choice {
        classes: Vec::new(),
        ..choice.clone()
    };
    let inputs = files.iter().map(|(from, format)| {
        let choice = match is_cloud(*format) || !has_clouds {
            true => choice,
            false => &without_classes,
        };
        from.open(*format, choice)
    });
    chained(inputs.collect::<Result<_, _>>()?, edges)
}

/// The inputs of which one is made, or itself.
fn inputs(input: &dyn Input) -> Vec<&dyn Input> {
    match input.inputs() {
        [] => vec![input],
        inputs => inputs.iter().map(|input| &**input).collect(),
    }
}

impl Sorted {
    /// Whether a column of markers is one by its format, so that its numbers are whole.
    pub(super) fn has_markers(&self) -> bool {
        let mut formats = self.files.iter().map(|&(_, format)| format);
        formats.all(|format| matches!(format, Format::Node | Format::Poly))
    }

    /// The points once more, as the input has them.
    pub(super) fn points(&self) -> Result<Box<dyn Input>, Error> {
        Ok(open(&self.files, None, &self.choice)?)
    }
}

impl SortArgs {
    pub(crate) fn memory(&self) -> u64 {
        self.memory.unwrap_or(MEMORY).as_u64()
    }

    /// The folder for temporary files.
    pub(super) fn folder(&self) -> PathBuf {
        let folder = self.temporary.clone();
        folder.unwrap_or_else(std::env::temp_dir)
    }

    /// Refuses these options where the run is none that `option` asks for.
    pub(crate) fn refuse_without(&self, option: &str) -> Result<(), Failure> {
        let given = [
            ("--edges", self.edges.is_some()),
            ("--memory", self.memory.is_some()),
            ("--temporary", self.temporary.is_some()),
            ("--stream-format", self.stream_format.is_some()),
        ];
        match given.iter().find(|(_, is_given)| *is_given) {
            Some((name, _)) => Err(Failure::Usage(format!("{name} is for {option}"))),
            None => Ok(()),
        }
    }

    /// The files that are read, none of which may be overwritten.
    pub(super) fn files(&self, inputs: &[FileArgument], is_strict: bool) -> FilesRead {
        let mut files = FilesRead::in_pieces(is_strict);
        for input in inputs {
            // The vertices of a `.poly` may be beside it.
            let node = input.beside("node");
            let paths = [input.path(), node.as_ref().and_then(FileArgument::path)];
            if input.is_standard() {
                files.add_standard();
            }
            for path in paths.into_iter().flatten() {
                files.add(path);
            }
        }
        if let Some(path) = &self.edges {
            files.add(path);
        }
        files
    }

    /// The input in these files, of which this was chosen, sorted. `say` gets the name of each file with what is left out of it
    /// before, and with what is known after that.
    pub(super) fn sorted(
        &self,
        arguments: &[FileArgument],
        choice: Choice,
        say: impl Fn(&str, &[Remark]) -> Result<(), Failure>,
    ) -> Result<Sorted, Failure> {
        if arguments.iter().filter(|file| file.is_standard()).count() > 1 {
            let message = "standard input is read once: let one INPUT be `-`";
            return Err(Failure::Usage(message.to_owned()));
        }
        let format = |file| {
            let given = given_format(file, arguments.len(), self.stream_format, FORMATS);
            format_of_input(file, "--stream-format", given, FORMATS)
        };
        let formats: Vec<Format> = arguments.iter().map(format).collect::<Result<_, _>>()?;
        let mut files = Vec::with_capacity(arguments.len());
        for (file, format) in arguments.iter().zip(formats) {
            let from = match file.path() {
                Some(path) => From::Path(path.to_owned()),
                None => From::Spooled(self.spooled()?),
            };
            files.push((from, format));
        }
        let mut input = open(&files, self.edges.as_deref(), &choice)?;
        let said: Vec<Vec<Remark>> = inputs(&*input)
            .iter()
            .map(|input| input.remarks())
            .collect();
        for (file, remarks) in arguments.iter().zip(&said) {
            say(&file.input_name(), remarks)?;
        }
        let order = self.order(&mut *input, &self.folder());
        let order = order.map_err(|error| self.failure(&error))?;
        for ((file, input), said) in arguments.iter().zip(inputs(&*input)).zip(said) {
            let mut remarks = input.remarks();
            remarks.retain(|remark| !said.contains(remark));
            say(&file.input_name(), &remarks)?;
        }
        Ok(Sorted {
            order,
            first_point: inputs(&*input)[0].part().first[0],
            has_heights: input.heights().is_some(),
            columns: input
                .columns()
                .iter()
                .map(|column| column.name.clone())
                .collect(),
            system: input.system(),
            input,
            files,
            choice,
        })
    }

    /// Standard input until it ends, in a temporary file without a name.
    fn spooled(&self) -> Result<File, Failure> {
        let folder = self.folder();
        let spooled = || {
            let mut file = tempfile::tempfile_in(&folder)?;
            io::copy(&mut io::stdin().lock(), &mut file)?;
            Ok(file)
        };
        spooled().map_err(|error| Failure::of_file(&folder, &error))
    }

    /// What ends a run that cannot sort, with the option that helps.
    pub(super) fn failure(&self, error: &Error) -> Failure {
        Failure::Error(match error {
            Error::TooLittleMemory { memory, needed } => {
                let (memory, enough) = (ByteSize(*memory), needed.div_ceil(1 << 10));
                format!(
                    "{memory} of memory do not suffice to sort so much: --memory {enough}KiB does"
                )
            }
            Error::OutOfMemory { .. } => format!("{error} (--memory)"),
            Error::Temporary { .. } => format!("{error} (--temporary names one)"),
            _ => error.to_string(),
        })
    }

    fn order(&self, input: &mut dyn Input, folder: &Path) -> Result<SweepOrder, Error> {
        let mut progress = Progress::new("sorting");
        let share = |bytes| usize::try_from(bytes).unwrap_or(usize::MAX);
        Sorting::new(self.memory(), folder).sort_with(input, &mut |done, all| {
            progress.show(share(done), share(all));
        })
    }
}

/// Whether two points of an order are equal: their bits are, since there is but one zero.
pub(super) fn is_one_place(a: [f64; 2], b: [f64; 2]) -> bool {
    a.map(f64::to_bits) == b.map(f64::to_bits)
}

//! Input of a stream: what is read, with which memory it is sorted, and where its temporary files go.

use std::path::{Path, PathBuf};

use sweep_cdt_stream::external::{Error, Input, InputFormat, Sorting, SweepOrder, open};

use crate::shared::failure::Failure;
use crate::shared::files::{FileArgument, FilesRead, format_of_input, format_parser, size};
use crate::shared::resources::Progress;

/// The memory, if it is not given.
const MEMORY: u64 = 512 << 20;

/// Options of what is sorted outside memory.
#[derive(clap::Args)]
pub(crate) struct SortArgs {
    /// Edges of points that come without: pairs of whole numbers of 64 bits, little-endian, the positions of both ends
    #[arg(long, value_name = "FILE")]
    pub(crate) edges: Option<PathBuf>,

    /// Memory for sorting, and then a half of it for vertices of a stream that are alive: 200M or 2GiB, for example
    /// [default: 512MiB]
    #[arg(long, value_name = "SIZE", value_parser = size)]
    pub(crate) memory: Option<u64>,

    /// Folder for temporary files, of which nothing is left in the end [default: that of the system]
    #[arg(long, value_name = "FOLDER")]
    pub(crate) temporary: Option<PathBuf>,

    /// Format of the input, where its extension tells none
    #[arg(long, value_name = "FORMAT", value_parser = format_parser::<InputFormat>())]
    pub(crate) stream_format: Option<InputFormat>,
}

/// An input that is sorted.
pub(super) struct Sorted {
    pub(super) order: SweepOrder,
    /// The number of the first point in the file, and of the first edge.
    pub(super) first_point: u64,
    pub(super) first_edge: u64,
    path: PathBuf,
    format: InputFormat,
}

impl Sorted {
    /// The points once more, as the input has them.
    pub(super) fn points(&self) -> Result<Box<dyn Input>, Error> {
        Ok(open(&self.path, self.format, None)?)
    }
}

impl SortArgs {
    pub(crate) fn memory(&self) -> u64 {
        self.memory.unwrap_or(MEMORY)
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
    pub(super) fn files(&self, input: &FileArgument) -> FilesRead {
        let mut files = FilesRead::default();
        // The vertices of a `.poly` may be beside it.
        let node = input.beside("node");
        let paths = [input.path(), node.as_ref().and_then(FileArgument::path)];
        for path in paths.into_iter().flatten().chain(self.edges.as_deref()) {
            files.add(path);
        }
        files
    }

    /// The input, sorted.
    pub(super) fn sorted(&self, input: &FileArgument) -> Result<Sorted, Failure> {
        let Some(path) = input.path() else {
            let message =
                "a stream is read from a file, since its size must be known: write INPUT to a file";
            return Err(Failure::Usage(message.to_owned()));
        };
        let format = format_of_input(input, "--stream-format", self.stream_format)?;
        let folder = self.temporary.clone().unwrap_or_else(std::env::temp_dir);
        let sorted = self.sort(path, format, &folder);
        sorted.map_err(|error| self.failure(&error))
    }

    /// What ends a run that cannot sort, with the option that helps.
    pub(super) fn failure(&self, error: &Error) -> Failure {
        Failure::Error(match error {
            Error::TooLittleMemory { memory, needed } => {
                let (memory, enough) = (memory >> 10, needed.div_ceil(1 << 10));
                format!(
                    "{memory} KiB of memory do not suffice to sort so much: --memory {enough}KiB does"
                )
            }
            Error::OutOfMemory { .. } => format!("{error} (--memory)"),
            Error::Temporary { .. } => format!("{error} (--temporary names one)"),
            _ => error.to_string(),
        })
    }

    fn sort(&self, path: &Path, format: InputFormat, folder: &Path) -> Result<Sorted, Error> {
        let mut input = open(path, format, self.edges.as_deref())?;
        let mut progress = Progress::new("sorting");
        let share = |bytes| usize::try_from(bytes).unwrap_or(usize::MAX);
        let order =
            Sorting::new(self.memory(), folder).sort_with(&mut *input, &mut |done, all| {
                progress.show(share(done), share(all));
            })?;
        let [first_point, first_edge] = input.first();
        Ok(Sorted {
            order,
            first_point,
            first_edge,
            path: path.to_owned(),
            format,
        })
    }
}

/// Whether two points of an order are equal: their bits are, since there is but one zero.
pub(super) fn is_one_place(a: [f64; 2], b: [f64; 2]) -> bool {
    a.map(f64::to_bits) == b.map(f64::to_bits)
}

//! Why nothing is sorted.

use std::path::PathBuf;
use std::{fmt, io};

use sweep_cdt_formats::{ReadError, reason};

/// Why points and edges do not come in the order of the sweep.
///
/// Points and edges are named by the numbers that they have in their file. Whatever the error, no temporary file is left.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// An input is wrong, or cannot be read.
    Read(ReadError),
    /// A point has a coordinate that is NaN or infinite.
    NonFinite {
        /// The name of the input.
        file: String,
        /// The number of the point in the file.
        point: u64,
    },
    /// An edge has an end that is no point.
    NoPoint {
        /// The name of the input.
        file: String,
        /// The number of the edge in the file.
        edge: u64,
        /// The point that is not there.
        point: u64,
        /// The number of the first point in the file.
        first: u64,
        /// How many points there are.
        points: u64,
    },
    /// A temporary file cannot be made, written or read. The disk may be full.
    Temporary {
        /// The folder.
        folder: PathBuf,
        /// What the system says.
        error: io::Error,
        /// How many bytes were written there.
        written: u64,
    },
    /// The memory is too little to sort so much.
    TooLittleMemory {
        /// The bytes that may be used.
        memory: u64,
        /// The bytes that suffice.
        needed: u64,
    },
    /// The system does not give the memory that may be used.
    OutOfMemory {
        /// The bytes that were asked for.
        bytes: u64,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Read(error) => write!(f, "{error}"),
            Error::NonFinite { file, point } => {
                write!(
                    f,
                    "{file}: point {point} has a coordinate that is not finite"
                )
            }
            Error::NoPoint {
                file,
                edge,
                point,
                first,
                points,
            } => write!(
                f,
                "{file}: edge {edge} ends at point {point}, which does not exist: {}",
                numbers(*first, *points)
            ),
            Error::Temporary {
                folder,
                error,
                written,
            } => write!(
                f,
                "{}: {}, after {written} bytes of temporary files; another folder may have room for them",
                folder.display(),
                reason(error)
            ),
            Error::TooLittleMemory { memory, needed } => write!(
                f,
                "{memory} bytes of memory do not suffice to sort so much: {needed} do"
            ),
            Error::OutOfMemory { bytes } => {
                write!(f, "out of memory: {bytes} bytes were asked for; allow less")
            }
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Error::Read(error) => error.source(),
            Error::Temporary { error, .. } => Some(error),
            _ => None,
        }
    }
}

impl From<ReadError> for Error {
    fn from(error: ReadError) -> Error {
        Error::Read(error)
    }
}

fn numbers(first: u64, points: u64) -> String {
    match points {
        0 => "there are no points".to_owned(),
        _ => format!(
            "the points are numbered from {first} to {}",
            first + (points - 1)
        ),
    }
}

//! Triangles as raw numbers: three for each, little-endian, of 32 or 64 bits.

use std::fs::File;
use std::io::{self, BufReader, Read, Write};
use std::path::Path;

use crate::shared::failure::Failure;

/// How wide a number is.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Width {
    Four,
    Eight,
}

impl Width {
    pub(super) fn of_path(path: &Path) -> Option<Width> {
        match path.extension()?.to_str()? {
            "u32" => Some(Width::Four),
            "u64" => Some(Width::Eight),
            _ => None,
        }
    }

    fn of_file(path: &Path) -> Result<Width, Failure> {
        Width::of_path(path).ok_or_else(|| {
            let name = path.display();
            let message =
                format!("{name} is no name for triangles of a stream: let it end in .u32 or .u64");
            Failure::Usage(message)
        })
    }

    /// Writes a triangle. Numbers that do not fit were refused.
    pub(super) fn write(self, corners: [u64; 3], out: &mut impl Write) -> io::Result<()> {
        let narrow = |number| u32::try_from(number).unwrap_or(u32::MAX);
        match self {
            Width::Four => {
                let bytes = corners.map(|number| narrow(number).to_le_bytes());
                out.write_all(bytes.as_flattened())
            }
            Width::Eight => out.write_all(corners.map(u64::to_le_bytes).as_flattened()),
        }
    }

    /// Whether the numbers of so many points fit.
    pub(super) fn holds(self, points: u64) -> Result<(), Failure> {
        if self == Width::Four && points > 1 << 32 {
            let message =
                format!("{points} points have numbers of more than 32 bits: write a .u64 or .ele");
            return Err(Failure::Usage(message));
        }
        Ok(())
    }
}

/// A file of triangles.
pub(super) struct Triangles {
    file: BufReader<File>,
    width: Width,
    name: String,
    left: u64,
}

impl Triangles {
    pub(super) fn open(path: &Path) -> Result<Triangles, Failure> {
        let width = Width::of_file(path)?;
        let failure = |error| Failure::of_file(path, &error);
        let file = File::open(path).map_err(failure)?;
        let metadata = file.metadata().map_err(failure)?;
        let name = path.display().to_string();
        if !metadata.is_file() {
            let message = format!("{name}: is no file: triangles of a stream are read from one");
            return Err(Failure::Error(message));
        }
        let length = metadata.len();
        let each = if width == Width::Four { 12 } else { 24 };
        if length % each != 0 {
            let message =
                format!("{name}: {length} bytes are no whole number of triangles of {each} bytes");
            return Err(Failure::Error(message));
        }
        Ok(Triangles {
            file: BufReader::with_capacity(1 << 18, file),
            width,
            name,
            left: length / each,
        })
    }

    pub(super) fn left(&self) -> u64 {
        self.left
    }

    pub(super) fn next(&mut self) -> Result<Option<[u64; 3]>, Failure> {
        if self.left == 0 {
            return Ok(None);
        }
        self.left -= 1;
        let read = match self.width {
            Width::Four => self
                .read::<4>()
                .map(|n| n.map(|n| u64::from(u32::from_le_bytes(n)))),
            Width::Eight => self.read::<8>().map(|n| n.map(u64::from_le_bytes)),
        };
        let name = Path::new(&self.name);
        read.map(Some)
            .map_err(|error| Failure::of_file(name, &error))
    }

    fn read<const N: usize>(&mut self) -> io::Result<[[u8; N]; 3]> {
        let mut numbers = [[0; N]; 3];
        self.file.read_exact(numbers.as_flattened_mut())?;
        Ok(numbers)
    }
}

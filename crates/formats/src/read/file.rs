//! Files on disk, all of each in memory: large ones are read on all cores.

use std::fs::File;
use std::io::{self, Read};

use crate::read::source::Source;

impl Source {
    /// All of a file, from where it stands. Of a regular file a large rest is read on all cores, where the system can
    /// do that; what is added to it meanwhile is read, too.
    ///
    /// ```
    /// use std::fs::File;
    /// use sweep_cdt_formats::Source;
    ///
    /// let path = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml");
    /// let source = Source::of_file("README.md", &mut File::open(path)?)?;
    /// assert_eq!(source.bytes, std::fs::read(path)?);
    /// # Ok::<(), std::io::Error>(())
    /// ```
    ///
    /// # Errors
    /// Errors of the system; [`io::ErrorKind::OutOfMemory`] where there is no room for the contents.
    pub fn of_file(name: impl Into<String>, file: &mut File) -> io::Result<Source> {
        let mut bytes = read_in_parts(file)?;
        file.read_to_end(&mut bytes)?;
        Ok(Source::new(name, bytes))
    }
}

/// The rest of a regular file, from where it stands, if that is much; otherwise nothing is read.
#[cfg(unix)]
fn read_in_parts(file: &mut File) -> io::Result<Vec<u8>> {
    use std::io::{Seek, SeekFrom};
    use std::os::unix::fs::FileExt;

    use sweep_cdt::threads::on_all_cores;

    /// Fewer bytes are read by one thread.
    const LARGE: u64 = 1 << 22;
    /// The bytes that each thread reads at a time.
    const PART: usize = 1 << 20;

    let metadata = file.metadata()?;
    if !metadata.is_file() {
        return Ok(Vec::new());
    }
    let start = file.stream_position()?;
    let length = metadata.len().saturating_sub(start);
    if length < LARGE {
        return Ok(Vec::new());
    }
    let length = usize::try_from(length).map_err(|_| io::ErrorKind::OutOfMemory)?;
    // The array of zeros would end the process where there is no memory, so that is asked for first.
    Vec::<u8>::new().try_reserve_exact(length)?;
    let mut bytes = vec![0; length];
    let offsets = (start..).step_by(PART);
    let parts: Vec<(u64, &mut [u8])> = offsets.zip(bytes.chunks_mut(PART)).collect();
    let file_at = &*file;
    let read = on_all_cores(parts, |(offset, part)| file_at.read_exact_at(part, offset));
    match read.into_iter().collect() {
        Ok(()) => {
            file.seek(SeekFrom::Start(start + length as u64))?;
            Ok(bytes)
        }
        // It has become shorter.
        Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => Ok(Vec::new()),
        Err(error) => Err(error),
    }
}

#[cfg(not(unix))]
fn read_in_parts(_file: &mut File) -> io::Result<Vec<u8>> {
    Ok(Vec::new())
}

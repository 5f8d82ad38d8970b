//! The `.node` beside a `.ele`: the points of the input, which the triangles name, with their heights and other columns.
//!
//! The file is written unless the `.ele` stands beside the one that was read. One that is there is left as it is if it is the one
//! that would be written, and no other one is overwritten.

use std::fs::File;
use std::io::{self, BufReader, Read, Write};
use std::path::PathBuf;

use sweep_cdt_formats::{Column, Coordinate};

use super::Trouble;
use super::order::Sorted;
use super::output::each_point;
use crate::shared::failure::Failure;
use crate::shared::files::FilesRead;
use crate::shared::outputs::{Destination, Outputs};

/// A `.node`.
pub(super) enum Node {
    /// A file that is to be written.
    New(Destination),
    /// A file that is there, and must be the one that would be written.
    There(PathBuf),
}

impl Node {
    /// The one beside a `.ele`, unless it is read as the only one of so many inputs: one of several has not all points.
    pub(super) fn beside(
        ele: &Destination,
        read: &FilesRead,
        inputs: usize,
    ) -> Result<Option<Node>, Failure> {
        let path = ele.name.with_extension("node");
        let destination = Destination::of_path(path.clone())?;
        let is_read = destination
            .identity
            .as_ref()
            .is_some_and(|node| read.has(node));
        Ok(match (is_read, path.exists()) {
            (true, _) if inputs > 1 => Some(Node::New(destination)),
            (true, _) => None,
            (false, true) => Some(Node::There(path)),
            (false, false) => Some(Node::New(destination)),
        })
    }

    /// Where it is written, if it is.
    pub(super) fn written(&self) -> Option<&Destination> {
        match self {
            Node::New(destination) => Some(destination),
            Node::There(_) => None,
        }
    }

    /// Writes it, or compares it with the one that is there.
    pub(super) fn write(self, sorted: &Sorted, outputs: &mut Outputs<'_>) -> Result<(), Failure> {
        match self {
            Node::New(destination) => outputs.add_part(destination, |out| {
                write_points(sorted, out)?;
                Ok(true)
            }),
            Node::There(path) => {
                let compared = || {
                    let mut there = Compared {
                        file: BufReader::new(File::open(&path)?),
                        is_same: true,
                        bytes: Vec::new(),
                    };
                    write_points(sorted, &mut there)?;
                    Ok(there.is_same && there.file.read(&mut [0])? == 0)
                };
                let is_same: io::Result<bool> = compared();
                if is_same.map_err(|error| Failure::of_file(&path, &error))? {
                    return Ok(());
                }
                let message = format!(
                    "{} would be overwritten, since the .ele needs its vertices beside it: give the .ele another name",
                    path.display()
                );
                Err(Failure::Usage(message))
            }
        }
    }
}

/// Writes all points.
fn write_points(sorted: &Sorted, out: &mut impl Write) -> io::Result<()> {
    let points = sorted.order.summary().points;
    // Heights and columns are attributes, but for markers, which are the last column.
    let markers = sorted.columns.iter().filter(|name| *name == Column::MARKER);
    let markers = usize::from(markers.count() > 0 && sorted.has_markers());
    let attributes = usize::from(sorted.has_heights) + sorted.columns.len() - markers;
    writeln!(out, "{points} 2 {attributes} {markers}")?;
    let mut text = Vec::new();
    let written = each_point(sorted, |number, [x, y], height, columns| {
        text.clear();
        text.extend_from_slice((number + sorted.first_point).to_string().as_bytes());
        let (others, marker) = columns.split_at(columns.len() - markers);
        // A marker that is missing is 0.
        let marker = marker
            .iter()
            .map(|marker| if marker.is_nan() { &0.0 } else { marker });
        for value in [x, y].iter().chain(&height).chain(others).chain(marker) {
            text.push(b' ');
            value.write_text(&mut text);
        }
        text.push(b'\n');
        out.write_all(&text)
    });
    written.map_err(|trouble| match trouble {
        Trouble::Out(error) => error,
        Trouble::Order(error) => io::Error::other(error.to_string()),
        _ => unreachable!("points are read and written"),
    })
}

/// A file that is compared with what is written.
struct Compared {
    file: BufReader<File>,
    is_same: bool,
    bytes: Vec<u8>,
}

impl Write for Compared {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.is_same {
            self.bytes.resize(bytes.len(), 0);
            match self.file.read_exact(&mut self.bytes) {
                Ok(()) => self.is_same = self.bytes == bytes,
                Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => self.is_same = false,
                Err(error) => return Err(error),
            }
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

//! Numbers without a header, little-endian: points as pairs of doubles, edges as pairs of whole numbers of 64 bits.

use std::path::Path;

use sweep_cdt_formats::{Column, CoordinateSystem, ReadError, Remark};

use crate::external::input::file::{InputFile, PIECE};
use crate::external::input::{Input, Part};

/// The bytes of a point, and of an edge.
const PAIR: usize = 16;

/// A file of pairs.
#[derive(Debug)]
struct Pairs {
    file: InputFile,
    bytes: Vec<u8>,
}

impl Pairs {
    fn new(file: InputFile, what: &str) -> Result<Pairs, ReadError> {
        if !file.length.is_multiple_of(PAIR as u64) {
            let length = file.length;
            let message = format!(
                "the file has {length} bytes, and {what} takes {PAIR}: it is cut off, or holds something else"
            );
            return Err(file.error(message));
        }
        let bytes = Vec::new();
        Ok(Pairs { file, bytes })
    }

    /// The next pairs, as the bytes of their numbers.
    fn next(&mut self) -> Result<impl Iterator<Item = [[u8; 8]; 2]>, ReadError> {
        self.bytes.clear();
        self.file.read(PIECE, &mut self.bytes)?;
        if self.bytes.is_empty() {
            self.file.check()?;
        }
        let numbers = self.bytes.as_chunks::<8>().0.as_chunks::<2>().0;
        Ok(numbers.iter().copied())
    }
}

/// Points alone.
#[derive(Debug)]
pub(super) struct Points(Pairs);

impl Points {
    pub(super) fn new(file: InputFile) -> Result<Points, ReadError> {
        Pairs::new(file, "a point of two doubles").map(Points)
    }
}

impl Input for Points {
    fn name(&self) -> &str {
        &self.0.file.name
    }

    fn next_points(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError> {
        points.extend(self.0.next()?.map(|pair| pair.map(f64::from_le_bytes)));
        Ok(())
    }

    fn has_edges(&self) -> bool {
        false
    }

    fn progress(&self) -> (u64, u64) {
        (self.0.file.at, self.0.file.length)
    }
}

/// The points of an input, with the edges of a file.
pub(super) struct WithEdges {
    points: Box<dyn Input>,
    edges: Pairs,
    are_points_read: bool,
}

impl WithEdges {
    pub(super) fn open(points: Box<dyn Input>, edges: &Path) -> Result<WithEdges, ReadError> {
        Ok(WithEdges {
            points,
            edges: Pairs::new(InputFile::open(edges)?, "an edge of two numbers of points")?,
            are_points_read: false,
        })
    }
}

impl Input for WithEdges {
    /// The file that is read now.
    fn name(&self) -> &str {
        match self.are_points_read {
            false => self.points.name(),
            true => &self.edges.file.name,
        }
    }

    /// Edges without a header count all points from 0.
    fn part(&self) -> Part {
        match self.are_points_read {
            false => self.points.part(),
            true => Part::default(),
        }
    }

    fn inputs(&self) -> &[Box<dyn Input>] {
        match self.points.inputs() {
            [] => std::slice::from_ref(&self.points),
            inputs => inputs,
        }
    }

    fn next_points(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError> {
        self.points.next_points(points)
    }

    fn heights(&self) -> Option<&[f64]> {
        self.points.heights()
    }

    fn columns(&self) -> &[Column] {
        self.points.columns()
    }

    fn next_edges(&mut self, edges: &mut Vec<[u64; 2]>) -> Result<(), ReadError> {
        self.are_points_read = true;
        edges.extend(self.edges.next()?.map(|pair| pair.map(u64::from_le_bytes)));
        Ok(())
    }

    fn remarks(&self) -> Vec<Remark> {
        self.points.remarks()
    }

    fn has_heights(&self) -> bool {
        self.points.has_heights()
    }

    fn system(&self) -> Option<CoordinateSystem> {
        self.points.system()
    }

    fn progress(&self) -> (u64, u64) {
        let (done, all) = self.points.progress();
        (done + self.edges.file.at, all + self.edges.file.length)
    }
}

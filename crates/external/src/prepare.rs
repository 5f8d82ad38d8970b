//! Sorting from front to back: the points in runs, the edges joined to their ends, and then the order.

use std::path::PathBuf;
use std::time::Instant;

use crate::batch::Maker;
use crate::edges::{self, Joined};
use crate::error::Error;
use crate::input::Input;
use crate::order::SweepOrder;
use crate::points::{self, Points};
use crate::summary::Statistics;

/// How points and edges are sorted.
#[derive(Clone, Debug)]
pub struct Sorting {
    memory: u64,
    folder: PathBuf,
}

impl Sorting {
    /// Sorts in about so many bytes of memory, with temporary files in this folder.
    pub fn new(memory: u64, folder: impl Into<PathBuf>) -> Sorting {
        Sorting {
            memory,
            folder: folder.into(),
        }
    }

    /// Reads an input and sorts it.
    ///
    /// # Errors
    /// See [`Error`].
    pub fn sort(&self, input: &mut (dyn Input + '_)) -> Result<SweepOrder, Error> {
        self.sort_with(input, &mut |_, _| {})
    }

    /// [`Sorting::sort`], which tells `progress` how many bytes of how many are read.
    ///
    /// # Errors
    /// See [`Error`].
    pub fn sort_with(
        &self,
        input: &mut (dyn Input + '_),
        progress: &mut dyn FnMut(u64, u64),
    ) -> Result<SweepOrder, Error> {
        let memory = usize::try_from(self.memory).unwrap_or(usize::MAX);
        let since = Instant::now();
        let Points {
            sorted,
            capacity,
            mut summary,
        } = points::sort(input, memory, &self.folder, progress)?;
        let mut statistics = Statistics {
            runs: sorted.runs(),
            reading: since.elapsed(),
            ..Statistics::default()
        };
        let since = Instant::now();
        let Joined {
            points,
            edges,
            moved: [written, read],
        } = edges::join(edges::Task {
            input,
            points: sorted,
            capacity,
            memory,
            folder: &self.folder,
            summary: &mut summary,
            progress,
        })?;
        statistics.joining = since.elapsed();
        statistics.edge_runs = edges.runs();
        statistics.written = written + points.written() + edges.written();
        statistics.read = read;
        let [for_points, for_edges] = match summary.edges {
            0 => [memory, 0],
            _ => [memory / 8 * 5, memory / 4],
        };
        let points = points.batches(for_points);
        let points = points.map_err(|error| of_all(error, for_points, memory))?;
        let edges = edges.batches(for_edges);
        let edges = edges.map_err(|error| of_all(error, for_edges, memory))?;
        let maker = Maker::new(points, edges);
        Ok(SweepOrder::new(maker, summary, statistics))
    }
}

/// The error of a share of the memory, for all of the memory.
fn of_all(error: Error, share: usize, memory: usize) -> Error {
    match error {
        Error::TooLittleMemory { needed, .. } => Error::TooLittleMemory {
            memory: memory as u64,
            needed: needed.saturating_mul(memory.div_ceil(share.max(1)) as u64),
        },
        error => error,
    }
}

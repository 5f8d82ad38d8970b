//! Sorting from front to back: the points in runs, the edges joined to their ends, and then the order.

use std::path::PathBuf;
use std::time::Instant;

use sweep_cdt_formats::ReadError;

use crate::external::batch::{Maker, PointBatches};
use crate::external::edges::{self, Joined};
use crate::external::error::Error;
use crate::external::input::{Input, Part};
use crate::external::memory::Account;
use crate::external::order::SweepOrder;
use crate::external::points::{self, Points};
use crate::external::record::{Located, Point, Raised};
use crate::external::sorter::Batches;
use crate::external::summary::Statistics;

/// How points and edges are sorted.
#[derive(Clone, Debug)]
pub struct Sorting {
    memory: u64,
    folder: PathBuf,
}

impl Sorting {
    /// Sorts with at most so many bytes for what grows with the input, but for the edges of one vertex, which are in memory
    /// together. What has a constant size comes to a few megabytes more. At most half of it is used while the order is taken.
    /// Temporary files are made in this folder.
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
        match input.heights() {
            None => self.sort_records::<Point>(input, progress),
            Some(_) => self.sort_records::<Raised>(input, progress),
        }
    }

    fn sort_records<P: Located>(
        &self,
        input: &mut (dyn Input + '_),
        progress: &mut dyn FnMut(u64, u64),
    ) -> Result<SweepOrder, Error>
    where
        PointBatches: From<Batches<P>>,
    {
        let mut counted = Counted {
            input,
            points: 0,
            edges: 0,
        };
        self.sorted::<P>(&mut counted, progress)
            .map_err(|error| match error {
                Error::TooLittleMemory { memory, .. } => match counted.rest() {
                    Ok([points, edges]) => Error::TooLittleMemory {
                        memory,
                        needed: Account::needed::<P>(points, edges),
                    },
                    Err(error) => error.into(),
                },
                error => error,
            })
    }

    fn sorted<P: Located>(
        &self,
        input: &mut Counted<'_, '_>,
        progress: &mut dyn FnMut(u64, u64),
    ) -> Result<SweepOrder, Error>
    where
        PointBatches: From<Batches<P>>,
    {
        let account = Account(self.memory);
        let since = Instant::now();
        let Points {
            sorted,
            mut summary,
        } = points::sort::<P>(input, account, &self.folder, progress)?;
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
            account,
            folder: &self.folder,
            summary: &mut summary,
            progress,
        })?;
        statistics.joining = since.elapsed();
        statistics.edge_runs = edges.runs();
        statistics.written = written + points.written() + edges.written();
        statistics.read = read;
        let (points, edges) = (points.batches(account), edges.batches(account));
        let maker = Maker::new(points, edges, account.batch());
        Ok(SweepOrder::new(maker, summary, statistics))
    }
}

/// An input of which is counted what has come.
struct Counted<'a, 'i> {
    input: &'a mut (dyn Input + 'i),
    points: u64,
    edges: u64,
}

impl Counted<'_, '_> {
    /// Reads the rest. Returns how many points and edges there are.
    fn rest(&mut self) -> Result<[u64; 2], ReadError> {
        let (mut points, mut edges) = (Vec::new(), Vec::new());
        // All points are read before the first edge.
        while self.edges == 0 {
            points.clear();
            self.next_points(&mut points)?;
            if points.is_empty() {
                break;
            }
        }
        loop {
            edges.clear();
            self.next_edges(&mut edges)?;
            if edges.is_empty() {
                return Ok([self.points, self.edges]);
            }
        }
    }
}

impl Input for Counted<'_, '_> {
    fn name(&self) -> &str {
        self.input.name()
    }

    fn part(&self) -> Part {
        self.input.part()
    }

    fn next_points(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError> {
        let before = points.len();
        self.input.next_points(points)?;
        self.points += (points.len() - before) as u64;
        Ok(())
    }

    fn heights(&self) -> Option<&[f64]> {
        self.input.heights()
    }

    fn next_edges(&mut self, edges: &mut Vec<[u64; 2]>) -> Result<(), ReadError> {
        let before = edges.len();
        self.input.next_edges(edges)?;
        self.edges += (edges.len() - before) as u64;
        Ok(())
    }

    fn progress(&self) -> (u64, u64) {
        self.input.progress()
    }
}

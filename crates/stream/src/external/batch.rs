//! Pieces of the order: points and edges, each in their order, joined by their places.
//!
//! Of equal points the first one meets the edges that begin there, and has all of them.

use std::time::{Duration, Instant};

use crate::external::error::Error;
use crate::external::record::{Edge, Located, Point, Raised};
use crate::external::sorter::Batches;

/// A piece of the order.
#[derive(Debug, Default)]
pub(crate) struct Batch {
    pub(crate) points: Vec<Point>,
    /// The height of each, if they have any.
    pub(crate) heights: Vec<f64>,
    /// The edges of all points of the batch.
    pub(crate) upper: Vec<(u64, [f64; 2])>,
    /// The points at which edges begin, and where in `upper` their edges end.
    pub(crate) ends: Vec<(usize, usize)>,
    /// How many bytes are read of temporary files, and how long merging has taken.
    pub(crate) read: u64,
    pub(crate) merging: Duration,
}

/// Points that come one batch after the other, with their heights or without.
#[derive(Debug)]
pub(crate) enum PointBatches {
    Flat(Batches<Point>),
    Raised(Batches<Raised>, Vec<Raised>),
}

impl From<Batches<Point>> for PointBatches {
    fn from(batches: Batches<Point>) -> PointBatches {
        PointBatches::Flat(batches)
    }
}

impl From<Batches<Raised>> for PointBatches {
    fn from(batches: Batches<Raised>) -> PointBatches {
        PointBatches::Raised(batches, Vec::new())
    }
}

impl PointBatches {
    /// Puts the next points and heights in the place of those of a batch; none if there are no more.
    fn next(&mut self, batch: &mut Batch) -> Result<(), Error> {
        match self {
            PointBatches::Flat(batches) => batches.next(&mut batch.points),
            PointBatches::Raised(batches, records) => {
                batches.next(records)?;
                batch.points.clear();
                batch.points.extend(records.iter().map(Located::point));
                batch.heights.clear();
                batch.heights.extend(records.iter().map(Located::height));
                Ok(())
            }
        }
    }

    /// How many bytes were read.
    fn read(&self) -> u64 {
        match self {
            PointBatches::Flat(batches) => batches.read(),
            PointBatches::Raised(batches, _) => batches.read(),
        }
    }
}

/// What makes batches: points and edges, each in their order, are joined by their places.
#[derive(Debug)]
pub(crate) struct Maker {
    points: PointBatches,
    edges: Batches<Edge>,
    /// Edges that begin at no point yet.
    waiting: Vec<Edge>,
    waiting_at: usize,
    /// Points behind a batch that has ended early, with their heights, and the edges after which one does.
    rest: Vec<Point>,
    rest_heights: Vec<f64>,
    most: usize,
    /// The time that it has taken.
    merging: Duration,
}

impl Maker {
    /// Batches end after `most` edges, with all edges of a point.
    pub(crate) fn new(points: impl Into<PointBatches>, edges: Batches<Edge>, most: usize) -> Maker {
        Maker {
            points: points.into(),
            edges,
            waiting: Vec::new(),
            waiting_at: 0,
            rest: Vec::new(),
            rest_heights: Vec::new(),
            most,
            merging: Duration::ZERO,
        }
    }

    /// Makes the next batch, which has no points at the end.
    pub(crate) fn make(&mut self, batch: &mut Batch) -> Result<(), Error> {
        let since = Instant::now();
        batch.upper.clear();
        batch.ends.clear();
        if self.rest.is_empty() {
            self.points.next(batch)?;
        } else {
            std::mem::swap(&mut batch.points, &mut self.rest);
            self.rest.clear();
            std::mem::swap(&mut batch.heights, &mut self.rest_heights);
            self.rest_heights.clear();
        }
        let mut at = 0;
        while let Some(edge) = self.next_edge()? {
            // Points before the edge's place have no edges.
            let is_before = |point: &Point| (point.y, point.x) < (edge.y, edge.x);
            while batch.points.get(at).is_some_and(is_before) {
                at += 1;
            }
            let Some(point) = batch.points.get(at) else {
                break;
            };
            assert!(
                (point.y, point.x) == (edge.y, edge.x),
                "every edge begins at a point"
            );
            if batch.upper.len() >= self.most && batch.ends.last().is_some_and(|last| last.0 < at) {
                self.rest.extend_from_slice(&batch.points[at..]);
                batch.points.truncate(at);
                let heights = batch.heights.get(at..).unwrap_or_default();
                self.rest_heights.extend_from_slice(heights);
                batch.heights.truncate(at);
                break;
            }
            batch.upper.push((edge.number, edge.upper));
            match batch.ends.last_mut() {
                Some((index, end)) if *index == at => *end += 1,
                _ => batch.ends.push((at, batch.upper.len())),
            }
            self.waiting_at += 1;
        }
        batch.read = self.points.read() + self.edges.read();
        self.merging += since.elapsed();
        batch.merging = self.merging;
        Ok(())
    }

    /// The first edge that has begun at no point yet.
    fn next_edge(&mut self) -> Result<Option<Edge>, Error> {
        if self.waiting_at == self.waiting.len() {
            self.edges.next(&mut self.waiting)?;
            self.waiting_at = 0;
        }
        Ok(self.waiting.get(self.waiting_at).copied())
    }
}

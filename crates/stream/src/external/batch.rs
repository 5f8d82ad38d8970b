//! Pieces of the order: points and edges, each in their order, joined by their places.
//!
//! Of equal points the first one meets the edges that begin there, and has all of them.

use std::time::{Duration, Instant};

use crate::external::error::Error;
use crate::external::record::{Edge, Point};
use crate::external::sorter::Batches;

/// A piece of the order.
#[derive(Debug, Default)]
pub(crate) struct Batch {
    pub(crate) points: Vec<Point>,
    /// The edges of all points of the batch.
    pub(crate) upper: Vec<(u64, [f64; 2])>,
    /// The points at which edges begin, and where in `upper` their edges end.
    pub(crate) ends: Vec<(usize, usize)>,
    /// How many bytes are read of temporary files, and how long merging has taken.
    pub(crate) read: u64,
    pub(crate) merging: Duration,
}

/// What makes batches: points and edges, each in their order, are joined by their places.
#[derive(Debug)]
pub(crate) struct Maker {
    points: Batches<Point>,
    edges: Batches<Edge>,
    /// Edges that begin at no point yet.
    waiting: Vec<Edge>,
    waiting_at: usize,
    /// Points behind a batch that has ended early, and the edges after which one does.
    rest: Vec<Point>,
    most: usize,
    /// The time that it has taken.
    merging: Duration,
}

impl Maker {
    /// Batches end after `most` edges, with all edges of a point.
    pub(crate) fn new(points: Batches<Point>, edges: Batches<Edge>, most: usize) -> Maker {
        Maker {
            points,
            edges,
            waiting: Vec::new(),
            waiting_at: 0,
            rest: Vec::new(),
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
            self.points.next(&mut batch.points)?;
        } else {
            std::mem::swap(&mut batch.points, &mut self.rest);
            self.rest.clear();
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

//! The points on their way from the input to runs.
//!
//! A run is sorted and written while the next one is read.

use std::path::Path;

use sweep_cdt::threads::beside;
use sweep_cdt_formats::Coordinate;

use crate::external::error::Error;
use crate::external::input::{Input, Part};
use crate::external::memory::Account;
use crate::external::record::{Located, Point, Record};
use crate::external::sorter::{Runs, Sorted, reserve};
use crate::external::summary::Summary;

/// The points, sorted.
pub(crate) struct Points<P> {
    pub(crate) sorted: Sorted<P>,
    pub(crate) summary: Summary,
}

/// Reads the points and sorts them in runs.
pub(crate) fn sort<P: Located>(
    input: &mut (dyn Input + '_),
    account: Account,
    folder: &Path,
    progress: &mut dyn FnMut(u64, u64),
) -> Result<Points<P>, Error> {
    let capacity = account.run::<P>();
    let mut runs = Runs::new(account, folder);
    let mut filler = Filler::new(capacity);
    let (mut filled, mut full): (Vec<P>, Vec<P>) = (Vec::new(), Vec::new());
    filler.fill(input, &mut filled, progress)?;
    while filled.len() == capacity && !filler.is_at_end {
        std::mem::swap(&mut filled, &mut full);
        let first = full[0].number();
        let (mut read, mut written) = (Ok(()), Ok(()));
        beside(
            &mut || read = filler.fill(input, &mut filled, progress),
            &mut || written = runs.add(&mut full, first),
        );
        read?;
        written?;
    }
    drop(full);
    let first = filled.first().map_or(0, Record::number);
    let mut summary = filler.summary;
    if summary.exponent == i64::MAX {
        summary.exponent = 0;
    }
    Ok(Points {
        sorted: runs.finish(filled, first)?,
        summary,
    })
}

/// Points on their way from the input to a run.
struct Filler {
    capacity: usize,
    /// Points that were read, and how many of them are in a run.
    block: Vec<[f64; 2]>,
    at: usize,
    is_at_end: bool,
    summary: Summary,
}

impl Filler {
    fn new(capacity: usize) -> Filler {
        Filler {
            capacity,
            block: Vec::new(),
            at: 0,
            is_at_end: false,
            summary: Summary {
                points: 0,
                edges: 0,
                open_edges: 0,
                edges_without_length: 0,
                x: [f64::INFINITY, f64::NEG_INFINITY],
                y: [f64::INFINITY, f64::NEG_INFINITY],
                exponent: i64::MAX,
                height: [f64::INFINITY, f64::NEG_INFINITY],
            },
        }
    }

    /// Puts the next points in the place of others, as many as a run has.
    fn fill<P: Located>(
        &mut self,
        input: &mut (dyn Input + '_),
        points: &mut Vec<P>,
        progress: &mut dyn FnMut(u64, u64),
    ) -> Result<(), Error> {
        points.clear();
        loop {
            let room = self.capacity - points.len();
            let begin = self.at;
            let block = &self.block[begin..];
            let block = &block[..block.len().min(room)];
            self.at += block.len();
            reserve(points, block.len(), self.capacity)?;
            // One for each point of the block, or none.
            let heights = input.heights().unwrap_or_default();
            for (at, &[x, y]) in (begin..).zip(block) {
                // -0.0 + 0.0 is 0.0, and all else stays as it is.
                let (x, y) = (x + 0.0, y + 0.0);
                // A height that is missing is NaN.
                let height = heights.get(at).copied().unwrap_or(f64::NAN);
                if !(x.is_finite() && y.is_finite()) || height.is_infinite() {
                    let Part { points, first, .. } = input.part();
                    return Err(Error::NonFinite {
                        file: input.name().to_owned(),
                        point: self.summary.points.saturating_sub(points.start) + first[0],
                    });
                }
                let number = self.summary.points;
                let point = P::new(Point { y, x, number }, height);
                points.push(point);
                self.summary.points += 1;
                widen(&mut self.summary.x, x);
                widen(&mut self.summary.y, y);
                for coordinate in [x, y] {
                    if let Some((integer, exponent)) = coordinate.small_binary()
                        && integer != 0
                    {
                        self.summary.exponent = self.summary.exponent.min(exponent);
                    }
                }
                widen(&mut self.summary.height, point.height());
            }
            if self.at < self.block.len() {
                return Ok(());
            }
            self.block.clear();
            self.at = 0;
            input.next_points(&mut self.block)?;
            let (done, all) = input.progress();
            progress(done, all);
            if self.block.is_empty() {
                self.is_at_end = true;
                return Ok(());
            }
        }
    }
}

/// Makes an interval hold a value; NaN is none.
fn widen(interval: &mut [f64; 2], value: f64) {
    interval[0] = interval[0].min(value);
    interval[1] = interval[1].max(value);
}

//! The order of the sweep, as it is taken: one vertex after the other, while a thread makes the next batch of them.

use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::thread::{self, JoinHandle};

use crate::external::batch::{Batch, Maker};
use crate::external::error::Error;
use crate::external::record::Point;
use crate::external::summary::{Statistics, Summary};

/// A vertex: a point, and the edges that begin there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex<'a> {
    /// The number of the point in the input, from 0.
    pub number: u64,
    /// The x and y of the vertex.
    pub point: [f64; 2],
    /// The height of the vertex, where the input gives heights and it has one. Equal points may have several.
    pub height: Option<f64>,
    /// The edges whose lower end it is, in the order of their numbers: the number of each in the input, from 0, and its
    /// upper end. Of equal points the first one has them.
    pub upper: &'a [(u64, [f64; 2])],
}

/// Vertices in the order of the sweep, one after the other.
#[derive(Debug)]
pub struct SweepOrder {
    source: Source,
    batch: Batch,
    /// The next point, the next pair of `ends`, the next edge.
    at: [usize; 3],
    summary: Summary,
    statistics: Statistics,
}

/// Where batches come from.
#[derive(Debug)]
enum Source {
    /// A thread that makes the next one while this one is taken.
    Thread {
        batches: Receiver<Result<Batch, Error>>,
        used: Sender<Batch>,
        thread: JoinHandle<()>,
    },
    /// The thread of the caller: the system gives no other.
    Here(Box<Maker>),
    /// There are no more.
    End,
}

impl Source {
    fn new(maker: Maker) -> Source {
        // The maker goes to the thread only when the thread is there.
        let (give, given) = channel::<Maker>();
        let (made, batches) = sync_channel(1);
        let (used, old) = channel();
        let work = move || {
            if let Ok(maker) = given.recv() {
                make_all(maker, &made, &old);
            }
        };
        match thread::Builder::new().spawn(work) {
            Err(_) => Source::Here(Box::new(maker)),
            Ok(thread) => {
                // Should it not take the maker, no batch comes, and joining it tells why.
                let _ = give.send(maker);
                Source::Thread {
                    batches,
                    used,
                    thread,
                }
            }
        }
    }

    /// Puts the next batch in the place of another.
    fn next(&mut self, batch: &mut Batch) -> Result<(), Error> {
        let made = match self {
            Source::End => Ok(()),
            Source::Here(maker) => maker.make(batch),
            Source::Thread { batches, used, .. } => {
                // A thread that has ended takes no old batches.
                let _ = used.send(std::mem::take(batch));
                match batches.recv() {
                    Ok(Ok(next)) => {
                        *batch = next;
                        Ok(())
                    }
                    Ok(Err(error)) => Err(error),
                    Err(_) => {
                        self.end();
                        unreachable!("a thread that makes no last batch has panicked")
                    }
                }
            }
        };
        if made.is_err() || batch.points.is_empty() {
            self.end();
        }
        made
    }

    /// Ends the thread, and passes on its panic.
    fn end(&mut self) {
        if let Source::Thread {
            batches,
            used,
            thread,
        } = std::mem::replace(self, Source::End)
        {
            drop((batches, used));
            if let Err(panic) = thread.join()
                && !thread::panicking()
            {
                std::panic::resume_unwind(panic);
            }
        }
    }
}

/// Makes all batches, or as many as are taken.
fn make_all(mut maker: Maker, made: &SyncSender<Result<Batch, Error>>, old: &Receiver<Batch>) {
    loop {
        let mut batch = old.try_recv().unwrap_or_default();
        let result = maker.make(&mut batch);
        let is_last = result.is_err() || batch.points.is_empty();
        if made.send(result.map(|()| batch)).is_err() || is_last {
            return;
        }
    }
}

impl SweepOrder {
    pub(crate) fn new(maker: Maker, summary: Summary, statistics: Statistics) -> SweepOrder {
        SweepOrder {
            source: Source::new(maker),
            batch: Batch::default(),
            at: [0; 3],
            summary,
            statistics,
        }
    }

    /// How much comes, and from where to where.
    #[must_use]
    pub fn summary(&self) -> Summary {
        self.summary
    }

    /// What sorting has cost up to now.
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        Statistics {
            read: self.statistics.read + self.batch.read,
            merging: self.batch.merging,
            ..self.statistics
        }
    }

    /// The next vertex; `None` after the last, and after an error.
    ///
    /// # Errors
    /// See [`Error`]: the temporary files cannot be read.
    pub fn next_vertex(&mut self) -> Result<Option<Vertex<'_>>, Error> {
        if self.at[0] == self.batch.points.len() {
            self.source.next(&mut self.batch)?;
            self.at = [0; 3];
        }
        let [at, pair, edge] = self.at;
        let Some(&Point { y, x, number }) = self.batch.points.get(at) else {
            return Ok(None);
        };
        let height = self.batch.heights.get(at).copied();
        self.at[0] += 1;
        let mut upper: &[(u64, [f64; 2])] = &[];
        if let Some(&(index, end)) = self.batch.ends.get(pair)
            && index == at
        {
            upper = &self.batch.upper[edge..end];
            self.at = [at + 1, pair + 1, end];
        }
        Ok(Some(Vertex {
            number,
            point: [x, y],
            height: height.filter(|height| !height.is_nan()),
            upper,
        }))
    }
}

impl Drop for SweepOrder {
    /// Waits until the thread has closed the temporary files.
    fn drop(&mut self) {
        self.source.end();
    }
}

//! The order of the sweep: how it is made, and how it is taken.

use std::path::PathBuf;
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use sweep_cdt::threads::beside;

use crate::edges;
use crate::error::Error;
use crate::input::Input;
use crate::record::{Edge, Point};
use crate::sorter::{Batches, Runs, Sorted};

/// How points and edges are sorted.
#[derive(Clone, Debug)]
pub struct Sorting {
    memory: u64,
    folder: PathBuf,
}

/// What is known when all is sorted.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Summary {
    /// How many points there are, equal ones included.
    pub points: u64,
    /// How many edges come with the vertices.
    pub edges: u64,
    /// How many edges have no length, and do not come.
    pub edges_without_length: u64,
    /// The least and the greatest x; infinite, and the wrong way round, without points.
    pub x: [f64; 2],
    /// The least and the greatest y, likewise.
    pub y: [f64; 2],
}

/// What sorting cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Statistics {
    /// Bytes written to temporary files.
    pub written: u64,
    /// Bytes read from temporary files, up to now.
    pub read: u64,
    /// The runs of points.
    pub runs: usize,
    /// The runs of edges.
    pub edge_runs: usize,
    /// The time in which points were read and runs written.
    pub reading: Duration,
    /// The time in which edges were read and joined to their ends.
    pub joining: Duration,
    /// The time of merging up to now, which passes while others work.
    pub merging: Duration,
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
        } = self.points(input, memory, progress)?;
        let mut statistics = Statistics {
            runs: sorted.runs(),
            reading: since.elapsed(),
            ..Statistics::default()
        };
        let since = Instant::now();
        let edges = edges::join(edges::Task {
            input,
            points: sorted,
            capacity,
            memory,
            folder: &self.folder,
            summary: &mut summary,
            progress,
        })?;
        statistics.joining = since.elapsed();
        statistics.edge_runs = edges.edges.runs();
        statistics.written = edges.points.written() + edges.edges.written() + edges.moved[0];
        statistics.read = edges.moved[1];
        let [for_points, for_edges] = match summary.edges {
            0 => [memory, 0],
            _ => [memory / 8 * 5, memory / 4],
        };
        let maker = Maker {
            points: edges.points.batches(for_points)?,
            edges: edges.edges.batches(for_edges)?,
            waiting: Vec::new(),
            waiting_at: 0,
            merging: Duration::ZERO,
        };
        Ok(SweepOrder::new(maker, summary, statistics))
    }

    /// Reads the points and sorts them in runs.
    fn points(
        &self,
        input: &mut (dyn Input + '_),
        memory: usize,
        progress: &mut dyn FnMut(u64, u64),
    ) -> Result<Points, Error> {
        // A run is read while another is sorted with as much beside it.
        let capacity = (memory / (3 * size_of::<Point>())).clamp(1, u32::MAX as usize);
        let mut runs = Runs::new(&self.folder);
        let mut filler = Filler::new(capacity);
        let (mut filled, mut full) = (Vec::new(), Vec::new());
        filler.fill(input, &mut filled, progress)?;
        while filled.len() == capacity && !filler.is_at_end {
            std::mem::swap(&mut filled, &mut full);
            let first = full[0].number;
            let (mut read, mut written) = (Ok(()), Ok(()));
            beside(
                &mut || read = filler.fill(input, &mut filled, progress),
                &mut || written = runs.add(&mut full, first),
            );
            read?;
            written?;
        }
        drop(full);
        let first = filled.first().map_or(0, |point| point.number);
        Ok(Points {
            sorted: runs.finish(filled, first)?,
            capacity,
            summary: filler.summary,
        })
    }
}

/// The points, sorted.
struct Points {
    sorted: Sorted<Point>,
    /// How many of them every run but the last has.
    capacity: usize,
    summary: Summary,
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
                edges_without_length: 0,
                x: [f64::INFINITY, f64::NEG_INFINITY],
                y: [f64::INFINITY, f64::NEG_INFINITY],
            },
        }
    }

    /// Puts the next points in the place of others, as many as a run has.
    fn fill(
        &mut self,
        input: &mut (dyn Input + '_),
        points: &mut Vec<Point>,
        progress: &mut dyn FnMut(u64, u64),
    ) -> Result<(), Error> {
        points.clear();
        loop {
            let room = self.capacity - points.len();
            let block = &self.block[self.at..];
            let block = &block[..block.len().min(room)];
            self.at += block.len();
            reserve(points, block.len(), self.capacity)?;
            for &[x, y] in block {
                // -0.0 + 0.0 is 0.0, and all else stays as it is.
                let (x, y) = (x + 0.0, y + 0.0);
                if !(x.is_finite() && y.is_finite()) {
                    return Err(Error::NonFinite {
                        file: input.name().to_owned(),
                        point: self.summary.points + input.first()[0],
                    });
                }
                let number = self.summary.points;
                points.push(Point { y, x, number });
                self.summary.points += 1;
                widen(&mut self.summary.x, x);
                widen(&mut self.summary.y, y);
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

/// Makes room for more records: twice as many as there are, but no more than a run has.
pub(crate) fn reserve<R>(records: &mut Vec<R>, more: usize, capacity: usize) -> Result<(), Error> {
    let length = records.len() + more;
    if length <= records.capacity() {
        return Ok(());
    }
    let wanted = length.max(2 * records.capacity()).min(capacity.max(length));
    let got = records.try_reserve_exact(wanted - records.len());
    got.map_err(|_| Error::OutOfMemory {
        bytes: (wanted * size_of::<R>()) as u64,
    })
}

fn widen(interval: &mut [f64; 2], value: f64) {
    interval[0] = interval[0].min(value);
    interval[1] = interval[1].max(value);
}

/// A vertex: a point, and the edges that begin there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex<'a> {
    /// The number of the point in the input, from 0.
    pub number: u64,
    /// Its x and y.
    pub point: [f64; 2],
    /// The edges whose lower end it is: the number of each in the input, from 0, and its upper end. Of equal points the
    /// first one has them.
    pub upper: &'a [(u64, [f64; 2])],
}

/// A piece of the order.
#[derive(Debug, Default)]
struct Batch {
    points: Vec<Point>,
    /// The edges of all points of the batch.
    upper: Vec<(u64, [f64; 2])>,
    /// The points at which edges begin, and where in `upper` their edges end.
    ends: Vec<(usize, usize)>,
    /// How many bytes are read of temporary files, and how long merging has taken.
    read: u64,
    merging: Duration,
}

/// What makes batches: points and edges, each in their order, are joined by their places.
#[derive(Debug)]
struct Maker {
    points: Batches<Point>,
    edges: Batches<Edge>,
    /// Edges that begin at no point yet.
    waiting: Vec<Edge>,
    waiting_at: usize,
    /// The time that it has taken.
    merging: Duration,
}

impl Maker {
    /// Makes the next batch, which has no points at the end.
    fn make(&mut self, batch: &mut Batch) -> Result<(), Error> {
        let since = Instant::now();
        batch.upper.clear();
        batch.ends.clear();
        self.points.next(&mut batch.points)?;
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
    /// This thread: the system gives no other.
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
    fn new(maker: Maker, summary: Summary, statistics: Statistics) -> SweepOrder {
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

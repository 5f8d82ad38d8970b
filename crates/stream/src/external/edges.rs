//! Edges, joined to the places of their ends and sorted by the lower one.
//!
//! An edge names its ends by number; the runs are sorted by place, and each holds the points of an interval of numbers.
//! The runs are loaded one after the other, each as an array of places by number. An edge waits in a bucket on disk for
//! the run of its first end, that of the lower interval. There it takes the place of this end, and goes on to the bucket of
//! the other end's run. That run is the same one, or one that is loaded later. So when a run is loaded, all edges that
//! want a place of it are there: this is time-forward processing (Chiang and others 1995). An edge with both places goes to
//! its lower end, by y, then x, and is sorted.
//!
//! An edge whose ends are equal has no length, and is counted and dropped.
//!
//! Cost: one reading of the runs, and of each edge a writing of 24 bytes and maybe one of 32, before it is sorted with 40.
//! The pieces of a bucket on disk are a list, so that memory holds one place for each bucket. If all points are in
//! memory, nothing is written before that.

use std::path::Path;

use crate::external::error::Error;
use crate::external::input::Input;
use crate::external::memory::Account;
use crate::external::record::{Edge, Located, array};
use crate::external::runs::{PIECE, Run};
use crate::external::sorter::{Runs, Sorted, reserve};
use crate::external::summary::Summary;
use crate::external::temporary::Temporary;

/// What there is to join.
pub(crate) struct Task<'a, 'i, P> {
    pub(crate) input: &'a mut (dyn Input + 'i),
    pub(crate) points: Sorted<P>,
    pub(crate) account: Account,
    pub(crate) folder: &'a Path,
    pub(crate) summary: &'a mut Summary,
    pub(crate) progress: &'a mut dyn FnMut(u64, u64),
}

/// Points as they were, and edges sorted by their lower ends.
pub(crate) struct Joined<P> {
    pub(crate) points: Sorted<P>,
    pub(crate) edges: Sorted<Edge>,
    /// The bytes that were written beside the sorting, and read.
    pub(crate) moved: [u64; 2],
}

/// Reads the edges and joins them to their ends.
pub(crate) fn join<P: Located>(task: Task<'_, '_, P>) -> Result<Joined<P>, Error> {
    let Task {
        input,
        mut points,
        account,
        folder,
        summary,
        progress,
    } = task;
    // Every run but the last has as many points.
    let capacity = account.run::<P>();
    let mut ready = Ready::new(account, folder, summary.y);
    let mut waiting = Buckets::new(points.runs(), account, folder);
    let mut half_done = Buckets::new(points.runs(), account, folder);
    let mut places = Vec::new();

    // Edges as they come: to the run of the first end, or to both ends at once where these are in memory.
    let mut edges = Vec::new();
    let mut number: u64 = 0;
    loop {
        edges.clear();
        input.next_edges(&mut edges)?;
        let (done, all) = input.progress();
        progress(done, all);
        if edges.is_empty() {
            break;
        }
        if let Sorted::Memory(list) = &points
            && places.is_empty()
        {
            by_number(list, 0, list.len(), &mut places)?;
        }
        let part = input.part();
        let own = part.points.start..part.points.end.min(summary.points);
        for &ends in &edges {
            if let Some(&point) = ends.iter().find(|&end| !own.contains(end)) {
                let [first, first_edge] = part.first;
                return Err(Error::NoPoint {
                    file: input.name().to_owned(),
                    edge: number.saturating_sub(part.edges) + first_edge,
                    point: point.saturating_sub(own.start).saturating_add(first),
                    first,
                    points: own.end.saturating_sub(own.start),
                });
            }
            let [lower, upper] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
            match &points {
                Sorted::Memory(_) => {
                    let [a, b] = [lower, upper].map(|end| places[index(end)]);
                    ready.add(number, a, b, summary)?;
                }
                Sorted::Disk { .. } => {
                    let first = Waiting {
                        end: lower,
                        other: upper,
                        edge: number,
                    };
                    waiting.add(index(lower) / capacity, &first.bytes())?;
                }
            }
            number += 1;
        }
    }

    // The runs, one after the other.
    let mut read = 0;
    if let Sorted::Disk { file, runs } = &mut points {
        let mut bytes = Vec::new();
        let mut list: Vec<P> = Vec::new();
        for (at, &run) in runs.iter().enumerate() {
            if waiting.is_empty(at) && half_done.is_empty(at) {
                continue;
            }
            load(run, file, &mut bytes, &mut list, &mut places)?;
            let place = |end: u64| places[index(end - run.first)];
            waiting.take(at, &mut bytes, |bytes| {
                let edge = Waiting::of(bytes);
                let a = place(edge.end);
                let other_run = index(edge.other) / capacity;
                if other_run == at {
                    return ready.add(edge.edge, a, place(edge.other), summary);
                }
                let rest = HalfDone {
                    end: edge.other,
                    edge: edge.edge,
                    place: a,
                };
                half_done.add(other_run, &rest.bytes())
            })?;
            half_done.take(at, &mut bytes, |bytes| {
                let edge = HalfDone::of(bytes);
                ready.add(edge.edge, edge.place, place(edge.end), summary)
            })?;
        }
        read = file.read() + waiting.file.read() + half_done.file.read();
    }
    summary.open_edges = ready.strips.most();
    Ok(Joined {
        points,
        edges: ready.runs.finish(ready.list, 0)?,
        moved: [waiting.file.written() + half_done.file.written(), read],
    })
}

/// Loads the places of a run by number.
fn load<P: Located>(
    mut run: Run,
    file: &mut Temporary,
    bytes: &mut Vec<u8>,
    list: &mut Vec<P>,
    places: &mut Vec<[f64; 2]>,
) -> Result<(), Error> {
    let (first, count) = (run.first, run.left);
    places.clear();
    by_number::<P>(&[], first, count, places)?;
    while run.left > 0 {
        list.clear();
        run.read(PIECE / size_of::<P>(), file, bytes, list)?;
        for point in &*list {
            places[index(point.number() - first)] = [point.x(), point.y()];
        }
    }
    Ok(())
}

/// Makes room for so many places, and fills in those of a list.
fn by_number<P: Located>(
    list: &[P],
    first: u64,
    count: usize,
    places: &mut Vec<[f64; 2]>,
) -> Result<(), Error> {
    reserve(places, count, count)?;
    places.resize(count, [0.0; 2]);
    for point in list {
        places[index(point.number() - first)] = [point.x(), point.y()];
    }
    Ok(())
}

/// A number of a point as an index. Every point that is there was in memory once.
fn index(number: u64) -> usize {
    usize::try_from(number).expect("the number of a point that is there")
}

/// Edges with the places of both ends, on their way to being sorted.
struct Ready {
    runs: Runs<Edge>,
    list: Vec<Edge>,
    capacity: usize,
    strips: Strips,
}

impl Ready {
    fn new(account: Account, folder: &Path, y: [f64; 2]) -> Ready {
        Ready {
            strips: Strips::new(y),
            runs: Runs::new(account, folder),
            list: Vec::new(),
            capacity: account.run::<Edge>(),
        }
    }

    /// Adds an edge between two places, or counts it if they are one.
    fn add(
        &mut self,
        number: u64,
        a: [f64; 2],
        b: [f64; 2],
        summary: &mut Summary,
    ) -> Result<(), Error> {
        #[expect(clippy::float_cmp, reason = "equal places are one place")]
        if a == b {
            summary.edges_without_length += 1;
            return Ok(());
        }
        let is_in_order = (a[1], a[0]) < (b[1], b[0]);
        let ([x, y], upper) = if is_in_order { (a, b) } else { (b, a) };
        if self.list.len() == self.capacity {
            self.runs.add(&mut self.list, 0)?;
        }
        reserve(&mut self.list, 1, self.capacity)?;
        self.strips.add([y, upper[1]]);
        self.list.push(Edge {
            y,
            x,
            number,
            upper,
        });
        summary.edges += 1;
        Ok(())
    }
}

/// How many edges pass each strip between two y.
struct Strips {
    low: f64,
    /// Strips for each unit of y.
    scale: f64,
    /// How many more edges pass each strip than the one below.
    more: Vec<i64>,
}

const STRIPS: usize = 1 << 12;

impl Strips {
    fn new([low, high]: [f64; 2]) -> Strips {
        Strips {
            low,
            scale: STRIPS as f64 / (high - low),
            more: vec![0; STRIPS + 1],
        }
    }

    /// The strip of a y: no lower one for a higher y, however the numbers are rounded.
    fn of(&self, y: f64) -> usize {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "it saturates"
        )]
        let strip = ((y - self.low) * self.scale) as usize;
        strip.min(STRIPS - 1)
    }

    fn add(&mut self, ends: [f64; 2]) {
        let [low, high] = ends.map(|y| self.of(y));
        self.more[low] += 1;
        self.more[high + 1] -= 1;
    }

    /// The number of edges that pass the strip which most pass.
    fn most(&self) -> u64 {
        let passing = self.more.iter().scan(0, |count, more| {
            *count += more;
            Some(*count)
        });
        passing.max().map_or(0, i64::unsigned_abs)
    }
}

/// An edge that waits for the run of its first end.
struct Waiting {
    end: u64,
    other: u64,
    edge: u64,
}

impl Waiting {
    fn bytes(&self) -> [u8; 24] {
        let mut bytes = [0; 24];
        for (part, number) in bytes
            .as_chunks_mut()
            .0
            .iter_mut()
            .zip([self.end, self.other, self.edge])
        {
            *part = number.to_le_bytes();
        }
        bytes
    }

    fn of(bytes: &[u8; 24]) -> Waiting {
        Waiting {
            end: u64::from_le_bytes(array(bytes, 0)),
            other: u64::from_le_bytes(array(bytes, 8)),
            edge: u64::from_le_bytes(array(bytes, 16)),
        }
    }
}

/// An edge that knows the place of its first end, and waits for the run of the other.
struct HalfDone {
    end: u64,
    edge: u64,
    place: [f64; 2],
}

impl HalfDone {
    fn bytes(&self) -> [u8; 32] {
        let [x, y] = self.place;
        let mut bytes = [0; 32];
        bytes[..8].copy_from_slice(&self.end.to_le_bytes());
        bytes[8..16].copy_from_slice(&self.edge.to_le_bytes());
        bytes[16..24].copy_from_slice(&x.to_le_bytes());
        bytes[24..].copy_from_slice(&y.to_le_bytes());
        bytes
    }

    fn of(bytes: &[u8; 32]) -> HalfDone {
        HalfDone {
            end: u64::from_le_bytes(array(bytes, 0)),
            edge: u64::from_le_bytes(array(bytes, 8)),
            place: [
                f64::from_le_bytes(array(bytes, 16)),
                f64::from_le_bytes(array(bytes, 24)),
            ],
        }
    }
}

/// Records of N bytes in buckets: the end of each in memory, the rest in one file.
struct Buckets<const N: usize> {
    file: Temporary,
    buckets: Vec<Bucket>,
    /// How many bytes of a bucket are in memory: the place of the piece before them, and records.
    room: usize,
}

/// The last piece of a bucket, and where the one before it stands in the file. There each piece tells the same.
#[derive(Default)]
struct Bucket {
    bytes: Vec<u8>,
    before: Option<u64>,
}

/// The bytes of the place of a piece.
const PLACE: usize = 8;

impl<const N: usize> Buckets<N> {
    fn new(count: usize, account: Account, folder: &Path) -> Buckets<N> {
        let records = account.bucket(count).min(PIECE).saturating_sub(PLACE) / N;
        Buckets {
            file: Temporary::new(folder),
            buckets: (0..count).map(|_| Bucket::default()).collect(),
            // As few runs as can be merged leave room for one.
            room: PLACE + records.max(1) * N,
        }
    }

    fn is_empty(&self, bucket: usize) -> bool {
        self.buckets[bucket].bytes.is_empty()
    }

    fn add(&mut self, bucket: usize, record: &[u8; N]) -> Result<(), Error> {
        let Bucket { bytes, before } = &mut self.buckets[bucket];
        if bytes.len() == self.room {
            *before = Some(self.file.append(bytes)?);
            bytes.clear();
        }
        if bytes.is_empty() {
            bytes.reserve_exact(self.room);
            bytes.extend_from_slice(&before.unwrap_or(u64::MAX).to_le_bytes());
        }
        bytes.extend_from_slice(record);
        Ok(())
    }

    /// Takes all records of a bucket, which is empty then.
    fn take(
        &mut self,
        bucket: usize,
        bytes: &mut Vec<u8>,
        mut take: impl FnMut(&[u8; N]) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let bucket = std::mem::take(&mut self.buckets[bucket]);
        let records = bucket.bytes.get(PLACE..).unwrap_or_default();
        records.as_chunks().0.iter().try_for_each(&mut take)?;
        bytes.resize(self.room, 0);
        let mut before = bucket.before;
        while let Some(place) = before {
            self.file.read_at(place, bytes)?;
            let (of_before, records) = bytes.split_at(PLACE);
            records.as_chunks().0.iter().try_for_each(&mut take)?;
            before =
                Some(u64::from_le_bytes(array(of_before, 0))).filter(|&place| place != u64::MAX);
        }
        Ok(())
    }
}

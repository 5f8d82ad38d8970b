//! Bands and joins as tasks that wait for each other, done by a number of workers.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::time::Duration;

use crate::measure::Band;

/// Bytes a second that one worker reads or writes.
const DISK: f64 = 0.5e9;
/// So many workers a file system serves at once; the others wait.
const SERVED: usize = 10;
/// A vertex in a file of points, and in a band.
const POINT: f64 = 16.0;
const RECORD: f64 = 24.0;

/// How a run is laid out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plan {
    pub(crate) workers: usize,
    /// So many rests are joined at once.
    pub(crate) fan: usize,
    /// Whether one machine sorts, as `sweep-cdt stream --band` does, and not all.
    pub(crate) sorted_by_one: bool,
    /// Bytes a second of a worker, and how many workers read or write at once.
    pub(crate) disk: f64,
    pub(crate) served: usize,
}

impl Plan {
    /// All workers sort, on a file system that they share.
    pub(crate) fn of(workers: usize) -> Plan {
        Plan {
            workers,
            fan: 8,
            sorted_by_one: false,
            disk: DISK,
            served: SERVED,
        }
    }
}

/// Seconds of a run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Run {
    pub(crate) band: u64,
    pub(crate) sort: f64,
    /// From the end of the sort to the end of the last band.
    pub(crate) bands: f64,
    /// From there on, when only joins run.
    pub(crate) joins: f64,
    /// All joins together, of one worker.
    pub(crate) joining: f64,
}

impl Run {
    pub(crate) fn total(&self) -> f64 {
        self.sort + self.bands + self.joins
    }
}

/// A band, or a join of others.
struct Task {
    /// Reading and writing, and the processor's time.
    disk: Duration,
    seconds: Duration,
    /// The tasks whose rests are joined.
    from: Vec<usize>,
    /// Whether anything lies below, and above.
    beyond: [bool; 2],
}

/// The run whose bands have the best of the measured sizes.
pub(crate) fn best(measured: &[Band], sort: f64, plan: Plan) -> Run {
    let runs = measured.iter().map(|band| simulate(band, sort, plan));
    runs.min_by(|a, b| a.total().total_cmp(&b.total()))
        .expect("a measured size")
}

/// A run, where sorting n points, without cutting, takes `sort` n log n seconds.
pub(crate) fn simulate(band: &Band, sort: f64, plan: Plan) -> Run {
    let n = band.total as f64;
    // All workers read the points and write bands; one machine writes and reads runs between, as more than memory holds.
    let (sorters, bytes) = match plan.sorted_by_one {
        true => (1, POINT + 3.0 * RECORD),
        false => (plan.workers, POINT + RECORD),
    };
    let disks = sorters.min(plan.served) as f64;
    let each = sort * n.log2() + band.cutting / band.size as f64;
    let sort = n * (each / sorters as f64 + bytes / plan.disk / disks);
    let tasks = tasks(band, plan);
    let [bands, all] = scheduled(&tasks, plan);
    let joins = tasks.iter().filter(|task| !task.from.is_empty());
    Run {
        band: band.size,
        sort,
        bands,
        joins: all - bands,
        joining: joins
            .map(|task| (task.disk + task.seconds).as_secs_f64())
            .sum(),
    }
}

/// The tree of tasks: bands from below, then joins level by level.
fn tasks(band: &Band, plan: Plan) -> Vec<Task> {
    let word = if band.total <= 1 << 32 { 4.0 } else { 8.0 };
    // A rest lies at the floor and at the line, where something is beyond.
    let sides = |beyond: [bool; 2]| beyond.into_iter().filter(|&is| is).count() as f64 / 2.0;
    let task = |seconds, read: f64, finished: f64, beyond, from| {
        let written = 6.0 * word * finished + sides(beyond) * band.rest_bytes;
        let disk = Duration::from_secs_f64((read + written) / plan.disk);
        let seconds = Duration::from_secs_f64(seconds);
        Task {
            disk,
            seconds,
            beyond,
            from,
        }
    };
    let size = band.size as f64;
    let count = usize::try_from(band.total.div_ceil(band.size)).expect("few bands");
    let beyond = |k| [k > 0, k + 1 < count];
    let of_band = |k| task(band.seconds, size * RECORD, size, beyond(k), Vec::new());
    let mut tasks: Vec<Task> = (0..count).map(of_band).collect();
    let mut level: Vec<usize> = (0..count).collect();
    while level.len() > 1 {
        let first = tasks.len();
        for from in level.chunks(plan.fan) {
            let beyond = [
                tasks[from[0]].beyond[0],
                tasks[from[from.len() - 1]].beyond[1],
            ];
            let rests: f64 = from.iter().map(|&k| sides(tasks[k].beyond)).sum();
            let (read, finished) = (rests * band.rest_bytes, (rests - sides(beyond)) * band.rest);
            let seconds = band.join.at(rests * band.rest);
            tasks.push(task(
                seconds,
                read,
                finished.max(0.0),
                beyond,
                from.to_vec(),
            ));
        }
        level = (first..tasks.len()).collect();
    }
    tasks
}

/// When the last band ends, and the last task, if a free worker takes a join that is ready, or else the next band.
fn scheduled(tasks: &[Task], plan: Plan) -> [f64; 2] {
    let mut waits: Vec<usize> = tasks.iter().map(|task| task.from.len()).collect();
    let mut joined_by = vec![None; tasks.len()];
    for (k, task) in tasks.iter().enumerate() {
        task.from.iter().for_each(|&from| joined_by[from] = Some(k));
    }
    let rank = |k: usize| (!tasks[k].from.is_empty(), Reverse(k));
    let bands = (0..tasks.len()).filter(|&k| waits[k] == 0);
    let mut ready: BinaryHeap<_> = bands.map(rank).collect();
    // When each place at the disks is free, and each running task ends.
    let places = plan.served.min(plan.workers);
    let mut disks = BinaryHeap::from(vec![Reverse(Duration::ZERO); places]);
    let mut running = BinaryHeap::new();
    let (mut now, mut last_band) = (Duration::ZERO, Duration::ZERO);
    loop {
        while running.len() < plan.workers
            && let Some((_, Reverse(k))) = ready.pop()
        {
            let Reverse(free) = disks.pop().expect("a place for each that was taken");
            let through = free.max(now) + tasks[k].disk;
            disks.push(Reverse(through));
            running.push(Reverse((through + tasks[k].seconds, k)));
        }
        let Some(Reverse((end, k))) = running.pop() else {
            return [last_band, now].map(|time| time.as_secs_f64());
        };
        now = end;
        if tasks[k].from.is_empty() {
            last_band = now;
        }
        if let Some(join) = joined_by[k] {
            waits[join] -= 1;
            if waits[join] == 0 {
                ready.push(rank(join));
            }
        }
    }
}

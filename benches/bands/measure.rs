//! The processor's time of sorting, of bands and of joins, on one core.
//!
//! A band of an even input of N points needs no other band: it is a strip of width 1 with N points for each unit of
//! height, and something lies below and above.

use std::fs;
use std::sync::LazyLock;
use std::thread;
use std::time::Instant;

use peak_alloc::PeakAlloc;
use sweep_cdt::Triangulator;
use sweep_cdt_stream::{Cut, Final, Rest};
use sweep_cdt_testing::Random;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// So many bands follow each other.
const BANDS: u64 = 8;

/// What a band takes, and joins of what is left of bands. Times are the least of all repetitions.
#[derive(Debug)]
pub(crate) struct Band {
    /// The points of the input, and of the band.
    pub(crate) total: u64,
    pub(crate) size: u64,
    /// Seconds from sorted points to the bytes of the band.
    pub(crate) cutting: f64,
    /// From the bytes of the band to those of its triangles and its rest.
    pub(crate) seconds: f64,
    /// Bytes of memory at the peak, of a band and of a join of eight rests.
    pub(crate) memory: [usize; 2],
    /// The vertices of a rest, its bytes, and the vertices that a join of eight leaves.
    pub(crate) rest: f64,
    pub(crate) rest_bytes: f64,
    pub(crate) left: f64,
    /// Seconds of a join by the vertices of its rests.
    pub(crate) join: Power,
}

/// A power of x, times a factor.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Power {
    factor: f64,
    exponent: f64,
}

impl Power {
    /// The one of least squares of logarithms.
    fn of(points: &[[f64; 2]]) -> Power {
        let n = points.len() as f64;
        let logs: Vec<[f64; 2]> = points.iter().map(|p| p.map(f64::ln)).collect();
        let [x, y] = [0, 1].map(|i| logs.iter().map(|p| p[i]).sum::<f64>() / n);
        let sum =
            |of: fn(f64, f64) -> f64| logs.iter().map(|p| of(p[0] - x, p[1] - y)).sum::<f64>();
        let exponent = sum(|x, y| x * y) / sum(|x, _| x * x);
        Power {
            factor: (y - exponent * x).exp(),
            exponent,
        }
    }

    pub(crate) fn at(self, x: f64) -> f64 {
        self.factor * x.powf(self.exponent)
    }
}

/// Seconds of sorting n points by y and x, for each point and each step of log n.
pub(crate) fn sort(n: usize) -> f64 {
    let seconds = (0..2).map(|seed| {
        let mut points = numbered(&mut Random::new(seed), n, [0.0, 1.0]);
        let start = processor();
        sort_points(&mut points);
        processor() - start
    });
    seconds.fold(f64::INFINITY, f64::min) / (n as f64 * (n as f64).log2())
}

/// Seconds that this thread had of a processor: on Linux what other programs take is left out.
fn processor() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    // The kernel counts when it takes the processor away.
    thread::yield_now();
    let counted = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = counted.and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| START.elapsed().as_secs_f64(), |n| n / 1e9)
}

/// Bytes a second of writing a file and reading it again, in the folder of temporary files.
pub(crate) fn disk() -> f64 {
    let (path, bytes) = (
        std::env::temp_dir().join("sweep-cdt-bands"),
        vec![1; 1 << 26],
    );
    let seconds = (0..3).map(|_| {
        let start = Instant::now();
        fs::write(&path, &bytes).expect("a folder to write to");
        fs::read(&path).expect("what was written");
        start.elapsed().as_secs_f64()
    });
    let seconds = seconds.fold(f64::INFINITY, f64::min);
    fs::remove_file(&path).expect("what was written");
    2.0 * bytes.len() as f64 / seconds
}

/// Bands of `size` points of an input of `total`, and joins of two, four and eight of them.
pub(crate) fn band(total: u64, size: u64) -> Band {
    let cut = Cut {
        vertices: total,
        between: [0.0, 1.0],
    };
    let mut random = Random::new(total + size);
    let (mut cutting, mut seconds, mut memory) = (f64::INFINITY, f64::INFINITY, [0; 2]);
    let mut rests = Vec::new();
    // From the middle, so that something lies below and above.
    let below = total / 2 - BANDS / 2 * size;
    for k in 0..BANDS {
        let first = below + k * size;
        let y = [first, first + size].map(|n| n as f64 / total as f64);
        let mut points = numbered(&mut random, usize::try_from(size).expect("fits"), y);
        sort_points(&mut points);
        let start = processor();
        let rest = cut.band(first, points, [], |_| {}).expect("sorted points");
        let bytes = [rest.to_bytes()];
        drop(rest);
        cutting = cutting.min(processor() - start);
        let (rest, time) = measured(&bytes, &mut memory[0]);
        seconds = seconds.min(time);
        rests.push(rest);
    }
    let mut times = Vec::new();
    let mut left = 0.0;
    for fan in [2, 4, 8] {
        let taken: f64 = rests[..fan].iter().map(|rest| vertices(rest)).sum();
        let mut least = f64::INFINITY;
        for _ in 0..7 {
            let (rest, time) = measured(&rests[..fan], &mut memory[1]);
            least = least.min(time);
            left = vertices(&rest);
        }
        times.push([taken, least]);
    }
    let mean = |of: fn(&Vec<u8>) -> f64| rests.iter().map(of).sum::<f64>() / BANDS as f64;
    Band {
        total,
        size,
        cutting,
        seconds,
        memory,
        rest: mean(|rest| vertices(rest)),
        rest_bytes: mean(|rest| rest.len() as f64),
        left,
        join: Power::of(&times),
    }
}

/// What `sweep-cdt join` does between reading and writing: the bytes of a rest, and seconds.
fn measured(files: &[Vec<u8>], peak: &mut usize) -> (Vec<u8>, f64) {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let start = processor();
    let rests = files
        .iter()
        .map(|bytes| Rest::from_bytes(bytes).expect("a rest"));
    let all = rests.reduce(|below, above| below.followed_by(above).expect("the next one"));
    let mut triangles: Vec<u8> = Vec::new();
    let settled = all
        .expect("a rest")
        .settle(&mut Triangulator::new().session(), |found| {
            if let Final::Triangle { corners, .. } = found {
                triangles.extend(corners.map(u64::to_le_bytes).as_flattened());
            }
        });
    let bytes = settled.expect("no edges that cross").to_bytes();
    let seconds = processor() - start;
    *peak = (*peak).max(MEMORY.peak_usage() - before);
    (bytes, seconds)
}

fn vertices(rest: &[u8]) -> f64 {
    Rest::from_bytes(rest).expect("a rest").vertices() as f64
}

/// Points of a strip, with numbers.
fn numbered(random: &mut Random, n: usize, [low, high]: [f64; 2]) -> Vec<(u64, [f64; 2])> {
    let point = |number| (number, [random.unit(), low + (high - low) * random.unit()]);
    (0..n as u64).map(point).collect()
}

fn sort_points(points: &mut [(u64, [f64; 2])]) {
    points.sort_unstable_by(|(_, [ax, ay]), (_, [bx, by])| ay.total_cmp(by).then(ax.total_cmp(bx)));
}

//! The call in Rust that `peers.py` compares the package with: reads points and edges, triangulates once, and prints
//! the seconds of the processor and the bytes that the call took at its peak. (Where the system does not tell the
//! processor's time, it is that of the clock.)

use std::env::args;
use std::fs;
use std::time::Instant;

use sweep_cdt::triangulate;

fn main() {
    let [points, edges] = [1, 2].map(|at| args().nth(at).expect("files of points and of edges"));
    let points = read(&points, f64::from_le_bytes);
    let whole = |bytes| usize::try_from(u64::from_le_bytes(bytes)).expect("a position");
    let edges = read(&edges, whole);
    // Where the system lets it, the peak of the memory begins anew.
    let _ = fs::write("/proc/self/clear_refs", "5");
    let before = peak();
    let (start, started) = (Instant::now(), processor());
    let result = triangulate(&points, &edges).expect("an input that is accepted");
    let elapsed = start.elapsed().as_secs_f64();
    let seconds = processor()
        .zip(started)
        .map_or(elapsed, |(end, start)| end - start);
    println!("{seconds} {} {}", peak() - before, result.len());
}

/// The pairs of numbers in a file.
fn read<T: Copy>(path: &str, number: impl Fn([u8; 8]) -> T) -> Vec<[T; 2]> {
    let bytes = fs::read(path).expect("a file");
    let numbers: Vec<T> = bytes
        .as_chunks::<8>()
        .0
        .iter()
        .map(|&b| number(b))
        .collect();
    numbers.as_chunks::<2>().0.to_vec()
}

/// The most bytes that the process has held in memory; 0 where that is not told.
fn peak() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes =
        line.and_then(|line| line.trim().strip_suffix(" kB")?.trim().parse::<u64>().ok());
    kilobytes.unwrap_or(0) * 1024
}

/// The seconds that the processor has spent on this thread.
fn processor() -> Option<f64> {
    let text = fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    let nanoseconds: f64 = text.split(' ').next()?.parse().ok()?;
    Some(nanoseconds / 1e9)
}

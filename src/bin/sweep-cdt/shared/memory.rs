//! Whether there is memory for the work ahead.
//!
//! An allocation that fails ends a process without a word of its own. So before much is allocated its size
//! is compared with what the limit of the address space (`ulimit -v`) leaves, where Linux tells. The size
//! is that of measured runs: what takes more can still fail.

/// Bytes that the sweep takes for a point and for an edge.
const POINT: u64 = 96;
const EDGE: u64 = 24;

/// The bytes that a triangulation of so many points and edges takes beside them, on one thread.
pub(crate) fn of_triangulation(points: usize, edges: usize) -> u64 {
    points as u64 * POINT + edges as u64 * EDGE
}

/// The same on many threads.
pub(crate) fn of_bands(points: usize, edges: usize) -> u64 {
    of_triangulation(points, edges) * 3 / 2
}

/// Whether so many bytes can be allocated.
pub(crate) fn has_room(bytes: u64) -> bool {
    room().is_none_or(|room| bytes <= room)
}

/// The bytes that the limit leaves, if there is one.
#[cfg(target_os = "linux")]
fn room() -> Option<u64> {
    use rustix::process::{Resource, getrlimit};
    let limit = getrlimit(Resource::As).current?;
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let used = status
        .lines()
        .find_map(|line| line.strip_prefix("VmSize:"))?;
    let kilobytes: u64 = used.trim().strip_suffix(" kB")?.trim().parse().ok()?;
    Some(limit.saturating_sub(kilobytes * 1024))
}

#[cfg(not(target_os = "linux"))]
fn room() -> Option<u64> {
    None
}

//! Whether there is memory for the work ahead.
//!
//! An allocation that fails ends the process. So before much is allocated whose size is known, as much is asked for at
//! once, in a way that may fail, and given back. The answer is no promise: other threads and processes may take the
//! memory meanwhile, and some systems give more than they have.

use alloc::vec::Vec;
use core::hint::black_box;

use crate::error::Error;
use crate::tuning::LARGE_BLOCK;

/// Bytes that the sweep takes for a point and for an edge.
const POINT: usize = 96;
const EDGE: usize = 24;

/// The bytes that a triangulation of so many points and edges takes beside them, on one thread.
pub fn of_triangulation(points: usize, edges: usize) -> usize {
    let points = points.saturating_mul(POINT);
    points.saturating_add(edges.saturating_mul(EDGE))
}

/// The bytes that a triangulation on many threads takes.
pub fn of_bands(points: usize, edges: usize) -> usize {
    let bytes = of_triangulation(points, edges);
    bytes.saturating_add(bytes / 2)
}

/// Whether so many bytes can be allocated.
pub fn has_room(bytes: usize) -> bool {
    // What the compiler sees to be unused it may leave out.
    bytes < LARGE_BLOCK
        || black_box(&mut Vec::<u8>::new())
            .try_reserve_exact(bytes)
            .is_ok()
}

/// Refuses what there is no memory for.
pub(crate) fn expect_room(bytes: usize) -> Result<(), Error> {
    if has_room(bytes) {
        Ok(())
    } else {
        Err(Error::OutOfMemory { bytes })
    }
}

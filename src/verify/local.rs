//! The two passes over all triangles: each turns left, and each free side is locally Delaunay. They
//! run in chunks, on one thread or on all of a rayon pool.

use std::cmp::Ordering;
use std::ops::Range;
#[cfg(feature = "parallel")]
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

#[cfg(feature = "parallel")]
use rayon::prelude::*;

use super::Verifier;
use super::findings::Findings;
use super::input::Mesh;
use super::report::Violation;
use super::sides::{FIXED, NONE};
use super::signs::Tally;
use crate::scalar::Scalar;

/// Triangles in a chunk.
const CHUNK: usize = 1 << 14;

/// Which pass.
#[derive(Clone, Copy, Debug)]
pub(super) enum Pass<'a> {
    Turns,
    /// With what lies across each side.
    Sides(&'a [u32]),
}

/// What a pass finds in a chunk.
#[derive(Debug)]
pub(super) struct Part {
    pub(super) tally: Tally,
    /// Triangles that do not turn left.
    pub(super) bad: Vec<(u32, Ordering)>,
    pub(super) findings: Findings,
    pub(super) free: usize,
    pub(super) cocircular: usize,
    pub(super) uncanonical: usize,
}

/// How to run a pass over all chunks; a type of its own so that scalars that may not be shared
/// between threads need not be.
pub(super) type Run<S> = fn(&Mesh<'_, S>, Pass<'_>, &Verifier<'_>) -> Vec<Part>;

/// One chunk after the other.
pub(super) fn serial<S: Scalar>(
    mesh: &Mesh<'_, S>,
    pass: Pass<'_>,
    options: &Verifier<'_>,
) -> Vec<Part> {
    let chunks = 0..mesh.triangles.len().div_ceil(CHUNK);
    chunks
        .map(|chunk| {
            let part = mesh.chunk(pass, chunk, options);
            options.report_progress(mesh, pass, CHUNK * (chunk + 1));
            part
        })
        .collect()
}

/// On all threads of the current rayon pool.
#[cfg(feature = "parallel")]
pub(super) fn parallel<S: Scalar + Sync>(
    mesh: &Mesh<'_, S>,
    pass: Pass<'_>,
    options: &Verifier<'_>,
) -> Vec<Part> {
    let done = AtomicUsize::new(0);
    let chunks = 0..mesh.triangles.len().div_ceil(CHUNK);
    chunks
        .into_par_iter()
        .map(|chunk| {
            let part = mesh.chunk(pass, chunk, options);
            options.report_progress(mesh, pass, done.fetch_add(CHUNK, Relaxed) + CHUNK);
            part
        })
        .collect()
}

impl<S: Scalar> Mesh<'_, S> {
    fn chunk(&self, pass: Pass<'_>, chunk: usize, options: &Verifier<'_>) -> Part {
        let range = chunk * CHUNK..self.triangles.len().min((chunk + 1) * CHUNK);
        let mut part = Part {
            tally: Tally::default(),
            bad: Vec::new(),
            findings: Findings::new(options.limit),
            free: 0,
            cocircular: 0,
            uncanonical: 0,
        };
        match pass {
            Pass::Turns => self.check_turns(range, &mut part),
            Pass::Sides(twin) => self.check_sides(twin, range, &mut part),
        }
        part
    }

    fn check_turns(&self, range: Range<usize>, part: &mut Part) {
        let first = u32::try_from(range.start).expect("the size was checked");
        for (t, &triangle) in (first..).zip(&self.triangles[range]) {
            if triangle[0] == NONE {
                continue;
            }
            let turn = self.signs.orient2d(triangle, &mut part.tally);
            if turn != Ordering::Greater {
                part.bad.push((t, turn));
            }
        }
    }

    fn check_sides(&self, twin: &[u32], range: Range<usize>, part: &mut Part) {
        for t in range {
            let triangle = self.triangles[t];
            for i in 0..3 {
                let twin = twin[3 * t + i];
                // Each side once, from the triangle with the higher number.
                if twin >= FIXED || twin as usize > 3 * t + i {
                    continue;
                }
                let (u, twin) = (twin as usize / 3, twin as usize);
                let ([a, b, c], d) = (
                    [triangle[i], triangle[(i + 1) % 3], triangle[(i + 2) % 3]],
                    self.triangles[u][(twin + 2) % 3],
                );
                part.free += 1;
                match self.signs.in_circle([a, b, c, d], &mut part.tally) {
                    Ordering::Less => {}
                    Ordering::Equal => {
                        part.cocircular += 1;
                        let leftmost = |v, w| {
                            if self.signs.is_left_or_above(v, w) {
                                v
                            } else {
                                w
                            }
                        };
                        let of_side = leftmost(a, b);
                        if leftmost(leftmost(c, d), of_side) != of_side {
                            part.uncanonical += 1;
                        }
                    }
                    Ordering::Greater => part.findings.add(Violation::NotDelaunay {
                        side: [a, b].map(|v| self.signs.name(v)),
                        triangles: [t, u],
                        opposite: [c, d].map(|v| self.signs.name(v)),
                    }),
                }
            }
        }
    }
}

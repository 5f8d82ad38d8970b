//! Check 3: every half-edge, a side of a triangle in its direction, occurs once.
//!
//! ```text
//!              c
//!            /   \
//!          /   t   \
//!        a -- 3t --> b        Side 3 t + i runs from corner i of triangle t to the next corner.
//!        a <- 3u+j - b        Its *twin* is the same side as the neighbour u has it.
//!          \   u   /          A side without a twin is on the boundary.
//!            \   /
//!              d
//! ```
//!
//! Twins are found by sorting: each side goes into the bucket of its end of lower rank, each bucket is sorted by the
//! other end, and then the two triangles of a side are next to each other. Most buckets hold a few sides.
//! Cost: three passes, and a binary search for each side that is asked for.

use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

use super::report::Record;
use super::soup::Soup;
use super::violation::Violation;
use crate::scalar::Scalar;

/// In place of a twin: there is no triangle on the right of the side.
const OPEN: u32 = u32::MAX;
/// In place of a twin: the side is constrained, a piece of an input edge, so it need not be Delaunay.
const FIXED: u32 = u32::MAX - 1;

/// The bit of an entry that is set if the side starts at its end of higher rank.
const DOWNWARD: u64 = 1 << 31;

/// The sides of all triangles.
#[derive(Debug)]
pub(super) struct Sides {
    /// For each side its twin, [`OPEN`] or [`FIXED`].
    twin: Vec<u32>,
    /// The sides that have a triangle on their left only.
    pub(super) boundary: Vec<u32>,
    /// The bucket of the vertex of rank `v` is `entries[starts[v]..starts[v + 1]]`. An entry is the other
    /// end in the upper 32 bits, then [`DOWNWARD`] or not, then the side.
    starts: Vec<u32>,
    entries: Vec<u64>,
}

/// Matches the sides. Two triangles on the same side of one are reported, and their sides have no twins.
pub(super) fn check<S: Scalar>(soup: &Soup<'_, S>, record: &mut Record) -> Sides {
    let (starts, mut entries) = buckets(soup);
    let mut twin = vec![OPEN; 3 * soup.triangles.len()];
    let (mut boundary, mut repeated) = (Vec::new(), Vec::new());
    for ends in starts.windows(2) {
        let bucket = &mut entries[ends[0] as usize..ends[1] as usize];
        bucket.sort_unstable();
        for same in bucket.chunk_by(|a, b| a >> 32 == b >> 32) {
            match *same {
                [a, b] if (a ^ b) & DOWNWARD != 0 => {
                    twin[side(a) as usize] = side(b);
                    twin[side(b) as usize] = side(a);
                }
                [a] => boundary.push(side(a)),
                _ => repeated.extend(self::repeated(soup, same)),
            }
        }
    }
    repeated.sort_by_key(|&(triangles, _)| triangles);
    for (triangles, side) in repeated {
        let violation = Violation::RepeatedSide { side, triangles };
        record.findings.add(violation);
    }
    record.report.boundary_sides = boundary.len();
    Sides {
        twin,
        boundary,
        starts,
        entries,
    }
}

impl Sides {
    /// The twin of a side that is free: neither on the boundary nor constrained.
    pub(super) fn free_twin(&self, side: usize) -> Option<usize> {
        let twin = self.twin[side];
        (twin < FIXED).then_some(twin as usize)
    }

    /// Constrains the side between two vertices. Returns whether that is new; `None` if there is no such side.
    pub(super) fn fix(&mut self, a: u32, b: u32) -> Option<bool> {
        let mut is_new = None;
        for &entry in between(&self.starts, &self.entries, [a, b]) {
            let twin = &mut self.twin[side(entry) as usize];
            // All triangles with this side were marked at once, however many there are.
            if *twin == FIXED {
                return Some(false);
            }
            *twin = FIXED;
            is_new = Some(true);
        }
        is_new
    }

    /// The corner opposite to the side from one vertex to another in the triangle on its left, if there is one.
    pub(super) fn apex<S: Scalar>(&self, soup: &Soup<'_, S>, from: u32, to: u32) -> Option<u32> {
        let downward = if to < from { DOWNWARD } else { 0 };
        let mut same = between(&self.starts, &self.entries, [from, to]).iter();
        let side = side(*same.find(|&&entry| entry & DOWNWARD == downward)?) as usize;
        Some(soup.triangles[side / 3][(side + 2 - side / 3 * 3) % 3])
    }

    /// For each vertex where its neighbours begin, and the neighbours of all vertices in one array.
    pub(super) fn neighbors(&self) -> (Vec<u32>, Vec<u32>) {
        let count = u32::try_from(self.starts.len() - 1).expect("ranks fit");
        let bucket = |v| &self.entries[range(&self.starts, v)];
        let pairs = || {
            let distinct = move |v| bucket(v).chunk_by(|a, b| a >> 32 == b >> 32);
            (0..count).flat_map(move |v| distinct(v).map(move |same| (v, other_end(same[0]))))
        };
        let both = || pairs().flat_map(|(a, b)| [(a, b), (b, a)]);
        grouped(both, count as usize)
    }
}

/// The range of a vertex's values.
pub(super) fn range(starts: &[u32], v: u32) -> Range<usize> {
    starts[v as usize] as usize..starts[v as usize + 1] as usize
}

/// The entries of the side between two vertices, of both directions.
fn between<'a>(starts: &[u32], entries: &'a [u64], [a, b]: [u32; 2]) -> &'a [u64] {
    let bucket = &entries[range(starts, a.min(b))];
    let rest = &bucket[bucket.partition_point(|&entry| other_end(entry) < a.max(b))..];
    &rest[..rest.partition_point(|&entry| other_end(entry) == a.max(b))]
}

fn side(entry: u64) -> u32 {
    low_half(entry & (DOWNWARD - 1))
}

fn other_end(entry: u64) -> u32 {
    low_half(entry >> 32)
}

#[expect(clippy::cast_possible_truncation, reason = "the upper half is cleared")]
fn low_half(x: u64) -> u32 {
    x as u32
}

/// Puts each side of each triangle into the bucket of its end of lower rank.
fn buckets<S: Scalar>(soup: &Soup<'_, S>) -> (Vec<u32>, Vec<u64>) {
    let sides = || {
        soup.accepted().flat_map(|(t, [a, b, c])| {
            let first = 3 * t;
            [(a, b, first), (b, c, first + 1), (c, a, first + 2)]
        })
    };
    let entries = || {
        sides().map(|(from, to, side)| {
            let downward = if to < from { DOWNWARD } else { 0 };
            let entry = u64::from(from.max(to)) << 32 | downward | u64::from(side);
            (from.min(to), entry)
        })
    };
    grouped(entries, soup.vertices() as usize)
}

/// Counting sort by vertex: where the values of each vertex begin, and all values.
pub(super) fn grouped<T, I>(pairs: impl Fn() -> I, vertices: usize) -> (Vec<u32>, Vec<T>)
where
    T: Copy + Default,
    I: Iterator<Item = (u32, T)>,
{
    let mut starts = vec![0; vertices + 1];
    for (v, _) in pairs() {
        starts[v as usize] += 1;
    }
    let mut total = 0;
    for start in &mut starts {
        total += *start;
        *start = total;
    }
    let mut values = vec![T::default(); total as usize];
    for (v, value) in pairs() {
        let start = &mut starts[v as usize];
        *start -= 1;
        values[*start as usize] = value;
    }
    (starts, values)
}

/// Pairs of triangles on one side of a side, with the side; `same` are all sides with one pair of ends.
#[cold]
fn repeated<S: Scalar>(soup: &Soup<'_, S>, same: &[u64]) -> Vec<([usize; 2], [usize; 2])> {
    let mut repeated = Vec::new();
    for direction in same.chunk_by(|a, b| (a ^ b) & DOWNWARD == 0) {
        let sides = direction.iter().map(|&entry| side(entry));
        let mut triangles: Vec<(usize, u32)> = sides
            .map(|side| (soup.number(side as usize / 3), side))
            .collect();
        triangles.sort_unstable();
        for &(again, _) in &triangles[1..] {
            let (first, side) = triangles[0];
            repeated.push(([first, again], soup.names(soup.side(side))));
        }
    }
    repeated
}

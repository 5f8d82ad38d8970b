//! The sides of the triangles, matched by counting: each side is filed under its end of lower rank,
//! each small file is sorted by the other end, and then the two triangles of a side are neighbours.
//!
//! Side `3 t + i` runs from corner `i` of triangle `t` to the next one. Cost: three passes.

use std::ops::Range;

use super::findings::Findings;
use super::input::Mesh;
use super::report::Violation;

/// No triangle.
pub(super) const NONE: u32 = u32::MAX;
/// In place of a twin: nothing lies across the side, ...
pub(super) const OPEN: u32 = u32::MAX;
/// ... or the side is constrained.
pub(super) const FIXED: u32 = u32::MAX - 1;
/// How many sides can be numbered.
pub(super) const LIMIT: usize = 1 << 31;

const DOWNWARD: u64 = 1 << 31;

/// All sides.
#[derive(Debug)]
pub(super) struct Sides {
    /// For each side the one of the neighbour triangle, [`OPEN`] or [`FIXED`].
    pub(super) twin: Vec<u32>,
    /// The sides that have a triangle on their left only.
    pub(super) boundary: Vec<u32>,
    /// Of the vertex of rank `v`, `files[starts[v]..starts[v + 1]]`: the other end in the upper half,
    /// then a bit that is set if the side starts at the other end, then the side.
    starts: Vec<u32>,
    files: Vec<u64>,
}

impl Sides {
    /// Matches the sides; reports two triangles on the same side of one, and leaves those unmatched.
    pub(super) fn new<S>(mesh: &Mesh<'_, S>, findings: &mut Findings) -> Sides {
        let (starts, mut files) = filed(&mesh.triangles, mesh.signs.vertex.len());
        let mut twin = vec![OPEN; 3 * mesh.triangles.len()];
        let mut boundary = Vec::new();
        for ends in starts.windows(2) {
            let file = &mut files[ends[0] as usize..ends[1] as usize];
            file.sort_unstable();
            for same in file.chunk_by(|a, b| a >> 32 == b >> 32) {
                match *same {
                    [a, b] if (a ^ b) & DOWNWARD != 0 => {
                        twin[side(a) as usize] = side(b);
                        twin[side(b) as usize] = side(a);
                    }
                    [a] => boundary.push(side(a)),
                    _ => repeated(mesh, same, findings),
                }
            }
        }
        Sides {
            twin,
            boundary,
            starts,
            files,
        }
    }

    /// Marks the side between two vertices as fixed; says whether there is one, and whether it was not
    /// fixed before.
    pub(super) fn fix(&mut self, a: u32, b: u32) -> Option<bool> {
        let (low, high) = (a.min(b), a.max(b));
        let mut is_new = None;
        for &key in &self.files[range(&self.starts, low)] {
            if other(key) == high {
                let twin = &mut self.twin[side(key) as usize];
                is_new = Some(*twin != FIXED || is_new == Some(true));
                *twin = FIXED;
            }
        }
        is_new
    }

    fn file(&self, v: u32) -> &[u64] {
        &self.files[range(&self.starts, v)]
    }

    /// For each vertex the others to which a side leads, in one array, and where each begins.
    pub(super) fn neighbors(&self) -> (Vec<u32>, Vec<u32>) {
        let count = u32::try_from(self.starts.len() - 1).expect("ranks fit");
        let pairs = || {
            let distinct = |v| self.file(v).chunk_by(|a, b| a >> 32 == b >> 32);
            (0..count).flat_map(move |v| distinct(v).map(move |same| (v, other(same[0]))))
        };
        let both = || pairs().flat_map(|(a, b)| [(a, b), (b, a)]);
        grouped(both, count as usize)
    }
}

/// Where the values of a vertex are.
pub(super) fn range(starts: &[u32], v: u32) -> Range<usize> {
    starts[v as usize] as usize..starts[v as usize + 1] as usize
}

fn side(key: u64) -> u32 {
    low_half(key & (DOWNWARD - 1))
}

fn other(key: u64) -> u32 {
    low_half(key >> 32)
}

#[expect(clippy::cast_possible_truncation, reason = "the upper half is cleared")]
fn low_half(x: u64) -> u32 {
    x as u32
}

/// Files each side of each triangle under its end of lower rank.
fn filed(triangles: &[[u32; 3]], vertices: usize) -> (Vec<u32>, Vec<u64>) {
    let sides = || {
        (0u32..)
            .step_by(3)
            .zip(triangles)
            .filter(|(_, t)| t[0] != NONE)
            .flat_map(|(first, t)| {
                [
                    (t[0], t[1], first),
                    (t[1], t[2], first + 1),
                    (t[2], t[0], first + 2),
                ]
            })
    };
    grouped(
        || {
            sides().map(|(from, to, side)| {
                let downward = if to < from { DOWNWARD } else { 0 };
                let key = u64::from(from.max(to)) << 32 | downward | u64::from(side);
                (from.min(to), key)
            })
        },
        vertices,
    )
}

/// Counting sort: the values of each vertex together, and where each vertex begins.
fn grouped<T, I>(pairs: impl Fn() -> I, vertices: usize) -> (Vec<u32>, Vec<T>)
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

/// More than one triangle on the left or on the right of a side.
#[cold]
fn repeated<S>(mesh: &Mesh<'_, S>, same: &[u64], findings: &mut Findings) {
    for direction in same.chunk_by(|a, b| (a ^ b) & DOWNWARD == 0) {
        for &key in &direction[1..] {
            let [first, again] = [direction[0], key].map(side);
            findings.add(Violation::RepeatedSide {
                side: mesh
                    .side(first)
                    .map(|v| mesh.signs.vertex[v as usize] as usize),
                triangles: [first as usize / 3, again as usize / 3],
            });
        }
    }
}

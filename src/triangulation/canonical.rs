//! Triangles in canonical order: each begins with its lowest vertex, and the list is sorted.
//!
//! Each chunk is put in order by *groups* of lowest vertices, then each group, from all chunks, by lowest vertex, so
//! most random writes stay in cache. Last, triangles with the same lowest vertex are sorted. All cores share the work.
//!
//! Why it is right: groups follow each other in the order of the vertices. Where the sample misses high vertices, the
//! last group has them all, which costs time only. Cost: O(n + v) for n triangles and highest vertex v, and the sorts.

use alloc::vec;
use alloc::vec::Vec;
use core::mem::take;

use crate::bucket::sampled;
use crate::threads::on_all_cores;
use crate::tuning::{CHUNK_OF_GROUPS, GROUPS_OF_CHUNKS, SAMPLE_OF_GROUPS};

/// A triangle whose first vertex is the lowest.
type Listed = [u32; 3];

/// The triangles of a chunk by groups, where each group begins, and where the last one ends.
#[derive(Debug)]
struct Chunk {
    list: Vec<Listed>,
    begins: Vec<usize>,
}

/// `count` triangles in canonical order; `triangle` gives each by its number.
pub(crate) fn canonical(
    count: usize,
    triangle: impl Fn(usize) -> Listed + Sync + Send,
) -> Vec<[usize; 3]> {
    let groups = if count <= CHUNK_OF_GROUPS {
        1
    } else {
        GROUPS_OF_CHUNKS
    };
    let listed = |t: usize| lowest_first(triangle(t));
    let lowest = sampled(count, SAMPLE_OF_GROUPS).map(|t| listed(t)[0]);
    let wide = lowest.max().unwrap_or(0) as usize / groups;
    // A group has two to the power of `bits` vertices; the last group has all higher ones, too.
    let bits = usize::BITS - wide.leading_zeros();
    let group = |listed: &Listed| (listed[0] as usize >> bits).min(groups - 1);
    let chunks: Vec<usize> = (0..count).step_by(CHUNK_OF_GROUPS).collect();
    let chunks = on_all_cores(chunks, |at| {
        let chunk: Vec<Listed> = (at..count.min(at + CHUNK_OF_GROUPS)).map(listed).collect();
        by_group(&chunk, groups, group)
    });
    let mut list = vec![[0; 3]; count];
    let mut rest = &mut list[..];
    let part = |group| {
        let size = chunks.iter().map(|chunk| chunk.of_group(group).len()).sum();
        let (part, others) = take(&mut rest).split_at_mut(size);
        rest = others;
        (group, part)
    };
    let parts = (0..groups).map(part).collect();
    on_all_cores(parts, |(group, part)| {
        let listed = chunks.iter().flat_map(|chunk| chunk.of_group(group));
        by_vertex(listed, group << bits, part, &mut Vec::new());
    });
    list
}

/// Memory for [`canonical_into`].
#[derive(Debug, Default)]
pub(crate) struct CanonicalBuffers {
    listed: Vec<Listed>,
    places: Vec<usize>,
}

/// Sets `list` to `count` triangles in canonical order; `triangle` gives each by its number.
pub(crate) fn canonical_into(
    list: &mut Vec<[usize; 3]>,
    count: usize,
    triangle: impl Fn(usize) -> Listed,
    buffers: &mut CanonicalBuffers,
) {
    let CanonicalBuffers { listed, places } = buffers;
    listed.clear();
    listed.extend((0..count).map(|t| lowest_first(triangle(t))));
    list.clear();
    list.resize(count, [0; 3]);
    by_vertex(listed.iter(), 0, list, places);
}

impl Chunk {
    fn of_group(&self, group: usize) -> &[Listed] {
        &self.list[self.begins[group]..self.begins[group + 1]]
    }
}

fn by_group(chunk: &[Listed], groups: usize, group: impl Fn(&Listed) -> usize) -> Chunk {
    let mut begins = Vec::new();
    set_begins(chunk.iter().map(&group), groups, &mut begins);
    let mut list = vec![[0; 3]; chunk.len()];
    let mut places = begins.clone();
    for listed in chunk {
        let place = &mut places[group(listed)];
        list[*place] = *listed;
        *place += 1;
    }
    Chunk { list, begins }
}

/// Puts the triangles of a group in their order; none begins with a vertex below `first`. `places` is a buffer.
fn by_vertex<'a>(
    listed: impl Iterator<Item = &'a Listed> + Clone,
    first: usize,
    part: &mut [[usize; 3]],
    places: &mut Vec<usize>,
) {
    let vertex = |listed: &Listed| listed[0] as usize - first;
    let vertices = listed.clone().map(vertex).max().map_or(0, |v| v + 1);
    set_begins(listed.clone().map(vertex), vertices, places);
    for listed in listed {
        let place = &mut places[vertex(listed)];
        part[*place] = listed.map(|v| v as usize);
        *place += 1;
    }
    for same in part.chunk_by_mut(|a, b| a[0] == b[0]) {
        same.sort_unstable();
    }
}

/// Exclusive prefix sum: where the items of each kind begin, once in order, and where the last ones end.
fn set_begins(kinds: impl Iterator<Item = usize>, count: usize, begins: &mut Vec<usize>) {
    begins.clear();
    begins.resize(count + 1, 0);
    for kind in kinds {
        begins[kind + 1] += 1;
    }
    for kind in 0..count {
        begins[kind + 1] += begins[kind];
    }
}

/// The triangle with its lowest vertex first; without branches, which the processor could not predict.
fn lowest_first([a, b, c]: Listed) -> Listed {
    let first = usize::from((b < a) & (b < c)) + 2 * usize::from((c < a) & (c < b));
    let twice = [a, b, c, a, b];
    [0, 1, 2].map(|i| twice[first + i])
}

#[cfg(test)]
mod tests {
    use super::{CHUNK_OF_GROUPS, SAMPLE_OF_GROUPS, canonical};
    use crate::bucket::sampled;
    use crate::ids::narrow;

    /// Against triangles turned and sorted as a whole: none, a few, and several chunks, of vertices that are spread
    /// evenly, few, or all low but for some that are in no sample.
    #[test]
    fn as_turned_and_sorted() {
        for count in [
            0,
            1,
            2,
            5,
            CHUNK_OF_GROUPS - 1,
            CHUNK_OF_GROUPS,
            CHUNK_OF_GROUPS + 1,
            3 * CHUNK_OF_GROUPS + 17,
        ] {
            for vertices in [3, 1000, 1 << 20] {
                let is_far = |t: usize| t % 50_000 == 49_999;
                assert!(!sampled(count, SAMPLE_OF_GROUPS).any(is_far) || count <= CHUNK_OF_GROUPS);
                let vertex = |t: usize, corner: usize| {
                    let spread = narrow(t * 3 + corner).wrapping_mul(0x9E37_79B9) as usize >> 10;
                    let far = if is_far(t) { 1 << 22 } else { 0 };
                    far + 3 * (spread % vertices) + corner
                };
                let triangle = |t: usize| [0, 1, 2].map(|i| vertex(t, (t + i) % 3));
                let mut expected: Vec<[usize; 3]> = (0..count).map(triangle).collect();
                for corners in &mut expected {
                    while corners[0] != corners[0].min(corners[1]).min(corners[2]) {
                        corners.rotate_left(1);
                    }
                }
                expected.sort_unstable();
                assert_eq!(
                    canonical(count, |t| triangle(t).map(narrow)),
                    expected,
                    "{count} of {vertices}"
                );
            }
        }
    }
}

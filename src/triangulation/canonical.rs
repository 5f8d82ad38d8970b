//! Triangles in canonical order: each begins with its lowest vertex, and the list is sorted.
//!
//! A counting sort puts triangles in the order of their lowest vertices; then those with the same lowest vertex, which
//! are few, are sorted. Many triangles are put into *groups* of lowest vertices first, so that random writes stay in
//! cache. All cores share the groups. Cost: O(n + v) for n triangles and highest vertex v, and the sorts.

use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

use crate::threads::on_all_cores;

/// More triangles are put into groups first.
const FEW: usize = 1 << 16;
/// At most 2 to this power groups are made. Fewer would not fit in the cache; more would scatter triangles too widely.
const GROUP_BITS: u32 = 8;

/// `count` triangles in canonical order; `triangle` gives each by its number.
pub(crate) fn canonical(count: usize, triangle: impl Fn(usize) -> [u32; 3]) -> Vec<[usize; 3]> {
    let mut list = Vec::new();
    canonical_into(&mut list, count, triangle, &mut CanonicalBuffers::default());
    list
}

/// Memory for [`canonical_into`].
#[derive(Debug, Default)]
pub(crate) struct CanonicalBuffers {
    /// The triangles, each with its lowest vertex first.
    turned: Vec<[u32; 3]>,
    places: Vec<u32>,
}

/// Sets `list` to `count` triangles in canonical order; `triangle` gives each by its number.
pub(crate) fn canonical_into(
    list: &mut Vec<[usize; 3]>,
    count: usize,
    triangle: impl Fn(usize) -> [u32; 3],
    CanonicalBuffers { turned, places }: &mut CanonicalBuffers,
) {
    turned.clear();
    turned.extend((0..count).map(|t| lowest_first(triangle(t))));
    let most = turned.iter().map(|triangle| triangle[0]).max().unwrap_or(0);
    list.clear();
    if count <= FEW {
        list.resize(count, [0; 3]);
        return by_vertex(turned, 0..most + 1, list, places);
    }
    let bits = (u32::BITS - most.leading_zeros()).saturating_sub(GROUP_BITS);
    let mut grouped = vec![[0; 3]; count];
    by_key(
        turned,
        0..(most >> bits) + 1,
        |v| v >> bits,
        places,
        |at, triangle| {
            grouped[at] = triangle;
        },
    );
    *turned = Vec::new();
    list.resize(count, [0; 3]);
    let (mut group, mut part) = (&grouped[..], &mut list[..]);
    let mut begin = 0;
    let parts = (0..).zip(&*places).map(|(number, &end)| {
        let size = (end - begin) as usize;
        begin = end;
        let (here, others) = group.split_at(size);
        let (list, rest) = core::mem::take(&mut part).split_at_mut(size);
        (group, part) = (others, rest);
        (number << bits, here, list)
    });
    on_all_cores(parts.collect(), |(first, group, list)| {
        by_vertex(group, first..first + (1 << bits), list, &mut Vec::new());
    });
}

/// Puts triangles whose lowest vertices are in a range in their order. `places` is a buffer.
fn by_vertex(
    turned: &[[u32; 3]],
    lowest: Range<u32>,
    list: &mut [[usize; 3]],
    places: &mut Vec<u32>,
) {
    by_key(
        turned,
        lowest,
        |v| v,
        places,
        |at, triangle| {
            list[at] = triangle.map(|v| v as usize);
        },
    );
    for same in list.chunk_by_mut(|a, b| a[0] == b[0]) {
        same.sort_unstable();
    }
}

/// Gives to `put` the place of each triangle in the order of the keys of lowest vertices, which are in a range. Sets
/// `places` to where the triangles of each key end.
fn by_key(
    turned: &[[u32; 3]],
    keys: Range<u32>,
    key: impl Fn(u32) -> u32,
    places: &mut Vec<u32>,
    mut put: impl FnMut(usize, [u32; 3]),
) {
    let place = |triangle: &[u32; 3]| (key(triangle[0]) - keys.start) as usize;
    places.clear();
    places.resize(keys.len(), 0);
    for triangle in turned {
        places[place(triangle)] += 1;
    }
    let mut sum = 0;
    for place in &mut *places {
        (*place, sum) = (sum, sum + *place);
    }
    for triangle in turned {
        let place = &mut places[place(triangle)];
        put(*place as usize, *triangle);
        *place += 1;
    }
}

/// The triangle with its lowest vertex first; without branches, which the processor could not predict.
fn lowest_first([a, b, c]: [u32; 3]) -> [u32; 3] {
    let first = usize::from((b < a) & (b < c)) + 2 * usize::from((c < a) & (c < b));
    let twice = [a, b, c, a, b];
    [0, 1, 2].map(|i| twice[first + i])
}

#[cfg(test)]
mod tests {
    use super::{FEW, canonical};
    use crate::ids::narrow;

    /// Against triangles turned and sorted as a whole: none, a few, and several groups, of vertices that are few, or spread
    /// evenly.
    #[test]
    fn as_turned_and_sorted() {
        for count in [0, 1, 2, 5, FEW, FEW + 1, 3 * FEW + 17] {
            for vertices in [3, 1000, 1 << 20] {
                let vertex = |t: usize, corner: usize| {
                    let spread = narrow(t * 3 + corner).wrapping_mul(0x9E37_79B9) >> 10;
                    3 * (spread % vertices) + narrow(corner)
                };
                let triangle = |t: usize| [0, 1, 2].map(|i| vertex(t, (t + i) % 3));
                let turned = |t| {
                    let mut corners = triangle(t).map(|v| v as usize);
                    while corners[0] != corners[0].min(corners[1]).min(corners[2]) {
                        corners.rotate_left(1);
                    }
                    corners
                };
                let mut expected: Vec<[usize; 3]> = (0..count).map(turned).collect();
                expected.sort_unstable();
                let found = canonical(count, triangle);
                assert_eq!(found, expected, "{count} of {vertices}");
            }
        }
    }
}

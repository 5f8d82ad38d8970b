//! Triangles in canonical order: each begins with its lowest vertex, and the list is sorted.
//!
//! A counting sort puts triangles in the order of their lowest vertices; then those with the same lowest vertex, which
//! are few, are sorted. Cost: O(n + v) for n triangles and highest vertex v, and the sorts.

use alloc::vec::Vec;

/// `count` triangles in canonical order; `triangle` gives each by its number, and is called twice for it.
pub(crate) fn canonical(count: usize, triangle: impl Fn(usize) -> [u32; 3]) -> Vec<[usize; 3]> {
    let mut list = Vec::new();
    let turned = (0..count).map(|t| lowest_first(triangle(t)));
    sort(turned, &mut list, &mut Vec::new());
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
    sort(turned.iter().copied(), list, places);
}

/// Sets `list` to triangles, of which each begins with its lowest vertex. `places` is a buffer.
fn sort(
    turned: impl ExactSizeIterator<Item = [u32; 3]> + Clone,
    list: &mut Vec<[usize; 3]>,
    places: &mut Vec<u32>,
) {
    // How many triangles each lowest vertex has, and then where the next one of them goes.
    places.clear();
    for [lowest, ..] in turned.clone() {
        let lowest = lowest as usize;
        if lowest >= places.len() {
            places.resize(lowest + 1, 0);
        }
        places[lowest] += 1;
    }
    let mut sum = 0;
    for place in &mut *places {
        (*place, sum) = (sum, sum + *place);
    }
    list.clear();
    list.resize(turned.len(), [0; 3]);
    for triangle in turned {
        let place = &mut places[triangle[0] as usize];
        list[*place as usize] = triangle.map(|v| v as usize);
        *place += 1;
    }
    for same in list.chunk_by_mut(|a, b| a[0] == b[0]) {
        same.sort_unstable();
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
    use super::canonical;
    use crate::ids::narrow;

    /// Against triangles turned and sorted as a whole, of vertices that are few, or spread evenly.
    #[test]
    fn as_turned_and_sorted() {
        for count in [0, 1, 2, 5, 10_000] {
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

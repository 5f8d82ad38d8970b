//! The sweep order of section 3.3: by y, then x, exactly.
//!
//! The points are spread over *buckets* of y, each of some hundred points, or some thousand where there are millions. A
//! bucket is sorted by a finer key of y, by counting ([`super::counting`]). A long run of one key is sorted again by
//! counting, by a still finer key, and a long row of equal y by a key of x. In a short run or row each point goes where
//! as many points come before it. The rest is sorted by exact comparison. Equal points merge into the one of lowest
//! index.
//!
//! Why it is right: no key decreases where its coordinate grows, so points of different keys are in order, and equal
//! points have one key. In a sorted run they are neighbours, and the lowest index comes first.
//!
//! Cost: O(n) where the points spread over y, but for a few far away; O(n log n) at worst. A bucket fits in the cache.
//! Buffers: 44 bytes for each point of the largest bucket, again for each point of the longest run, and of the longest
//! row in a run: 88 bytes a point if all have one y, at worst 132. Differs from the paper: the paper sorts by
//! comparison, and does not say what becomes of equal points.
use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::Vertices;
use super::counting::{CountingSort, Key, begin};
use crate::bucket::{bucket, sampled};
use crate::ids::narrow;
use crate::scalar::{Scalar, Scale};
use crate::tuning::{FAR_OUTSIDE, MOST_BUCKETS, SAMPLE_OF_Y, SHORT_RUN, Tuning, VERY_SHORT_RUN};

#[derive(Debug, Default)]
pub(in crate::sweep) struct SortBuffers {
    /// The end of each bucket's range of points.
    ends: Vec<u32>,
    /// A bucket, a long run of one key in it, and a long row of one y in the run.
    bucket: CountingSort,
    run: CountingSort,
    row: CountingSort,
}

/// Sorts and merges the points with these input indices, which ascend, into `vertices`; `approx` gives the
/// approximations of a point by its input index. The arrays of `vertices` get room for the two artificial points.
pub(super) fn sort<S: Scalar>(
    points: &[[S; 2]],
    inputs: impl ExactSizeIterator<Item = u32> + Clone,
    approx: impl Fn(u32) -> [f64; 2],
    vertices: &mut Vertices,
    buffers: &mut SortBuffers,
    tuning: &Tuning,
) {
    let bucket = tuning.points_in_bucket;
    spread(inputs, approx, bucket, vertices, &mut buffers.ends);
    let exact = |axis: usize, [a, b]: [u32; 2]| {
        let [a, b] = [a, b].map(|input| &points[input as usize][axis]);
        a.compare(b)
    };
    sort_buckets(&exact, vertices, buffers, tuning.short_run);
}

/// The exact order of two points along an axis, by their input indices.
type ExactOrder<'a> = &'a dyn Fn(usize, [u32; 2]) -> Ordering;

/// Sorts and merges the points within each bucket. Compiled once, whatever the scalar.
#[inline(never)]
fn sort_buckets(
    exact: ExactOrder<'_>,
    vertices: &mut Vertices,
    buffers: &mut SortBuffers,
    short: usize,
) {
    let scale = vertices.scale;
    vertices.duplicates.clear();
    let compare = |a: &Key, b: &Key| compare(exact, scale, a, b);
    let by_index = |a: &Key, b: &Key| compare(a, b).then_with(|| a.1.cmp(&b.1));
    let SortBuffers {
        ends,
        bucket,
        run,
        row,
    } = buffers;
    let is_row = |sites: &[Key]| scale.is_injective() && is_row(sites);
    let is_sorted = |sites: &[Key]| sites.is_sorted_by(|a, b| by_index(a, b).is_lt());
    let mut sort_row = |sites: &mut [Key]| {
        if sites.len() <= short {
            sort_few::<0>(sites);
        } else if !is_sorted(sites) {
            row.set(sites.iter().copied(), 0, short);
            row.sort_runs(|sites| sites.sort_unstable_by(by_index));
            sites.copy_from_slice(&row.sites);
        }
    };

    let (mut from, mut kept) = (0, 0);
    for &end in &*ends {
        let to = end as usize;
        let sites = vertices.approx[from..to]
            .iter()
            .zip(&vertices.input[from..to]);
        bucket.set(sites.map(|(&approx, &input)| (approx, input)), 1, short);
        bucket.sort_runs(|sites| {
            if is_row(sites) {
                sort_row(sites);
            } else if sites.len() <= VERY_SHORT_RUN || !scale.is_injective() {
                sites.sort_unstable_by(by_index);
            } else if sites.len() <= short {
                sort_few::<1>(sites);
                for row in sites.chunk_by_mut(|a, b| a.0[1] >= b.0[1]) {
                    if row.len() > 1 {
                        sort_few::<0>(row);
                    }
                }
            } else if !is_sorted(sites) {
                run.set(sites.iter().copied(), 1, short);
                run.sort_runs(|sites| {
                    if is_row(sites) {
                        sort_row(sites);
                    } else {
                        sites.sort_unstable_by(by_index);
                    }
                });
                sites.copy_from_slice(&run.sites);
            }
        });
        // Equal points have one key. The others move up to those kept.
        let mut last: Option<Key> = None;
        for &site in &bucket.sites {
            match last {
                Some(last) if compare(&last, &site).is_eq() => {
                    vertices.duplicates.push((site.1, last.1));
                }
                _ => {
                    (vertices.approx[kept], vertices.input[kept]) = site;
                    kept += 1;
                    last = Some(site);
                }
            }
        }
        from = to;
    }
    vertices.approx.truncate(kept);
    vertices.input.truncate(kept);
    vertices.duplicates.sort_unstable();
}

/// Whether all sites have one y, like a row of a lattice.
fn is_row(sites: &[Key]) -> bool {
    let first = sites.first().map(|site| site.0[1]);
    sites.iter().all(|site| Some(site.0[1]) == first)
}

/// Sorts up to [`SHORT_RUN`] sites by one coordinate, without a branch: each goes where as many come before it. Stable.
fn sort_few<const AXIS: usize>(sites: &mut [Key]) {
    let n = sites.len();
    let mut xs = [0.0; SHORT_RUN];
    let mut sorted = [([0.0; 2], 0); SHORT_RUN];
    for (x, site) in xs.iter_mut().zip(&*sites) {
        *x = site.0[AXIS];
    }
    for (i, site) in sites.iter().enumerate() {
        let x = xs[i];
        let before = xs[..i].iter().map(|&other| usize::from(other <= x));
        let after = xs[i + 1..n].iter().map(|&other| usize::from(other < x));
        sorted[before.sum::<usize>() + after.sum::<usize>()] = *site;
    }
    sites.copy_from_slice(&sorted[..n]);
}

/// The exact sweep order of two sites.
#[inline(always)]
fn compare(exact: ExactOrder<'_>, scale: Scale, a: &Key, b: &Key) -> Ordering {
    let axis = |i: usize| match a.0[i].partial_cmp(&b.0[i]) {
        Some(order) if order.is_ne() || scale.is_injective() => order,
        _ => exact(i, [a.1, b.1]),
    };
    axis(1).then_with(|| axis(0))
}

/// Spreads the points over buckets of y in `vertices`, and sets the `ends` of the buckets.
fn spread(
    inputs: impl ExactSizeIterator<Item = u32> + Clone,
    approx: impl Fn(u32) -> [f64; 2],
    points_in_bucket: usize,
    vertices: &mut Vertices,
    ends: &mut Vec<u32>,
) {
    let n = inputs.len();
    let buckets = (n / points_in_bucket).clamp(1, MOST_BUCKETS);
    if buckets == 1 {
        ends.clear();
        ends.push(narrow(n));
        vertices.approx.clear();
        vertices.approx.reserve_exact(n + 2);
        vertices.approx.extend(inputs.clone().map(approx));
        vertices.input.clear();
        vertices.input.extend(inputs);
        return;
    }
    let (low, high) = range(&inputs, |input| approx(input)[1]);
    // Neither differences nor products nor the bucket decrease where y grows.
    let factor = buckets as f64 / (high - low);
    let bucket_of = |approx: [f64; 2]| bucket((approx[1] - low) * factor, buckets);
    ends.clear();
    ends.resize(buckets, 0);
    for input in inputs.clone() {
        ends[bucket_of(approx(input))] += 1;
    }
    begin(ends);
    resize(&mut vertices.approx, n, 2);
    resize(&mut vertices.input, n, 0);
    for input in inputs {
        let approx = approx(input);
        let place = &mut ends[bucket_of(approx)];
        (
            vertices.approx[*place as usize],
            vertices.input[*place as usize],
        ) = (approx, input);
        *place += 1;
    }
}

/// Sets the length of an array, with room for `more`. New memory is not touched: it is zero.
fn resize<T: Clone + Default>(array: &mut Vec<T>, length: usize, more: usize) {
    if array.capacity() < length + more {
        *array = vec![T::default(); length + more];
    }
    array.resize(length, T::default());
}

/// The range over which buckets are spread: the range of a sample, without points far outside its middle half. A few points
/// far away, such as "no data" points, would otherwise leave all others in one bucket. Others share an outer bucket.
fn range(
    inputs: &(impl ExactSizeIterator<Item = u32> + Clone),
    y: impl Fn(u32) -> f64,
) -> (f64, f64) {
    let (of_each, most) = SAMPLE_OF_Y;
    let places = sampled(inputs.len(), most.min(inputs.len() / of_each));
    let mut sample: Vec<f64> = places
        .filter_map(|place| inputs.clone().nth(place).map(&y))
        .collect();
    sample.sort_unstable_by(f64::total_cmp);
    let [Some(&low), Some(&high)] = [sample.first(), sample.last()] else {
        return (0.0, 0.0);
    };
    let [first, last] = [1, 3].map(|quarter| sample[quarter * sample.len() / 4]);
    let margin = FAR_OUTSIDE * (last - first);
    if margin > 0.0 {
        (low.max(first - margin), high.min(last + margin))
    } else {
        (low, high)
    }
}

#[cfg(test)]
mod tests {
    use super::{Scale, SortBuffers, Tuning, Vertices, sort};

    /// Sorts these points and compares the outcome with that of a sort by comparison.
    fn sorted(points: &[[f64; 2]]) -> SortBuffers {
        let approx = |i: u32| points[i as usize];
        let count = u32::try_from(points.len()).expect("few");
        let mut found = Vertices {
            scale: Scale::exact(points.len(), |i| points[i]),
            ..Vertices::default()
        };
        let mut buffers = SortBuffers::default();
        sort(
            points,
            0..count,
            approx,
            &mut found,
            &mut buffers,
            &Tuning::REAL,
        );

        let mut expected: Vec<u32> = (0..count).collect();
        expected.sort_by(|&i, &j| {
            let [[x, y], [z, w]] = [i, j].map(approx);
            y.total_cmp(&w).then(x.total_cmp(&z)).then(i.cmp(&j))
        });
        let bits = |i: u32| approx(i).map(f64::to_bits);
        let (mut distinct, mut duplicates) = (Vec::<u32>::new(), Vec::new());
        for i in expected {
            match distinct.last() {
                Some(&last) if bits(last) == bits(i) => duplicates.push((i, last)),
                _ => distinct.push(i),
            }
        }
        duplicates.sort_unstable();
        assert_eq!(found.input, distinct);
        assert_eq!(found.duplicates, duplicates);
        let places: Vec<[f64; 2]> = distinct.into_iter().map(approx).collect();
        assert_eq!(found.approx, places);
        buffers
    }

    /// Three rows whose y have one key, among points spread far. A row has each point twice, and one just left of it.
    #[test]
    fn long_rows_within_a_run_are_in_order() {
        let little = 2_f64.powi(-40);
        let in_row = |i: u32| {
            let x = f64::from(i * 37 % 60) - f64::from(i / 360) * little;
            [x, f64::from(i % 3) * little]
        };
        let spread = |i: u32| [f64::from(i * 7 % 11), f64::from(i * 31 % 300)];
        let points: Vec<[f64; 2]> = (0..540).map(in_row).chain((0..300).map(spread)).collect();
        assert_eq!(sorted(&points).row.sites.len(), 180, "a row");
    }

    /// Rows of one to eight points, some of them twice.
    #[test]
    fn short_rows_are_in_order() {
        let point = |i: u32| [f64::from(i * 37 % 13), f64::from(i % 500 * 31 % 97)];
        let points: Vec<[f64; 2]> = (0..600).map(point).chain((0..50).map(point)).collect();
        sorted(&points);
    }
}

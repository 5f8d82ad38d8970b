//! The sweep order of section 3.3: by y, then x, exactly.
//!
//! The points are sorted by a coarse key of y, by counting. Then every run of equal keys is sorted by exact
//! comparison, and equal points merge into the one with the lowest input index.
//!
//! Why it is right: the key never decreases where y grows, so points of different keys are in order, and equal
//! points have one key. In a sorted run they are neighbours, and the lowest index comes first.
//!
//! Cost: O(n) where the points spread over y, but for a few far away; O(n log n) at worst, when all share
//! one key. For a moment 16 bytes a point, and 24 more if all share one key.
//!
//! Differs from the paper: it sorts by comparison, and does not say what becomes of equal points.

use std::cmp::Ordering;

use crate::bucket::bucket;
use crate::ids::narrow;
use crate::scalar::{Scalar, Scale};

/// So few points are sorted fast by comparison too.
const FEW: usize = 4096;
/// How many of more points are looked at to find the middle half of them.
const SAMPLE: usize = 256;
/// What is outside the middle half by more than this many times its height is far outside.
const REACH: f64 = 8.0;

/// The distinct points in sweep order.
#[derive(Debug)]
pub(super) struct Order {
    /// Their approximated coordinates, with room for the two artificial points.
    pub(super) approx: Vec<[f64; 2]>,
    /// Their input indices; the lowest of equal points stands for all.
    pub(super) input: Vec<u32>,
    /// The others of equal points: `(point, representative)`.
    pub(super) duplicates: Vec<(u32, u32)>,
}

/// A point: its approximated coordinates and its input index.
type Site = ([f64; 2], u32);

/// A point with its coarse key.
#[derive(Clone, Copy, Default)]
struct Keyed {
    key: u32,
    input: u32,
}

/// Sorts and merges the points with these input indices, which ascend; `approx` gives the approximated
/// coordinates of a point by its input index.
pub(super) fn sort<S: Scalar>(
    points: &[[S; 2]],
    inputs: impl ExactSizeIterator<Item = u32> + Clone,
    approx: impl Fn(u32) -> [f64; 2],
    scale: Scale,
) -> Order {
    let keyed = sort_by_key(inputs, &approx);

    // Gather in a loop of its own: independent cache misses overlap.
    let mut sorted = Vec::with_capacity(keyed.len() + 2);
    sorted.extend(keyed.iter().map(|item| approx(item.input)));
    let mut order = Order {
        approx: sorted,
        input: keyed.iter().map(|item| item.input).collect(),
        duplicates: Vec::new(),
    };

    // Runs of equal keys, sorted exactly. What is equal has one key. The others move up to what is kept.
    let mut sites: Vec<Site> = Vec::new();
    let (mut from, mut kept) = (0, 0);
    for run in keyed.chunk_by(|a, b| a.key == b.key) {
        let to = from + run.len();
        if run.len() > 1 {
            sites.clear();
            sites.extend((from..to).map(|i| (order.approx[i], order.input[i])));
            sites.sort_unstable_by(|a, b| compare(points, scale, a, b).then_with(|| a.1.cmp(&b.1)));
            for equal in sites.chunk_by(|a, b| compare(points, scale, a, b).is_eq()) {
                (order.approx[kept], order.input[kept]) = equal[0];
                kept += 1;
                let others = equal[1..].iter();
                order
                    .duplicates
                    .extend(others.map(|site| (site.1, equal[0].1)));
            }
        } else {
            (order.approx[kept], order.input[kept]) = (order.approx[from], order.input[from]);
            kept += 1;
        }
        from = to;
    }
    order.approx.truncate(kept);
    order.input.truncate(kept);
    order.duplicates.sort_unstable();
    order
}

/// Exact sweep order of two sites.
fn compare<S: Scalar>(points: &[[S; 2]], scale: Scale, a: &Site, b: &Site) -> Ordering {
    let axis = |i: usize| match a.0[i].partial_cmp(&b.0[i]) {
        Some(order) if order.is_ne() || scale.tells_equal() => order,
        _ => points[a.1 as usize][i].compare(&points[b.1 as usize][i]),
    };
    axis(1).then_with(|| axis(0))
}

/// The points by a coarse key that never decreases with y.
///
/// There are four to sixteen keys for each point, so runs of equal keys are short where y is spread. The
/// keys are sorted in two counting passes, each by half of their bits.
fn sort_by_key(
    inputs: impl ExactSizeIterator<Item = u32> + Clone,
    approx: impl Fn(u32) -> [f64; 2],
) -> Vec<Keyed> {
    let points = inputs.len();
    let half = (usize::BITS - points.leading_zeros()).div_ceil(2) + 1;
    let keys = 1_usize << (2 * half);
    let (low, high) = range(&inputs, |input| approx(input)[1]);
    // Neither differences nor products nor the bucket decrease where y grows.
    let factor = keys as f64 / (high - low);
    let key = |y: f64| narrow(bucket((y - low) * factor, keys));
    // Keys, and how often each digit occurs: the lower and the upper half of their bits.
    let mut counts = [0, half].map(|shift| (shift, vec![0_u32; 1 << half]));
    let digit = |key: u32, shift| (key >> shift) as usize & ((1 << half) - 1);
    let mut keyed: Vec<Keyed> = inputs
        .map(|input| {
            let key = key(approx(input)[1]);
            for (shift, counts) in &mut counts {
                counts[digit(key, *shift)] += 1;
            }
            Keyed { key, input }
        })
        .collect();

    // The lower half first; each pass keeps the order of equal digits.
    let mut sorted = vec![Keyed::default(); points];
    for (shift, mut places) in counts {
        // Counts become the places where the digits begin.
        let mut sum = 0;
        for place in &mut places {
            sum += *place;
            *place = sum - *place;
        }
        for item in &keyed {
            let place = &mut places[digit(item.key, shift)];
            sorted[*place as usize] = *item;
            *place += 1;
        }
        std::mem::swap(&mut keyed, &mut sorted);
    }
    keyed
}

/// The range over which keys are spread: that of all y, but for those far outside that of the middle half.
///
/// A few points far away, such as "no data" points, would leave all others with one key. What is beyond
/// the range shares the first or last key.
fn range(
    inputs: &(impl ExactSizeIterator<Item = u32> + Clone),
    y: impl Fn(u32) -> f64,
) -> (f64, f64) {
    let points = inputs.len();
    let (low, high) = inputs.clone().map(&y).fold(
        (f64::INFINITY, f64::NEG_INFINITY),
        |(low, high): (f64, f64), y| (y.min(low), y.max(high)),
    );
    if points < FEW {
        return (low, high);
    }
    let mut sample: Vec<f64> = (0..SAMPLE)
        .filter_map(|i| inputs.clone().nth(i * points / SAMPLE).map(&y))
        .collect();
    sample.sort_unstable_by(f64::total_cmp);
    let [first, last] = [1, 3].map(|quarter| sample[quarter * SAMPLE / 4]);
    let margin = REACH * (last - first);
    if margin > 0.0 {
        (low.max(first - margin), high.min(last + margin))
    } else {
        (low, high)
    }
}

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
/// So few points have one key.
const ONE_KEY: usize = 20;
/// How many of more points are looked at to find the middle half of them.
const SAMPLE: usize = 256;
/// What is outside the middle half by more than this many times its height is far outside.
const REACH: f64 = 8.0;

/// The distinct points in sweep order.
#[derive(Debug, Default)]
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
#[derive(Clone, Copy, Debug, Default)]
struct Keyed {
    key: u32,
    input: u32,
}

/// Working memory of the sort.
#[derive(Debug, Default)]
pub(super) struct Workspace {
    keyed: Vec<Keyed>,
    sorted: Vec<Keyed>,
    /// How often each digit occurs, and then where it begins.
    places: [Vec<u32>; 2],
    /// A run of equal keys.
    sites: Vec<Site>,
}

/// Sorts and merges the points with these input indices, which ascend; `approx` gives the approximated
/// coordinates of a point by its input index. The memory of `order` is used again.
pub(super) fn sort<S: Scalar>(
    points: &[[S; 2]],
    inputs: impl ExactSizeIterator<Item = u32> + Clone,
    approx: impl Fn(u32) -> [f64; 2],
    scale: Scale,
    mut order: Order,
    workspace: &mut Workspace,
) -> Order {
    workspace.sort_by_key(inputs, &approx);
    let Workspace { keyed, sites, .. } = workspace;

    // Gather in a loop of its own: independent cache misses overlap.
    order.approx.clear();
    order.approx.reserve_exact(keyed.len() + 2);
    let gathered = keyed.iter().map(|item| approx(item.input));
    order.approx.extend(gathered);
    order.input.clear();
    order.input.extend(keyed.iter().map(|item| item.input));
    order.duplicates.clear();

    // Runs of equal keys, sorted exactly. What is equal has one key. The others move up to what is kept.
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

impl Workspace {
    /// Puts the points into `keyed` by a coarse key that never decreases with y.
    ///
    /// There are four to sixteen keys for each point, so runs of equal keys are short where y is spread. The
    /// keys are sorted in two counting passes, each by half of their bits. Few points have one key.
    fn sort_by_key(
        &mut self,
        inputs: impl ExactSizeIterator<Item = u32> + Clone,
        approx: impl Fn(u32) -> [f64; 2],
    ) {
        let points = inputs.len();
        self.keyed.clear();
        if points <= ONE_KEY {
            self.keyed
                .extend(inputs.map(|input| Keyed { key: 0, input }));
            return;
        }
        let half = (usize::BITS - points.leading_zeros()).div_ceil(2) + 1;
        let keys = 1_usize << (2 * half);
        let (low, high) = range(&inputs, |input| approx(input)[1]);
        // Neither differences nor products nor the bucket decrease where y grows.
        let factor = keys as f64 / (high - low);
        let key = |y: f64| narrow(bucket((y - low) * factor, keys));
        // Keys, and how often each digit occurs: the lower and the upper half of their bits.
        for counts in &mut self.places {
            counts.clear();
            counts.resize(1 << half, 0);
        }
        let [lower, upper] = &mut self.places;
        let digit = |key: u32, shift| (key >> shift) as usize & ((1 << half) - 1);
        self.keyed.extend(inputs.map(|input| {
            let key = key(approx(input)[1]);
            lower[digit(key, 0)] += 1;
            upper[digit(key, half)] += 1;
            Keyed { key, input }
        }));

        // The lower half first; each pass keeps the order of equal digits.
        self.sorted.clear();
        self.sorted.resize(points, Keyed::default());
        for (shift, places) in [(0, lower), (half, upper)] {
            // Counts become the places where the digits begin.
            let mut sum = 0;
            for place in &mut *places {
                sum += *place;
                *place = sum - *place;
            }
            for item in &self.keyed {
                let place = &mut places[digit(item.key, shift)];
                self.sorted[*place as usize] = *item;
                *place += 1;
            }
            std::mem::swap(&mut self.keyed, &mut self.sorted);
        }
    }
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

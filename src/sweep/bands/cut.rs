//! The bands: the points between two heights, `y` as a double.
//!
//! Why it is right: doubles never fall where the coordinate grows, and equal coordinates have equal doubles. So
//! the bands follow each other in sweep order, and equal points are in one band.
//!
//! Cost: O(n) for each band, on a thread of its own, and a sample of the points, sorted.

use rayon::prelude::*;

use super::super::located::Located;
use crate::ids::narrow;
use crate::scalar::Scalar;

/// How many points are looked at to cut the others into bands of equal size.
const SAMPLE: usize = 1 << 14;
/// A prime from one point of the sample to the next, so that it finds no pattern in the order of the points.
const STRIDE: usize = 1_000_000_007;

/// The input indices of the points in each band, from the lowest band to the highest; some may be empty.
pub(super) fn cut<S: Scalar + Sync>(located: &Located<'_, S>, bands: usize) -> Vec<Vec<u32>> {
    let points = located.points.len();
    let pivots = pivots(located, bands);
    let inputs = |band: usize| {
        let low = band.checked_sub(1).map(|below| pivots[below]);
        let high = pivots.get(band);
        let is_in = |&input: &u32| {
            let y = located.near(input)[1];
            low.is_none_or(|low| low <= y) && high.is_none_or(|&high| y < high)
        };
        (0..narrow(points)).filter(is_in).collect()
    };
    (0..=pivots.len()).into_par_iter().map(inputs).collect()
}

/// The heights between the bands.
fn pivots<S: Scalar>(located: &Located<'_, S>, bands: usize) -> Vec<f64> {
    let points = located.points.len();
    let place = |i: usize| narrow(i.wrapping_mul(STRIDE) % points);
    let mut sample: Vec<f64> = (0..SAMPLE.min(points))
        .map(|i| located.near(place(i))[1])
        .collect();
    sample.sort_unstable_by(f64::total_cmp);
    (1..bands)
        .filter_map(|band| sample.get(band * sample.len() / bands).copied())
        .collect()
}

//! The bands: the points between two heights, `y` as a double.
//!
//! Why it is right: doubles never fall where the coordinate grows, and equal coordinates have equal doubles. So
//! the bands follow each other in sweep order, and equal points are in one band.
//!
//! Cost: O(n log b) for n points and b bands, divided among the threads, and a sample of the points, sorted.

use rayon::prelude::*;

use super::super::located::Located;
use crate::ids::narrow;
use crate::scalar::Scalar;

/// How many points are looked at to cut the others into bands of equal size.
const SAMPLE: usize = 1 << 14;
/// A prime from one point of the sample to the next, so that it finds no pattern in the order of the points.
const STRIDE: usize = 1_000_000_007;
/// Points, or edges, that a thread puts into bands at a time.
pub(super) const CHUNK: usize = 1 << 15;

/// The input indices of the points in each band, from the lowest band to the highest; some may be empty.
pub(super) fn cut<S: Scalar + Sync>(located: &Located<'_, S>, bands: usize) -> Vec<Vec<u32>> {
    let points = located.points.len();
    let pivots = pivots(located, bands);
    let chunk = |chunk: usize| {
        let mut inputs = vec![Vec::new(); bands];
        for input in chunk * CHUNK..points.min((chunk + 1) * CHUNK) {
            let y = located.near(narrow(input))[1];
            let band = pivots.partition_point(|&pivot| pivot <= y);
            inputs[band].push(narrow(input));
        }
        inputs
    };
    let chunks = (0..points.div_ceil(CHUNK)).into_par_iter().map(chunk);
    let chunks: Vec<Vec<Vec<u32>>> = chunks.collect();
    let band = |band: usize| {
        let inputs: Vec<&[u32]> = chunks.iter().map(|chunk| &chunk[band][..]).collect();
        inputs.concat()
    };
    (0..bands).into_par_iter().map(band).collect()
}

/// The heights between the bands.
fn pivots<S: Scalar + Sync>(located: &Located<'_, S>, bands: usize) -> Vec<f64> {
    let points = located.points.len();
    let place = |i: usize| narrow(i.wrapping_mul(STRIDE) % points);
    let mut sample: Vec<f64> = (0..SAMPLE.min(points))
        .into_par_iter()
        .map(|i| located.near(place(i))[1])
        .collect();
    sample.par_sort_unstable_by(f64::total_cmp);
    (1..bands)
        .filter_map(|band| sample.get(band * sample.len() / bands).copied())
        .collect()
}

//! Cutting the points into bands: all points between two heights, `y` as a double.
//!
//! Why it is right: doubles never fall where the coordinate grows, and equal coordinates have equal doubles. So the
//! bands follow each other in sweep order, and equal points are in one band. Cost: O(n log b) for n points and b bands,
//! divided among the threads, and a sorted sample. Two passes count and place the points: no list grows or is copied.

use alloc::vec;
use alloc::vec::Vec;
use core::slice;

use super::super::vertices::ApproxPoints;
use crate::ids::narrow;
use crate::scalar::Scalar;
use crate::threads::on_all_cores;
use crate::tuning::STRIDE_OF_SAMPLE;
use crate::tuning::{CHUNK_OF_BANDS, SAMPLE_OF_BANDS};

/// The input indices of the points in each band, from the lowest band to the highest; some may be empty.
pub(super) fn cut<S: Scalar + Sync>(located: &ApproxPoints<'_, S>, bands: usize) -> Vec<Vec<u32>> {
    let pivots = pivots(located, bands);
    let cutter = Cutter { located, pivots };
    let chunks = located.points.len().div_ceil(CHUNK_OF_BANDS);
    let count = |chunk| cutter.count(chunk, bands);
    let counts = on_all_cores((0..chunks).collect(), count);

    // The portion of each band that each chunk fills.
    let size = |band: usize| counts.iter().map(|counts| counts[band]).sum();
    let mut inputs: Vec<Vec<u32>> = (0..bands).map(|band| vec![0; size(band)]).collect();
    let mut pending: Vec<&mut [u32]> = inputs.iter_mut().map(Vec::as_mut_slice).collect();
    let mut parts: Vec<Vec<slice::IterMut<'_, u32>>> = Vec::new();
    for counts in &counts {
        let parts_of = pending.iter_mut().zip(counts).map(|(rest, &count)| {
            let part = rest.split_off_mut(..count).expect("it is counted");
            part.iter_mut()
        });
        parts.push(parts_of.collect());
    }
    on_all_cores(parts.into_iter().enumerate().collect(), |(chunk, parts)| {
        cutter.fill(chunk, parts);
    });
    inputs
}

struct Cutter<'a, S> {
    located: &'a ApproxPoints<'a, S>,
    pivots: Vec<f64>,
}

impl<S: Scalar> Cutter<'_, S> {
    /// How many points of a chunk each band has.
    fn count(&self, chunk: usize, bands: usize) -> Vec<usize> {
        let mut counts = vec![0; bands];
        for (_, band) in self.points(chunk) {
            counts[band] += 1;
        }
        counts
    }

    /// Puts the points of a chunk into its portion of each band.
    fn fill(&self, chunk: usize, mut parts: Vec<slice::IterMut<'_, u32>>) {
        for (input, band) in self.points(chunk) {
            *parts[band].next().expect("it has been counted") = input;
        }
    }

    /// The input indices of the points of a chunk, each with its band.
    fn points(&self, chunk: usize) -> impl Iterator<Item = (u32, usize)> {
        let end = self.located.points.len().min((chunk + 1) * CHUNK_OF_BANDS);
        (chunk * CHUNK_OF_BANDS..end).map(|input| {
            let input = narrow(input);
            let y = self.located.approx(input)[1];
            (input, self.pivots.partition_point(|&pivot| pivot <= y))
        })
    }
}

/// The heights between the bands.
fn pivots<S: Scalar + Sync>(located: &ApproxPoints<'_, S>, bands: usize) -> Vec<f64> {
    let points = located.points.len();
    let place = |i: usize| narrow(i.wrapping_mul(STRIDE_OF_SAMPLE) % points);
    let y = |i: usize| located.approx(place(i))[1];
    quantiles((0..SAMPLE_OF_BANDS.min(points)).map(y).collect(), bands)
}

/// The numbers that cut a sample into parts of equal size.
fn quantiles(mut sample: Vec<f64>, parts: usize) -> Vec<f64> {
    sample.sort_unstable_by(f64::total_cmp);
    (1..parts)
        .filter_map(|part| sample.get(part * sample.len() / parts).copied())
        .collect()
}

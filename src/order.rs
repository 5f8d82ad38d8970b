//! The sweep order of section 3.3: by y, then x, exactly.
//!
//! A coarse key, monotone in y, is sorted by counting; then every run of equal keys is sorted by exact
//! comparison. Since the key never decreases where y grows, that is the exact order.
//!
//! Cost: O(n) where the points spread over y, O(n log n) at worst, when all share one key; 40 bytes a
//! point for a moment. The paper's initialization took up to two thirds of its time (table 2).
//!
//! Differs from the paper: it sorts by comparison.

use std::cmp::Ordering;

use crate::Scalar;
use crate::mesh::index;
use crate::predicates::Scale;

/// A point on its way to its rank.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Site {
    pub(crate) near: [f64; 2],
    pub(crate) input: u32,
}

/// A point with its coarse key.
#[derive(Clone, Copy, Default)]
struct Keyed {
    key: u32,
    input: u32,
}

/// All points in exact sweep order; of equal ones the lowest index first. `near` are their doubles.
pub(crate) fn sort<S: Scalar>(points: &[[S; 2]], near: &[[f64; 2]], scale: Scale) -> Vec<Site> {
    let keyed = sort_by_key(near);
    let mut sites: Vec<Site> = keyed
        .iter()
        .map(|&Keyed { input, .. }| Site {
            near: near[input as usize],
            input,
        })
        .collect();
    let order =
        |a: &Site, b: &Site| compare(points, scale, a, b).then_with(|| a.input.cmp(&b.input));
    let mut from = 0;
    for run in keyed.chunk_by(|a, b| a.key == b.key) {
        if run.len() > 1 {
            sites[from..from + run.len()].sort_unstable_by(order);
        }
        from += run.len();
    }
    sites
}

/// Exact sweep order of two sites.
pub(crate) fn compare<S: Scalar>(points: &[[S; 2]], scale: Scale, a: &Site, b: &Site) -> Ordering {
    let axis = |i: usize| match a.near[i].partial_cmp(&b.near[i]) {
        Some(order) if order.is_ne() || scale.is_exact() => order,
        _ => points[a.input as usize][i].compare(&points[b.input as usize][i]),
    };
    axis(1).then_with(|| axis(0))
}

/// The number of the interval that `x`, counted in intervals, falls in: the last one of `count` if it
/// lies beyond, the first one if it is negative or no number.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the cast saturates, as wanted"
)]
#[inline(always)]
pub(crate) fn interval(x: f64, count: usize) -> usize {
    (x as usize).min(count - 1)
}

/// The points by a coarse key that never decreases with y.
///
/// There are two to eight keys a point, so that runs of equal keys are short where y is spread; two
/// counting passes of half the key's bits each.
fn sort_by_key(near: &[[f64; 2]]) -> Vec<Keyed> {
    let half = (usize::BITS - near.len().leading_zeros()).div_ceil(2) + 1;
    let keys = 1_usize << (2 * half);
    let (low, high) = near
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), [_, y]| {
            (y.min(low), y.max(high))
        });
    // Neither differences nor products nor the interval decrease where y grows.
    let factor = keys as f64 / (high - low);
    let key = |y: f64| index(interval((y - low) * factor, keys));
    let mut keyed: Vec<Keyed> = (0..)
        .zip(near)
        .map(|(input, &[_, y])| Keyed { key: key(y), input })
        .collect();
    let mut sorted = vec![Keyed::default(); keyed.len()];
    for shift in [0, half] {
        let digit = |item: &Keyed| (item.key >> shift) as usize & ((1 << half) - 1);
        let mut places = vec![0_u32; 1 << half];
        for item in &keyed {
            places[digit(item)] += 1;
        }
        let mut sum = 0;
        for place in &mut places {
            sum += *place;
            *place = sum - *place;
        }
        for item in &keyed {
            let place = &mut places[digit(item)];
            sorted[*place as usize] = *item;
            *place += 1;
        }
        std::mem::swap(&mut keyed, &mut sorted);
    }
    keyed
}

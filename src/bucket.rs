//! Buckets and samples of numbers. The sort and the front's hash table use both, the canonical order the sample.

use core::iter::successors;

/// The bucket of `x`, which is measured in buckets, in `0..count` (below 2^32). Clamps, and NaN goes to 0. Monotone.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the cast saturates, as wanted"
)]
#[inline(always)]
pub(crate) fn bucket(x: f64, count: usize) -> usize {
    (x as u32 as usize).min(count - 1)
}

/// `size` of `n` numbers, or all if there are fewer, at multiples of the golden ratio: out of step with any lattice.
pub(crate) fn sampled(n: usize, size: usize) -> impl Iterator<Item = usize> {
    let fractions = successors(Some(0_u32), |at| Some(at.wrapping_add(0x9E37_79B9)));
    let spread = fractions.map(move |at| ((u64::from(at) * n as u64) >> 32) as usize);
    (0..n.min(size))
        .zip(spread)
        .map(move |(i, spread)| if n <= size { i } else { spread })
}

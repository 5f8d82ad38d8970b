//! Numbers spread over buckets: the sort and the front's hash table use the same few lines.

/// `x`, measured in buckets, as a bucket index in `0..count`, which is below 2^32; clamps, and NaN goes to 0.
/// It never decreases where `x` grows.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the cast saturates, as wanted"
)]
#[inline(always)]
pub(crate) fn bucket(x: f64, count: usize) -> usize {
    (x as u32 as usize).min(count - 1)
}

//! Points that would be on one circle or line, had their coordinates not been rounded.
//!
//! Their determinants are as small as the rounding errors of computing them in doubles, with either sign. A
//! filter whose bound is too small is wrong here, and seldom elsewhere.

use arbitrary::{Result, Unstructured};

use super::each::{Points, each};
use super::numbers::{byte, wide};

/// Up to `n` points on a circle or a segment, up to rounding.
pub(super) fn rounded(is_circle: bool, n: usize, bytes: &mut Unstructured<'_>) -> Result<Points> {
    let from = [wide(bytes)? / 7.0, wide(bytes)? / 7.0];
    let by = [wide(bytes)? / 3.0, wide(bytes)? / 3.0];
    each(n, bytes, |_, b| {
        let place = f64::from(byte(b)?);
        let part = if is_circle {
            // The tangent of half the angle.
            let t = (place - 127.5) / 37.0;
            let cosine = (1.0 - t * t) / (1.0 + t * t);
            [by[0] * cosine, by[0] * (2.0 * t / (1.0 + t * t))]
        } else {
            by.map(|x| x * (place / 255.0))
        };
        Ok([from[0] + part[0], from[1] + part[1]])
    })
}

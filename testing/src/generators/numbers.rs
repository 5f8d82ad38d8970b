//! Numbers out of bytes.

use arbitrary::{Result, Unstructured};

/// A byte, 0 where there is none.
pub(super) fn byte(bytes: &mut Unstructured<'_>) -> Result<u8> {
    bytes.arbitrary()
}

/// An integer from `-limit` to `limit` out of one byte.
pub(super) fn small(bytes: &mut Unstructured<'_>, limit: u8) -> Result<f64> {
    let values = 2 * u16::from(limit) + 1;
    Ok(f64::from(u16::from(byte(bytes)?) % values) - f64::from(limit))
}

/// An integer of 16 bits out of two bytes.
pub(super) fn wide(bytes: &mut Unstructured<'_>) -> Result<f64> {
    Ok(f64::from(bytes.arbitrary::<i16>()?))
}

/// The number `steps` units in the last place away.
pub(super) fn nudged(x: f64, steps: i8) -> f64 {
    let step = if steps < 0 {
        f64::next_down
    } else {
        f64::next_up
    };
    (0..steps.unsigned_abs()).fold(x, |x, _| step(x))
}

/// Magnitudes from the smallest subnormal to half of the largest double, around the places where
/// arithmetic changes: subnormals, products and fourth powers that under- or overflow, the 53 bits of a
/// double and the 62 of two.
pub(super) const MAGNITUDES: [f64; 16] = [
    5e-324,
    f64::MIN_POSITIVE / 4.0,
    f64::MIN_POSITIVE,
    1e-300,
    1e-160,
    1e-80,
    1e-42,
    1e-5,
    1.0,
    3.0,
    1e9,
    9_007_199_254_740_992.0,
    1e42,
    1e77,
    1e155,
    f64::MAX / 16.0,
];

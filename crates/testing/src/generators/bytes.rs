//! Numbers and lists of points out of bytes, and how large an input may be, so that every exact check of it ends
//! soon.

use arbitrary::{Result, Unstructured};

/// An input has at most this many points.
pub const POINTS: usize = 64;
/// An input has at most this many points where exact arithmetic takes thousands of bits.
pub const FAR_POINTS: usize = 10;
/// An input has at most this many edges.
pub const EDGES: usize = 96;

/// So many bytes stand for an input of most points and edges, with one byte a point and two an edge.
pub const BYTES: usize = 3 + POINTS + 1 + 2 * EDGES;

pub(super) type Points = Vec<[f64; 2]>;
/// A place on a lattice.
pub(super) type Place = [i32; 2];
/// Polygons as lists of rings, by places on a lattice.
pub(super) type Made = Vec<Vec<Vec<Place>>>;

/// Up to `n` points, as long as there are bytes.
pub(super) fn each(
    n: usize,
    bytes: &mut Unstructured<'_>,
    mut point: impl FnMut(usize, &mut Unstructured<'_>) -> Result<[f64; 2]>,
) -> Result<Points> {
    let mut points = Points::new();
    while points.len() < n && !bytes.is_empty() {
        points.push(point(points.len(), bytes)?);
    }
    Ok(points)
}

/// Up to `n` points that would be on one circle or segment, had their coordinates not been rounded.
///
/// The points' determinants are as small as the rounding errors of computing them in doubles, with either sign. A
/// filter whose bound is too small is wrong here, and seldom elsewhere.
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

/// A byte, 0 where there is none.
pub(super) fn byte(bytes: &mut Unstructured<'_>) -> Result<u8> {
    bytes.arbitrary()
}

/// An integer from `-limit` to `limit` out of one byte.
pub(super) fn integer(bytes: &mut Unstructured<'_>, limit: u8) -> Result<f64> {
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

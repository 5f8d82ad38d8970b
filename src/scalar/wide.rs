//! In-circle determinants of integers in 64, 128 and 256 bits.
//!
//! Why nothing overflows: with differences below 2^k a lift and a cross product are below 2^(2k+1) and
//! their products, three of which are summed, below 2^(4k+2); so k = 30 fits lifts in 64 and the sum in 128
//! bits, and k = 62 in 128 and 256.
//!
//! Cost: about 3 ns for k = 30, 10 ns for k = 62.

use std::cmp::Ordering;

/// The sign of the in-circle determinant whose rows are the differences of three points to a fourth, all
/// below 2^30.
pub(super) fn in_circle_narrow([[ax, ay], [bx, by], [cx, cy]]: [[i64; 2]; 3]) -> Ordering {
    let det = i128::from(ax * ax + ay * ay) * i128::from(bx * cy - cx * by)
        + i128::from(bx * bx + by * by) * i128::from(cx * ay - ax * cy)
        + i128::from(cx * cx + cy * cy) * i128::from(ax * by - bx * ay);
    det.cmp(&0)
}

/// The same for differences below 2^62.
pub(super) fn in_circle_middle([[ax, ay], [bx, by], [cx, cy]]: [[i128; 2]; 3]) -> Ordering {
    let products = [
        product(ax * ax + ay * ay, bx * cy - cx * by),
        product(bx * bx + by * by, cx * ay - ax * cy),
        product(cx * cx + cy * cy, ax * by - bx * ay),
    ];
    let (high, low) = products.into_iter().fold((0, 0), add);
    high.cmp(&0).then(low.cmp(&0))
}

/// `a * b` as (high, low), meaning high * 2^128 + low; both factors are below 2^125.
fn product(a: i128, b: i128) -> (i128, u128) {
    const HALF: i128 = (1 << 64) - 1;
    let (a1, a0, b1, b0) = (a >> 64, a & HALF, b >> 64, b & HALF);
    let middle = a1 * b0 + a0 * b1;
    let shifted = (a1 * b1 + (middle >> 64), (middle << 64).cast_unsigned());
    add(shifted, (0, a0.unsigned_abs() * b0.unsigned_abs()))
}

fn add(a: (i128, u128), b: (i128, u128)) -> (i128, u128) {
    let (low, carry) = a.1.overflowing_add(b.1);
    (a.0 + b.0 + i128::from(carry), low)
}

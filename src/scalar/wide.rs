//! Determinants of integers in 64, 128 and 256 bits.
//! The in-circle sign of a, b, c, d is that of -sin(beta + delta), of the opposite angles of the quadrilateral at b and
//! d, in lengths and without a division: two products of products, where the lifted points take three.
//! Why it is right: nothing overflows. With differences of any two points below 2^k, a cross or dot product is below
//! 2^(2k+1), and a product of two below 2^(4k+2); two of these are compared. Where the differences to d are below 2^30,
//! all are at most 2^31 - 2, and a cross or dot product is below 2^63. With k = 62 they fit in 128 and 256 bits.
//! Cost: some dozens of multiplications for k = 62, ten for k = 30.

use core::cmp::Ordering;

/// The sign of the turn from `a` to `b`, two differences to the same point, below 2^62.
pub(super) fn turn([ax, ay]: [i64; 2], [bx, by]: [i64; 2]) -> Ordering {
    product(ax, by).cmp(&product(ay, bx))
}

/// The in-circle sign from the differences of three points to a fourth. Differences of any two points are below 2^62.
#[inline]
pub(super) fn in_circle(rows: [[i64; 2]; 3]) -> Ordering {
    let sizes = rows.as_flattened().iter().map(|x| x.unsigned_abs());
    let span = sizes.fold(0, |span, size| span | size);
    // Dividing all differences by a power of two changes no sign.
    let zeros = span.trailing_zeros() & 63;
    let rows = rows.map(|row| row.map(|x| x >> zeros));
    if span >> zeros < 1 << 30 {
        narrow(rows)
    } else {
        middle(rows)
    }
}

/// The in-circle sign for differences below 2^30.
fn narrow([a, b, c]: [[i64; 2]; 3]) -> Ordering {
    let (from_b, to_b) = (minus(a, b), minus(c, b));
    let cross = |[ax, ay]: [i64; 2], [bx, by]: [i64; 2]| ax * by - bx * ay;
    let dot = |[ax, ay]: [i64; 2], [bx, by]: [i64; 2]| ax * bx + ay * by;
    let left = product(cross(from_b, to_b), dot(a, c));
    left.cmp(&product(dot(from_b, to_b), cross(a, c)))
}

/// The in-circle sign for differences below 2^62.
fn middle([a, b, c]: [[i64; 2]; 3]) -> Ordering {
    let (from_b, to_b) = (minus(a, b), minus(c, b));
    let cross = |[ax, ay]: [i64; 2], [bx, by]: [i64; 2]| product(ax, by) - product(bx, ay);
    let dot = |[ax, ay]: [i64; 2], [bx, by]: [i64; 2]| product(ax, bx) + product(ay, by);
    let left = long(cross(from_b, to_b), dot(a, c));
    left.cmp(&long(dot(from_b, to_b), cross(a, c)))
}

fn minus([ax, ay]: [i64; 2], [bx, by]: [i64; 2]) -> [i64; 2] {
    [ax - bx, ay - by]
}

fn product(a: i64, b: i64) -> i128 {
    i128::from(a) * i128::from(b)
}

/// `a * b` as (high, low), meaning high * 2^128 + low; both factors are below 2^125.
fn long(a: i128, b: i128) -> (i128, u128) {
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

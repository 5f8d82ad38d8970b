//! `i32` and `i64`: exact for every value, in integers as wide as the differences require. These are machine integers
//! of 64, 128 and 256 bits where they hold the determinant, and big integers where they do not; other scalars use
//! them too.
//!
//! Arguments are differences of coordinates. Why nothing overflows: with differences below 2^k a lift
//! and a cross product are below 2^(2k+1) and their products, three of which are summed, below
//! 2^(4k+2); so k = 30 fits lifts in 64 and the sum in 128 bits, and k = 62 in 128 and 256.
//!
//! Cost: of a determinant about 3 ns for k = 30, 10 ns for k = 62, a microsecond beyond; of a test 5 to 15 ns. Big
//! integers only for in-circle tests with differences above 2^62.

use std::cmp::Ordering;

use num_bigint::BigInt;

use super::{Scalar, Stage, unbounded};

/// The difference of two points; it always fits.
fn minus(a: &[i64; 2], b: &[i64; 2]) -> [i128; 2] {
    [0, 1].map(|i| i128::from(a[i]) - i128::from(b[i]))
}

impl Scalar for i64 {
    fn approx(&self) -> f64 {
        *self as f64
    }

    fn difference(&self, other: &Self) -> Option<(f64, i64)> {
        Some(((i128::from(*self) - i128::from(*other)) as f64, 0))
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.cmp(other)
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
        Self::orient2d_exact(a, b, c).0
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
        Self::in_circle_exact(a, b, c, d).0
    }

    fn orient2d_exact(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
        turn(minus(a, c), minus(b, c))
    }

    fn in_circle_exact(
        a: &[Self; 2],
        b: &[Self; 2],
        c: &[Self; 2],
        d: &[Self; 2],
    ) -> (Ordering, Stage) {
        in_circle([a, b, c].map(|p| minus(p, d)))
    }
}

impl Scalar for i32 {
    const APPROX_IS_EXACT: bool = true;

    fn approx(&self) -> f64 {
        f64::from(*self)
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.cmp(other)
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
        Self::orient2d_exact(a, b, c).0
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
        Self::in_circle_exact(a, b, c, d).0
    }

    fn orient2d_exact(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
        let [a, b, c] = [a, b, c].map(|p| p.map(i64::from));
        i64::orient2d_exact(&a, &b, &c)
    }

    fn in_circle_exact(
        a: &[Self; 2],
        b: &[Self; 2],
        c: &[Self; 2],
        d: &[Self; 2],
    ) -> (Ordering, Stage) {
        let [a, b, c, d] = [a, b, c, d].map(|p| p.map(i64::from));
        i64::in_circle_exact(&a, &b, &c, &d)
    }
}

/// The sign of the turn from `a` to `b`, two differences to the same point, and the integers it took.
pub(super) fn turn(a: [i128; 2], b: [i128; 2]) -> (Ordering, Stage) {
    match (a[0].checked_mul(b[1]), a[1].checked_mul(b[0])) {
        (Some(left), Some(right)) => (left.cmp(&right), Stage::Integers),
        _ => {
            let [a, b] = [a, b].map(|row| row.map(BigInt::from));
            (unbounded::turn(&a, &b), Stage::BigIntegers)
        }
    }
}

/// The sign of the in-circle determinant whose rows are the differences of three points to a fourth,
/// and the integers it took.
#[expect(clippy::cast_possible_truncation, reason = "only what is below 2^30")]
pub(super) fn in_circle(rows: [[i128; 2]; 3]) -> (Ordering, Stage) {
    let span = rows
        .iter()
        .flatten()
        .fold(0, |span, x| span | x.unsigned_abs());
    // A power of two that divides all of them changes no sign.
    let zeros = span.trailing_zeros() & 127;
    let rows = rows.map(|row| row.map(|x| x >> zeros));
    if span >> zeros < 1 << 30 {
        let sign = in_circle_narrow(rows.map(|row| row.map(|x| x as i64)));
        (sign, Stage::Integers)
    } else if span >> zeros < 1 << 62 {
        (in_circle_middle(rows), Stage::Integers)
    } else {
        let sign = unbounded::lifted(&rows.map(|row| row.map(BigInt::from)));
        (sign, Stage::BigIntegers)
    }
}

/// The same for differences below 2^30.
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

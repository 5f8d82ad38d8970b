//! The floating-point filter: signs of both determinants that are certain from doubles alone.
//!
//! Each test subtracts the last point from the others, evaluates the determinant of the differences in
//! doubles, and compares it with a bound on its error. It answers only where the sign is beyond doubt;
//! what it leaves open goes to the scalar's exact stages. The bounds are of the kind of Shewchuk's
//! bound A (1997, sections 4.3 and 4.4: one evaluation, its error against the sum of the absolute
//! values of the terms); the in-circle bound replaces that sum by one that is cheaper.
//!
//! # Why it is right
//!
//! Write u for 2^-53. A sum or difference is rounded by a factor 1 + e with |e| <= u, a product by such
//! a factor and an underflow of at most 2^-1075. Let d stand for the differences of the doubles before
//! they are rounded, D for the determinant of these, P for the sum of the absolute values of its
//! terms, and V for the computed determinant before its last rounding, which changes no sign and makes
//! it at most 1 + u times as large. No test overflows, since doubles are at most 2^200 in size
//! ([`Scale`]), so differences are at most 2^201 and fourth powers far below 2^1023.
//!
//! 1. **Orientation, exact doubles.** Each product is off by three factors 1 + e (two differences, one
//!    product), so |V - D| <= ((1 - u)^-3 - 1) S, where S is the sum of the absolute values of the two
//!    computed products. The bound is rounded three times. So `ORIENT2D` (1 - u)^3 must be at least
//!    ((1 - u)^-3 - 1) (1 + u). Shewchuk's constant is (3 + 16u) u; the rest pays for one more
//!    rounding, that of adding `UNDERFLOW`.
//! 2. **In circle, exact doubles.** Each term passes ten factors: four in the lift (two differences, a
//!    square, a sum), four in the minor, one in their product, one in the first sum. So
//!    |V - D| <= ((1 + u)^10 - 1) P. With the lifts A, B, C of the three points,
//!    |bx cy| + |by cx| <= (B + C) / 2 and so on, hence P <= A (B + C) + B C. That passes eleven factors
//!    when computed (two lifts, sum, product, sum), and the bound two more. So
//!    `IN_CIRCLE` (1 - u)^13 must be at least ((1 + u)^10 - 1) (1 + u).
//! 3. **Approximated doubles.** Differences are off by up to `error`, twice that of a coordinate. Let Q be P
//!    with every |d| made larger by `error`. Each term is a product of differences, so it changes by no
//!    more than its absolute value grows, and the true determinant is within Q - P of D. The code
//!    computes P as `least` and Q as `most`, never smaller. `least` passes 4 factors (orientation) or 11
//!    (in circle), `most` 6 or 15, the rest of the bound 3. With K for `ORIENT2D_APPROX` or
//!    `IN_CIRCLE_APPROX`, k for 3 or 10, l for 4 or 11 and m for 6 or 15
//!    (1 - u)^3 ((1 - u)^m (1 + K) Q - (1 + u)^l P) must be at least (1 + u) (Q - P + ((1 + u)^k - 1) P)
//!    for 0 <= P <= Q. Both sides are linear, so it is enough that it holds for P = 0 and for P = Q.
//! 4. **Underflow** of products, multiplied by at most 2^404 in later products, adds less than 2^-663
//!    to the determinant and to what the bound is computed from. `UNDERFLOW` covers both.
//!
//! A coordinate that is infinite or NaN, as those of the artificial points are, makes the determinant NaN
//! or the bound infinite. Then the filter decides nothing.
//!
//! Gappa checks the inequalities for the constants, the factors of each term and the bound on underflow
//! (`tests/proofs`). Checked by hand only: the number of factors, the inequality of the two means behind
//! P <= A (B + C) + B C, and that the error of a sum is at most the sum of the errors of its terms.
//!
//! Cost: about 2 ns (orientation) and 4 ns (in circle) for exact doubles, three times that for others.

use std::cmp::Ordering::{self, Greater, Less};

use super::doubles::{U, power};
use super::scale::Scale;

const ORIENT2D: f64 = (3.0 + 32.0 * U) * U;
const IN_CIRCLE: f64 = (10.0 + 256.0 * U) * U;
const ORIENT2D_APPROX: f64 = 14.0 * U;
const IN_CIRCLE_APPROX: f64 = 37.0 * U;
const UNDERFLOW: f64 = power(-660);

/// The orientation of `a`, `b`, `c`, if these doubles decide it: `Greater` for a left turn.
#[inline(always)]
pub(crate) fn orient2d([a, b, c]: [[f64; 2]; 3], scale: Scale) -> Option<Ordering> {
    let [ax, ay] = minus(a, c);
    let [bx, by] = minus(b, c);
    let (left, right) = (ax * by, ay * bx);
    let determinant = left - right;
    let bound = ORIENT2D * (left.abs() + right.abs()) + UNDERFLOW;
    if determinant.abs() > bound && scale.is_exact() {
        return Some(sign(determinant));
    }
    if scale.is_exact() {
        return None;
    }
    orient2d_approx(determinant, [ax, ay, bx, by], scale)
}

/// The side of the circle through `a`, `b`, `c` on which `d` lies, if these doubles decide it:
/// `Greater` for inside, where the three are counter-clockwise.
#[inline(always)]
pub(crate) fn in_circle([a, b, c, d]: [[f64; 2]; 4], scale: Scale) -> Option<Ordering> {
    let [ax, ay] = minus(a, d);
    let [bx, by] = minus(b, d);
    let [cx, cy] = minus(c, d);
    let (al, bl, cl) = (ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy);
    let determinant =
        al * (bx * cy - by * cx) - bl * (ax * cy - ay * cx) + cl * (ax * by - ay * bx);
    let bound = IN_CIRCLE * (al * (bl + cl) + bl * cl) + UNDERFLOW;
    if determinant.abs() > bound && scale.is_exact() {
        return Some(sign(determinant));
    }
    if scale.is_exact() {
        return None;
    }
    in_circle_approx(determinant, [ax, ay, bx, by, cx, cy], scale)
}

/// The orientation test for doubles that may be off.
#[cold]
#[inline(never)]
fn orient2d_approx(determinant: f64, differences: [f64; 4], scale: Scale) -> Option<Ordering> {
    let size = |[ax, ay, bx, by]: [f64; 4]| ax * by + ay * bx;
    let (least, most) = widen(differences, scale);
    let (least, most) = (size(least), size(most));
    let bound = (most - least) + ORIENT2D_APPROX * most + UNDERFLOW;
    (determinant.abs() > bound).then_some(sign(determinant))
}

/// The in-circle test for doubles that may be off.
#[cold]
#[inline(never)]
fn in_circle_approx(determinant: f64, differences: [f64; 6], scale: Scale) -> Option<Ordering> {
    let size = |[ax, ay, bx, by, cx, cy]: [f64; 6]| {
        (ax * ax + ay * ay) * (bx * cy + by * cx)
            + (bx * bx + by * by) * (ax * cy + ay * cx)
            + (cx * cx + cy * cy) * (ax * by + ay * bx)
    };
    let (least, most) = widen(differences, scale);
    let (least, most) = (size(least), size(most));
    let bound = (most - least) + IN_CIRCLE_APPROX * most + UNDERFLOW;
    (determinant.abs() > bound).then_some(sign(determinant))
}

#[inline(always)]
fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// The absolute values of differences, and the same made larger by what each may be off by.
fn widen<const N: usize>(differences: [f64; N], scale: Scale) -> ([f64; N], [f64; N]) {
    let error = 2.0 * scale.error();
    let least = differences.map(f64::abs);
    (least, least.map(|size| size + error))
}

/// The sign of a number that is certainly not zero.
#[inline(always)]
fn sign(determinant: f64) -> Ordering {
    if determinant > 0.0 { Greater } else { Less }
}

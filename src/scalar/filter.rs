//! Signs that are certain from doubles alone: the floating-point filter in front of exact arithmetic.
//!
//! Both tests evaluate the determinant of differences to the last point in doubles and compare it with
//! a bound on the error; they answer only if the sign is beyond doubt.
//!
//! Why it is right, with u = 2^-53 and coordinates x known through doubles X:
//!
//! 1. *Doubles that are the coordinates.* Without underflow the computed determinant differs from the
//!    true one by at most (3 + 16 u) u times the sum of the absolute products (orientation), or
//!    (10 + 96 u) u times the permanent, the determinant with every sign made plus (in-circle); that is
//!    bound A of Shewchuk (1997), which counts the rounding of the differences. The constants 4e-16
//!    and 1.2e-15 are these bounds with at least 8 % to spare for their own rounding.
//! 2. *Doubles near the coordinates.* By the contract of `approx`, |X - x| <= 2u |x|, or 2^-1022 below
//!    the normal doubles, so a difference is off by at most `slack` = 4.5 u M + 2^-1020, where M is the
//!    largest |X|. Each of the 2 products of 2 factors (12 products of 4) then changes by at most
//!    (m + slack)^2 - m^2 <= 2 slack (m + slack) (or 4 slack (m + slack)^3), where m bounds the
//!    differences. An infinite X makes the determinant NaN or m infinite, and nothing is decided; a
//!    value too large for a double whose X is finite makes the bound infinite.
//! 3. *Underflow* adds less than 2^-1072 (orientation) or 2^-1068 max(m^2, 1) (in-circle). For m in the
//!    ranges asked for, that is less than 2^-100 m^2 or 2^-100 m^4, which the bound contains; nor does
//!    anything overflow in them.
//!
//! Cost: about 3 ns (orientation) and 6 ns (in-circle).

use std::cmp::Ordering;

/// The orientation of `a`, `b`, `c` if the doubles decide it. `exact`: they are the coordinates
/// themselves, not approximations of them.
#[inline]
pub(crate) fn orient2d(a: [f64; 2], b: [f64; 2], c: [f64; 2], exact: bool) -> Option<Ordering> {
    let (ax, ay) = (a[0] - c[0], a[1] - c[1]);
    let (bx, by) = (b[0] - c[0], b[1] - c[1]);
    let (left, right) = (ax * by, ay * bx);
    let m = ax.abs().max(ay.abs()).max(bx.abs()).max(by.abs());
    let mut bound = 4e-16 * (left.abs() + right.abs()) + m * m * TINY;
    if !exact {
        let slack = slack(&[a, b, c]);
        bound += 4.1 * slack * (m + slack);
    }
    certain(left - right, bound, m > 1e-140 && m < 1e140)
}

/// The side of the circle through `a`, `b`, `c` on which `d` lies if the doubles decide it. `exact`:
/// they are the coordinates themselves, not approximations of them.
#[inline]
pub(crate) fn in_circle(
    a: [f64; 2],
    b: [f64; 2],
    c: [f64; 2],
    d: [f64; 2],
    exact: bool,
) -> Option<Ordering> {
    let (ax, ay) = (a[0] - d[0], a[1] - d[1]);
    let (bx, by) = (b[0] - d[0], b[1] - d[1]);
    let (cx, cy) = (c[0] - d[0], c[1] - d[1]);
    let (lift_a, lift_b, lift_c) = (ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy);
    let (bxcy, cxby) = (bx * cy, cx * by);
    let (cxay, axcy) = (cx * ay, ax * cy);
    let (axby, bxay) = (ax * by, bx * ay);
    let det = lift_a * (bxcy - cxby) + lift_b * (cxay - axcy) + lift_c * (axby - bxay);
    let permanent = lift_a * (bxcy.abs() + cxby.abs())
        + lift_b * (cxay.abs() + axcy.abs())
        + lift_c * (axby.abs() + bxay.abs());
    let lift = lift_a.max(lift_b).max(lift_c);
    let mut bound = 1.2e-15 * permanent + lift * lift * TINY;
    if !exact {
        // The largest difference is at most the root of the largest lift.
        let (slack, m) = (slack(&[a, b, c, d]), lift.sqrt() * (1.0 + 1e-14));
        bound += 49.0 * slack * (m + slack) * (m + slack) * (m + slack);
    }
    certain(det, bound, lift > 1e-140 && lift < 1e140)
}

/// 2^-100, and a little for the rounding of what it is multiplied with.
const TINY: f64 = 8e-31;

/// How far the difference of two approximated coordinates may be off before it is rounded.
#[inline]
fn slack<const N: usize>(points: &[[f64; 2]; N]) -> f64 {
    let largest = points
        .iter()
        .flatten()
        .fold(0.0, |m: f64, x| m.max(x.abs()));
    5e-16 * largest + 1e-307
}

#[inline]
fn certain(det: f64, bound: f64, in_range: bool) -> Option<Ordering> {
    if !in_range {
        None
    } else if det > bound {
        Some(Ordering::Greater)
    } else if -det > bound {
        Some(Ordering::Less)
    } else {
        None
    }
}

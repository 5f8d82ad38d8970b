//! The floating-point filter: signs of both determinants that are certain from doubles alone.
//!
//! Each test compares a determinant of differences in doubles with a bound on its error. Where the sign is in doubt,
//! the scalar's exact stages decide. The bounds are of the kind of Shewchuk's bound A (1997, sections 4.3 and 4.4): one
//! evaluation, its error against the sum of the sizes of the terms. In circle a cheaper sum replaces this one.
//!
//! ```text
//!        p         The in-circle determinant of p, a, b and q is -sin(alpha + beta), in lengths, of the angles at p
//!      / a \       and q between a and b: q is inside the circle where they are more than pi together. With cross
//!     a-----b      and dot products of the differences to p and to q, sin(alpha + beta) is
//!      \ b /       cross_p dot_q - dot_p cross_q. p and q take the same operations, so each has a lane of a register.
//!        q         Where one of the four is far from the others, as in a fan along a circle, these terms are far
//!                  smaller than those of the lifted points.
//! ```
//!
//! Why it is right: the factors by which each term is rounded are counted, and the constants are at least what the
//! counts ask for. docs/proofs/filter.md has the proof, and Gappa checks its inequalities (`tests/proofs.gappa`). On a
//! coarse [lattice](super::lattice) the determinants are exact, zero included. Infinite or NaN coordinates (artificial
//! points, points far outside) make the bound infinite or NaN: no sign results.
//! Cost: some 15 operations for an orientation and 25 in circle with exact doubles, about three times as many for others.

use core::cmp::Ordering::{self, Greater, Less};

use super::doubles::U;
use super::lanes::Lanes;
use super::scale::{Scale, UNDERFLOW};

const ORIENT2D: f64 = (3.0 + 32.0 * U) * U;
const IN_CIRCLE: f64 = (9.0 + 256.0 * U) * U;
const ORIENT2D_APPROX: f64 = 14.0 * U;
const IN_CIRCLE_APPROX: f64 = 37.0 * U;

/// The orientation of `a`, `b`, `c`, if these doubles are the coordinates and decide it: `Greater` for a left turn.
#[inline(always)]
pub(crate) fn orient2d([a, b, c]: [[f64; 2]; 3], scale: Scale) -> Option<Ordering> {
    let [ax, ay] = minus(a, c);
    let [bx, by] = minus(b, c);
    let (left, right) = (ax * by, ay * bx);
    let determinant = left - right;
    let bound = ORIENT2D * (left.abs() + right.abs()) + scale.underflow_bound();
    if determinant.abs() > bound {
        return Some(sign(determinant));
    }
    None
}

/// The side of the circle through `p`, `a`, `b` on which `q` lies, if these doubles are the coordinates and decide it:
/// `Greater` for inside, where the three are counter-clockwise.
#[inline(always)]
pub(crate) fn in_circle([p, a, b, q]: [[f64; 2]; 4], scale: Scale) -> Option<Ordering> {
    // Differences to p in the low lanes, differences to q in the high ones.
    let [p, a, b, q] = [p, a, b, q].map(Lanes::new);
    let (x, y) = (p.lows(q), p.highs(q));
    let (ax, ay) = (a.lows(a) - x, a.highs(a) - y);
    let (bx, by) = (b.lows(b) - x, b.highs(b) - y);
    let cross = ax * by - ay * bx;
    let dot = ax * bx + ay * by;
    let products = cross * dot.swapped();
    let determinant = products.high() - products.low();
    let size = (ax.abs() + ay.abs()) * (bx.abs() + by.abs());
    let bound = IN_CIRCLE * (size.low() * size.high()) + scale.underflow_bound();
    if determinant.abs() > bound {
        return Some(sign(determinant));
    }
    None
}

/// The orientation of `a`, `b`, `c` if their lattice is so coarse that the determinant is not rounded.
pub(crate) fn orient2d_on_lattice([a, b, c]: [[f64; 2]; 3], scale: &Scale) -> Option<Ordering> {
    if !scale.lattice().has_exact_orient2d() {
        return None;
    }
    let ([ax, ay], [bx, by]) = (minus(a, c), minus(b, c));
    (ax * by).partial_cmp(&(ay * bx))
}

/// The in-circle sign of `a`, `b`, `c`, `d` if their lattice is so coarse that the determinant is not rounded.
pub(crate) fn in_circle_on_lattice([a, b, c, d]: [[f64; 2]; 4], scale: &Scale) -> Option<Ordering> {
    if !scale.lattice().has_exact_in_circle() {
        return None;
    }
    lifted([minus(a, d), minus(b, d), minus(c, d)]).partial_cmp(&0.0)
}

/// The orientation of points whose doubles may be off. For exact doubles [`orient2d`] decides at least as much.
#[cold]
#[inline(never)]
pub(crate) fn orient2d_approx([a, b, c]: [[f64; 2]; 3], scale: &Scale) -> Option<Ordering> {
    let [[ax, ay], [bx, by]] = [minus(a, c), minus(b, c)];
    let determinant = ax * by - ay * bx;
    let size = |[[ax, ay], [bx, by]]: [[f64; 2]; 2]| ax * by + ay * bx;
    let (least, most) = widen([a, b], c, scale);
    let (least, most) = (size(least), size(most));
    let bound = (most - least) + ORIENT2D_APPROX * most + UNDERFLOW;
    (determinant.abs() > bound).then_some(sign(determinant))
}

/// The in-circle sign of points whose doubles may be off. For exact doubles [`in_circle`] decides at least as much.
#[cold]
#[inline(never)]
pub(crate) fn in_circle_approx([a, b, c, d]: [[f64; 2]; 4], scale: &Scale) -> Option<Ordering> {
    let determinant = lifted([minus(a, d), minus(b, d), minus(c, d)]);
    let size = |[[ax, ay], [bx, by], [cx, cy]]: [[f64; 2]; 3]| {
        (ax * ax + ay * ay) * (bx * cy + by * cx)
            + (bx * bx + by * by) * (ax * cy + ay * cx)
            + (cx * cx + cy * cy) * (ax * by + ay * bx)
    };
    let (least, most) = widen([a, b, c], d, scale);
    let (least, most) = (size(least), size(most));
    let bound = (most - least) + IN_CIRCLE_APPROX * most + UNDERFLOW;
    (determinant.abs() > bound).then_some(sign(determinant))
}

/// The in-circle determinant of three differences, from lifted points.
#[inline(always)]
fn lifted([[ax, ay], [bx, by], [cx, cy]]: [[f64; 2]; 3]) -> f64 {
    let (al, bl, cl) = (ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy);
    al * (bx * cy - by * cx) - bl * (ax * cy - ay * cx) + cl * (ax * by - ay * bx)
}

#[inline(always)]
fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// The absolute values of the differences of points to a last one, and these made larger by what each may be off.
fn widen<const N: usize>(
    points: [[f64; 2]; N],
    last: [f64; 2],
    scale: &Scale,
) -> ([[f64; 2]; N], [[f64; 2]; N]) {
    let least = points.map(|p| minus(p, last).map(f64::abs));
    let mut most = least;
    for (size, p) in most.iter_mut().zip(points) {
        for i in 0..2 {
            size[i] += scale.error(p[i], last[i]);
        }
    }
    (least, most)
}

/// The sign of a number that is certainly not zero.
#[inline(always)]
fn sign(determinant: f64) -> Ordering {
    if determinant > 0.0 { Greater } else { Less }
}

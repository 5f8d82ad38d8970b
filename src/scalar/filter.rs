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
//! # Why it is right
//! Write u for 2^-53. A sum or difference is rounded by a factor 1 + e with |e| <= u, a product by such a factor and an
//! underflow of at most 2^-1075. Let d stand for the differences of the doubles before rounding, D for their
//! determinant, P for the sum of the absolute values of its terms, and V for the computed determinant before its last
//! rounding, which changes no sign and makes it at most 1 + u times as large. No test of finite doubles overflows: they
//! are below 2^200 in size ([`Scale`]), differences below 2^201, and fourth powers far below 2^1023.
//!
//! 1. **Orientation, exact doubles.** Each product is off by three factors 1 + e (two differences, one product),
//!    so |V - D| <= ((1 - u)^-3 - 1) S, where S is the sum of the absolute values of the two computed products. The
//!    bound is rounded three times. So `ORIENT2D` (1 - u)^3 must be at least ((1 - u)^-3 - 1) (1 + u). Shewchuk's
//!    constant is (3 + 16u) u; the rest pays for one more rounding, that of adding `UNDERFLOW`.
//! 2. **In circle, exact doubles.** Each of the eight terms passes nine factors: four in the cross product (two
//!    differences, a product, a sum), four in the dot product, one in their product. So |V - D| <= ((1 + u)^9 - 1) P.
//!    Let A and B be |x| + |y| of the two differences to p, E and F of those to q. The sizes of the terms of both
//!    products at p add up to A B, at q to E F, so P <= A B E F. That passes eleven factors (four differences, four
//!    sums, three products), the bound two more. So `IN_CIRCLE` (1 - u)^13 must be at least ((1 + u)^9 - 1) (1 + u).
//! 3. **Approximated doubles.** The points are lifted, and the last one is subtracted from the others. Each difference
//!    is off by up to its own [`Scale::error`]. Let Q be P with every |d| made larger by that error. Each term is a
//!    product of differences, so it changes by no more than its absolute value grows, and the true determinant is
//!    within Q - P of D. The code computes P as `least` and Q as `most`, never smaller. `least` passes 4 factors
//!    (orientation) or 11 (in circle), `most` 6 or 15, the rest of the bound 3. With K for `ORIENT2D_APPROX` or
//!    `IN_CIRCLE_APPROX`, k for 3 or 10, l for 4 or 11 and m for 6 or 15, (1 - u)^3 ((1 - u)^m (1 + K) Q - (1 + u)^l P)
//!    must be at least (1 + u) (Q - P + ((1 + u)^k - 1) P) for 0 <= P <= Q; as it is linear, for P = 0 and P = Q.
//! 4. **Underflow** of products, multiplied by at most 2^404 in later products, adds less than 2^-663 to the
//!    determinant and to what the bound is computed from. `UNDERFLOW` covers both.
//! 5. **Lattices.** On a coarse lattice ([`super::lattice`]) the determinants are exact, zero included.
//!
//! Infinite or NaN coordinates (artificial points, points far outside) make the bound infinite or NaN: no sign results.
//!
//! Gappa checks the inequalities for the constants, the factors of each term and the bound on underflow
//! (`tests/proofs.gappa`). Checked by hand only: the number of factors, P <= A B E F, and that the error of a sum is at
//! most the sum of the errors of its terms. A test with integers shows that both in-circle determinants have one sign.
//! Cost: about 2 ns (orientation) and 4 ns (in circle) for exact doubles, three times that for others.

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
    let (determinant, _) = lifted([minus(a, d), minus(b, d), minus(c, d)]);
    determinant.partial_cmp(&0.0)
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
    let (determinant, _) = lifted([minus(a, d), minus(b, d), minus(c, d)]);
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

/// The determinant of three differences and their lifts; and the lifts.
#[inline(always)]
fn lifted([[ax, ay], [bx, by], [cx, cy]]: [[f64; 2]; 3]) -> (f64, [f64; 3]) {
    let (al, bl, cl) = (ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy);
    let determinant =
        al * (bx * cy - by * cx) - bl * (ax * cy - ay * cx) + cl * (ax * by - ay * bx);
    (determinant, [al, bl, cl])
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

#[cfg(test)]
mod tests {
    use super::{Scale, in_circle, in_circle_on_lattice, orient2d_on_lattice};

    /// Points near the corners of the widest square, many of them on one circle, against integers.
    #[test]
    fn determinants_are_exact_on_the_coarsest_lattice() {
        let widest = 4096;
        let mut state = 1_u64;
        let mut random = |below: u64| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            ((state >> 33) % below).cast_signed()
        };
        let mut ties = 0;
        for _ in 0..20_000 {
            let near = random(3);
            let mut coordinate = || {
                let far = if random(2) == 0 { near } else { widest - near };
                (far + random(8) / 7).min(widest)
            };
            let points = [(); 4].map(|()| [coordinate(), coordinate()]);
            let unit = 2_f64.powi(-3);
            let doubles = points.map(|p| p.map(|x| 1e9 + x as f64 * unit));
            let scale = Scale::exact(4, |i| doubles[i]);
            let [a, b, c, d] = points.map(|p| p.map(i128::from));
            let [a, b, c] = [a, b, c].map(|p| [p[0] - d[0], p[1] - d[1]]);
            let minor = |p: [i128; 2], q: [i128; 2]| p[0] * q[1] - p[1] * q[0];
            let lift = |p: [i128; 2]| p[0] * p[0] + p[1] * p[1];
            let determinant = lift(a) * minor(b, c) - lift(b) * minor(a, c) + lift(c) * minor(a, b);
            ties += i32::from(determinant == 0);
            let [e, f, g, _] = doubles;
            assert_eq!(
                in_circle_on_lattice(doubles, &scale),
                Some(determinant.cmp(&0)),
                "{points:?}"
            );
            match in_circle(doubles, scale) {
                Some(sign) => assert_eq!(sign, determinant.cmp(&0), "{points:?}"),
                // The bound is at most 9 * 2^-53 times the product of four sums of two differences.
                None => assert!(determinant.abs() < 6, "{points:?}"),
            }
            let turn = minor([a[0] - c[0], a[1] - c[1]], [b[0] - c[0], b[1] - c[1]]);
            let found = orient2d_on_lattice([e, f, g], &scale);
            assert_eq!(found, Some(turn.cmp(&0)), "{points:?}");
        }
        assert!(ties > 1000, "{ties}");
    }
}

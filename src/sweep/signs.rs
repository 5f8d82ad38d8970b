//! Every decision of the sweep: exact signs on ranks, with a floating-point filter in front of the
//! scalar, the canonical rule behind it, and the artificial points beside it.
//!
//! **Artificial points** (section 3.3, figure 6). The paper puts P-1 and P-2 a factor alpha outside the
//! data; any finite place makes some hull edge wrong. Here they are directions: P-1 is (-1, 0), P-2 is
//! (+1, -epsilon), the ends of a sweep line that is tilted just enough to order equal y. Tests with
//! one of them are decided by rule:
//! - an edge whose opposite vertex is artificial stays (no circle reaches out so far);
//! - an edge with an artificial end is flipped exactly if the three real vertices around it turn left
//!   strictly, for then its real end is not on the lower hull. So the lower hull is exact at every
//!   moment (the walk of figure 15b and c happens on the way).
//!
//! Their coordinates are infinite and NaN, so that every filter fails on them and the hot path need
//! not know them.
//!
//! **Canonical rule.** Of four points on one circle the edge stays that has the leftmost of them (the
//! upper one of two) for an end. That is the sign of the in-circle test after the points lifted to the
//! paraboloid are lowered symbolically, the leftmost most of all (a pulling triangulation), so that no
//! two triangulations tie and Lawson's flips still end.
//!
//! **Filter.** See [`Scale`] for what the doubles are. With `e = 2^-53` an in-circle determinant of
//! differences as computed below is off by at most `(10 + 96e) e P` (Shewchuk 1997, section 4.4: same
//! expression), where `P` is the sum of the terms' absolute values. With `l`, `r`, `q` the lifts
//! (squared lengths) of the three differences and `|ax by| + |ay bx| <= (l + r) / 2`, `P` is at most
//! `l (r + q) + r q`. `1.2e-15 > (1 + 10e)(10 + 96e) e` leaves room for the rounding of that bound.
//! For the orientation test the constant is Shewchuk's `(3 + 16e) e`. Underflow adds at most 2^-1074
//! a product, multiplied by at most (2^202)^2: less than 2^-660.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use crate::Scalar;
use crate::input::Vertices;
use crate::mesh::{VertexId, index};
use crate::probe::Probe;

const IN_CIRCLE_BOUND: f64 = 1.2e-15;
const ORIENT2D_BOUND: f64 = (3.0 + 16.0 * (f64::EPSILON / 2.0)) * (f64::EPSILON / 2.0);
/// 2^-660: more than what underflow can add.
const UNDERFLOW: f64 = f64::from_bits((1023 - 660) << 52);

/// How the doubles that filter and steer relate to the coordinates.
///
/// They are the scalar's approximations, all multiplied by one power of two where the largest is
/// outside 2^-120 to 2^200, so that no product overflows. `error` bounds what each may be off by.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    factor: f64,
    error: f64,
}

impl Scale {
    /// Power of two `2^exponent`, if that is a normal double.
    fn power(exponent: i64) -> f64 {
        f64::from_bits(u64::try_from(exponent + 1023).expect("a normal exponent") << 52)
    }

    /// The scale for these approximations, which are the values themselves if `exact`.
    pub(crate) fn of(approximations: impl Iterator<Item = f64>, exact: bool) -> Scale {
        let (small, large) = approximations
            .map(f64::abs)
            .fold((f64::INFINITY, 0.0_f64), |(small, large), c| {
                (if c > 0.0 { small.min(c) } else { small }, large.max(c))
            });
        if large.is_infinite() {
            return Scale {
                factor: 1.0,
                error: f64::INFINITY,
            };
        }
        let mut factor = 1.0;
        if large > 0.0 && !(Scale::power(-120)..=Scale::power(200)).contains(&large) {
            // Brings the largest near 1, as far as one factor can.
            let exponent = (large.to_bits() >> 52).cast_signed() - 1023;
            factor = Scale::power((-exponent).clamp(-1022, 1000));
        }
        // Below 2^-960 a scaled value may have lost digits.
        let is_kept = factor.to_bits() == 1.0_f64.to_bits() || small * factor > Scale::power(-960);
        if exact && is_kept {
            return Scale { factor, error: 0.0 };
        }
        // One unit in the last place of the largest covers rounding and, far below, underflow.
        Scale {
            factor,
            error: (large * factor * f64::EPSILON).max(f64::MIN_POSITIVE),
        }
    }

    /// The double for a coordinate with this approximation.
    #[inline(always)]
    pub(crate) fn near(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x * self.factor, y * self.factor]
    }

    /// Whether the doubles are the coordinates, up to the factor.
    #[inline(always)]
    pub(crate) fn is_exact(&self) -> bool {
        self.error == 0.0
    }
}

/// The exact signs, by rank. The artificial points have the two ranks after the last vertex.
#[derive(Debug)]
pub(crate) struct Predicates<'a, S, P> {
    points: &'a [[S; 2]],
    pub(crate) vertices: Vertices,
    pub(crate) left: VertexId,
    pub(crate) right: VertexId,
    pub(crate) probe: P,
}

impl<'a, S: Scalar, P: Probe> Predicates<'a, S, P> {
    pub(crate) fn new(points: &'a [[S; 2]], mut vertices: Vertices, probe: P) -> Self {
        let left = index(vertices.input.len());
        vertices.near.push([f64::NEG_INFINITY, f64::NAN]);
        vertices.near.push([f64::INFINITY, f64::NAN]);
        Predicates {
            points,
            vertices,
            left,
            right: left + 1,
            probe,
        }
    }

    /// The double near the coordinates of a vertex; infinite x and NaN for an artificial one.
    #[inline(always)]
    pub(crate) fn near(&self, v: VertexId) -> [f64; 2] {
        self.vertices.near[v as usize]
    }

    #[inline(always)]
    pub(crate) fn is_artificial(&self, v: VertexId) -> bool {
        v >= self.left
    }

    fn exact(&self, v: VertexId) -> &'a [S; 2] {
        &self.points[self.vertices.input[v as usize] as usize]
    }

    /// Order by x; P-1 before and P-2 after all.
    #[inline(always)]
    pub(crate) fn compare_x(&self, a: VertexId, b: VertexId) -> Ordering {
        let (x, y) = (self.near(a)[0], self.near(b)[0]);
        if x < y {
            Less
        } else if x > y {
            Greater
        } else {
            self.compare_near_x(a, b)
        }
    }

    fn compare_near_x(&self, a: VertexId, b: VertexId) -> Ordering {
        if self.vertices.scale.is_exact() {
            return Equal;
        }
        let side = |v| i8::from(v == self.right) - i8::from(v == self.left);
        match side(a).cmp(&side(b)) {
            Equal if !self.is_artificial(a) => self.exact(a)[0].compare(&self.exact(b)[0]),
            order => order,
        }
    }

    /// `Greater` if the vertices `a`, `b`, `c`, all real, turn left.
    #[inline(always)]
    pub(crate) fn orient2d(&mut self, a: VertexId, b: VertexId, c: VertexId) -> Ordering {
        let [[ax, ay], [bx, by], [cx, cy]] = [self.near(a), self.near(b), self.near(c)];
        let (left, right) = ((ax - cx) * (by - cy), (ay - cy) * (bx - cx));
        let determinant = left - right;
        let bound = ORIENT2D_BOUND * (left.abs() + right.abs()) + UNDERFLOW;
        if determinant.abs() > bound && self.vertices.scale.is_exact() {
            self.probe.count(|c| c.orient2d_filtered += 1);
            return if determinant > 0.0 { Greater } else { Less };
        }
        self.orient2d_near(a, b, c)
    }

    /// The orientation test where the quick filter does not decide.
    #[cold]
    #[inline(never)]
    fn orient2d_near(&mut self, a: VertexId, b: VertexId, c: VertexId) -> Ordering {
        let error = 2.0 * self.vertices.scale.error;
        if error > 0.0 {
            let [[ax, ay], [bx, by], [cx, cy]] = [self.near(a), self.near(b), self.near(c)];
            let differences = [ax - cx, by - cy, ay - cy, bx - cx];
            let determinant = differences[0] * differences[1] - differences[2] * differences[3];
            let size = |[a, b, c, d]: [f64; 4]| a * b + c * d;
            let (least, most) = widen(differences, error);
            if determinant.abs() > perturbed(size(least), size(most)) {
                self.probe.count(|c| c.orient2d_filtered += 1);
                return if determinant > 0.0 { Greater } else { Less };
            }
        }
        self.probe.count(|c| c.orient2d_exact += 1);
        S::orient2d(self.exact(a), self.exact(b), self.exact(c))
    }

    /// Which side of the ray from `from` towards `to` the vertex `v` is on: `Greater` for the left.
    /// `to` is real and of lower rank than `from`; `v` may be artificial.
    pub(crate) fn side(&mut self, from: VertexId, to: VertexId, v: VertexId) -> Ordering {
        if self.is_artificial(v) {
            self.probe.count(|c| c.symbolic += 1);
            // The ray points below the tilted sweep line, whose ends P-1 and P-2 are.
            return if v == self.left { Less } else { Greater };
        }
        if v == to {
            Equal
        } else {
            self.orient2d(from, to, v)
        }
    }

    /// Whether the side `a`-`b` between the counter-clockwise triangle `p`, `a`, `b` and the vertex `q`
    /// across it must be flipped (figure 3).
    #[inline(always)]
    pub(crate) fn must_flip(&mut self, p: VertexId, a: VertexId, b: VertexId, q: VertexId) -> bool {
        let [px, py] = self.near(p);
        let [ax, ay] = self.near(a);
        let [bx, by] = self.near(b);
        let [qx, qy] = self.near(q);
        let (ax, ay, bx, by, qx, qy) = (ax - px, ay - py, bx - px, by - py, qx - px, qy - py);
        let (al, bl, ql) = (ax * ax + ay * ay, bx * bx + by * by, qx * qx + qy * qy);
        let determinant =
            bl * (ax * qy - ay * qx) - al * (bx * qy - by * qx) - ql * (ax * by - ay * bx);
        let bound = IN_CIRCLE_BOUND * (al * (bl + ql) + bl * ql) + UNDERFLOW;
        if determinant.abs() > bound && self.vertices.scale.is_exact() {
            self.probe.count(|c| c.in_circle_filtered += 1);
            return determinant > 0.0;
        }
        self.must_flip_near(p, a, b, q)
    }

    /// The test of a side where the quick filter does not decide.
    #[cold]
    #[inline(never)]
    fn must_flip_near(&mut self, p: VertexId, a: VertexId, b: VertexId, q: VertexId) -> bool {
        if [p, a, b, q].iter().any(|&v| self.is_artificial(v)) {
            self.probe.count(|c| c.symbolic += 1);
            return if self.is_artificial(p) || self.is_artificial(q) {
                false
            } else if self.is_artificial(a) {
                self.orient2d(q, b, p) == Greater
            } else {
                self.orient2d(p, a, q) == Greater
            };
        }
        if let Some(inside) = self.in_circle_near(p, a, b, q) {
            self.probe.count(|c| c.in_circle_filtered += 1);
            return inside;
        }
        self.probe.count(|c| c.in_circle_exact += 1);
        match S::in_circle(self.exact(a), self.exact(b), self.exact(p), self.exact(q)) {
            Greater => true,
            Less => false,
            Equal => {
                self.probe.count(|c| c.cocircular += 1);
                let of_edge = self.leftmost(a, b);
                self.leftmost(self.leftmost(p, q), of_edge) != of_edge
            }
        }
    }

    /// The in-circle filter for doubles that are only near the coordinates.
    fn in_circle_near(&self, p: VertexId, a: VertexId, b: VertexId, q: VertexId) -> Option<bool> {
        let error = 2.0 * self.vertices.scale.error;
        if error == 0.0 {
            return None;
        }
        let [px, py] = self.near(p);
        let [[ax, ay], [bx, by], [qx, qy]] =
            [a, b, q].map(|v| [self.near(v)[0] - px, self.near(v)[1] - py]);
        let determinant = (bx * bx + by * by) * (ax * qy - ay * qx)
            - (ax * ax + ay * ay) * (bx * qy - by * qx)
            - (qx * qx + qy * qy) * (ax * by - ay * bx);
        let size = |[ax, ay, bx, by, qx, qy]: [f64; 6]| {
            (bx * bx + by * by) * (ax * qy + ay * qx)
                + (ax * ax + ay * ay) * (bx * qy + by * qx)
                + (qx * qx + qy * qy) * (ax * by + ay * bx)
        };
        let (least, most) = widen([ax, ay, bx, by, qx, qy], error);
        let bound = perturbed(size(least), size(most));
        (determinant.abs() > bound).then_some(determinant > 0.0)
    }

    /// The leftmost of two vertices, the upper one where x is equal.
    fn leftmost(&self, a: VertexId, b: VertexId) -> VertexId {
        match self.compare_x(a, b) {
            Less => a,
            Greater => b,
            Equal => a.max(b),
        }
    }
}

/// Absolute values of differences, and the same made larger by what each may be off by.
fn widen<const N: usize>(differences: [f64; N], error: f64) -> ([f64; N], [f64; N]) {
    (
        differences.map(f64::abs),
        differences.map(|d| d.abs() + error),
    )
}

/// What a determinant may be off by when its differences are.
///
/// `least` is the sum of the absolute values of its terms, `most` the same for differences made larger
/// by their error. Each term is a product of differences, so its change is at most the change of its
/// absolute value under that growth, and the sum at most `most - least`. Twice the usual constant times
/// `most` covers all rounding, that of this bound included.
fn perturbed(least: f64, most: f64) -> f64 {
    (most - least) + 2.0 * IN_CIRCLE_BOUND * most + UNDERFLOW
}

//! Every decision of the sweep: exact signs on ranks, with a floating-point filter in front of the
//! scalar and the canonical rule behind it. Tests with an artificial point are decided by the rules of
//! [`super::artificial`].
//!
//! **Canonical rule.** Of four points on one circle the side stays that has the leftmost of them (the
//! upper one of two) for an end. That is the sign of the in-circle test after the points lifted to the
//! paraboloid are lowered symbolically, the leftmost most of all (a pulling triangulation). So no two
//! triangulations tie, and Lawson's flips still end.
//!
//! **Filter.** See [`Scale`] for what the doubles are. With `e = 2^-53` an in-circle determinant of
//! differences as computed below is off by at most `(10 + 96e) e P` (Shewchuk 1997, section 4.4: same
//! expression), where `P` is the sum of the terms' absolute values. With `l`, `r`, `q` the lifts
//! (squared lengths) of the three differences and `|ax by| + |ay bx| <= (l + r) / 2`, `P` is at most
//! `l (r + q) + r q`. `1.2e-15 > (1 + 10e)(10 + 96e) e` leaves room for the rounding of that bound.
//! For the orientation test the constant is Shewchuk's `(3 + 16e) e`. Underflow adds at most 2^-1074
//! a product, multiplied by at most (2^202)^2: less than 2^-660.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use super::artificial::{self, Artificial};
use super::vertices::Vertices;
use crate::ids::VertexId;
use crate::probe::Probe;
use crate::scalar::Scalar;

const IN_CIRCLE_BOUND: f64 = 1.2e-15;
const ORIENT2D_BOUND: f64 = (3.0 + 16.0 * (f64::EPSILON / 2.0)) * (f64::EPSILON / 2.0);
/// 2^-660: more than what underflow can add.
const UNDERFLOW: f64 = f64::from_bits((1023 - 660) << 52);

/// The exact signs, by rank; what decided them is counted by a probe that the caller passes.
#[derive(Debug)]
pub(super) struct Signs<'a, S> {
    points: &'a [[S; 2]],
    pub(super) vertices: Vertices,
    pub(super) artificial: Artificial,
}

impl<'a, S: Scalar> Signs<'a, S> {
    /// The signs of these points, whose sorted and merged vertices are given.
    pub(super) fn new(points: &'a [[S; 2]], mut vertices: Vertices) -> Self {
        let artificial = Artificial::beside(vertices.len());
        vertices.approx.extend(artificial::APPROX);
        Signs {
            points,
            vertices,
            artificial,
        }
    }

    /// The approximated coordinates of a vertex; infinite x and NaN for an artificial one.
    #[inline(always)]
    pub(super) fn approx(&self, v: VertexId) -> [f64; 2] {
        self.vertices.approx[v.index()]
    }

    #[inline(always)]
    pub(super) fn is_artificial(&self, v: VertexId) -> bool {
        self.artificial.contains(v)
    }

    fn exact(&self, v: VertexId) -> &'a [S; 2] {
        &self.points[self.vertices.input[v.index()] as usize]
    }

    /// Order by x; P-1 before and P-2 after all.
    #[inline(always)]
    pub(super) fn compare_x(&self, a: VertexId, b: VertexId) -> Ordering {
        let (x, y) = (self.approx(a)[0], self.approx(b)[0]);
        if x < y {
            Less
        } else if x > y {
            Greater
        } else {
            self.compare_equal_x(a, b)
        }
    }

    /// Order by x of vertices whose approximated x are equal.
    fn compare_equal_x(&self, a: VertexId, b: VertexId) -> Ordering {
        if self.vertices.scale.is_exact() {
            return Equal;
        }
        match self.artificial.compare_x(a, b) {
            Equal if !self.is_artificial(a) => self.exact(a)[0].compare(&self.exact(b)[0]),
            order => order,
        }
    }

    /// `Greater` if the vertices `a`, `b`, `c`, all real, turn left.
    #[inline(always)]
    pub(super) fn orient2d(&self, [a, b, c]: [VertexId; 3], probe: &mut impl Probe) -> Ordering {
        let [[ax, ay], [bx, by], [cx, cy]] = [self.approx(a), self.approx(b), self.approx(c)];
        let (left, right) = ((ax - cx) * (by - cy), (ay - cy) * (bx - cx));
        let determinant = left - right;
        let bound = ORIENT2D_BOUND * (left.abs() + right.abs()) + UNDERFLOW;
        if determinant.abs() > bound && self.vertices.scale.is_exact() {
            probe.count(|c| c.orient2d_filtered += 1);
            return if determinant > 0.0 { Greater } else { Less };
        }
        self.orient2d_exact([a, b, c], probe)
    }

    /// The orientation test where the quick filter does not decide.
    #[cold]
    #[inline(never)]
    fn orient2d_exact(&self, [a, b, c]: [VertexId; 3], probe: &mut impl Probe) -> Ordering {
        let error = 2.0 * self.vertices.scale.error;
        if error > 0.0 {
            let [[ax, ay], [bx, by], [cx, cy]] = [self.approx(a), self.approx(b), self.approx(c)];
            let differences = [ax - cx, by - cy, ay - cy, bx - cx];
            let determinant = differences[0] * differences[1] - differences[2] * differences[3];
            let size = |[a, b, c, d]: [f64; 4]| a * b + c * d;
            let (least, most) = widen(differences, error);
            if determinant.abs() > perturbed(size(least), size(most)) {
                probe.count(|c| c.orient2d_filtered += 1);
                return if determinant > 0.0 { Greater } else { Less };
            }
        }
        probe.count(|c| c.orient2d_exact += 1);
        S::orient2d(self.exact(a), self.exact(b), self.exact(c))
    }

    /// Which side of the ray from `from` towards `to` the vertex `v` is on: `Greater` for the left.
    /// `to` is real and of lower rank than `from`; `v` may be artificial.
    pub(super) fn side(
        &self,
        [from, to]: [VertexId; 2],
        v: VertexId,
        probe: &mut impl Probe,
    ) -> Ordering {
        if self.is_artificial(v) {
            probe.count(|c| c.symbolic += 1);
            return self.artificial.side_of_ray(v);
        }
        if v == to {
            Equal
        } else {
            self.orient2d([from, to, v], probe)
        }
    }

    /// Whether the side `a`-`b` between the counter-clockwise triangle `p`, `a`, `b` and the vertex `q`
    /// across it must be flipped (figure 3).
    #[inline(always)]
    pub(super) fn must_flip(
        &self,
        [p, a, b]: [VertexId; 3],
        q: VertexId,
        probe: &mut impl Probe,
    ) -> bool {
        let [px, py] = self.approx(p);
        let [ax, ay] = self.approx(a);
        let [bx, by] = self.approx(b);
        let [qx, qy] = self.approx(q);
        let (ax, ay, bx, by, qx, qy) = (ax - px, ay - py, bx - px, by - py, qx - px, qy - py);
        let (al, bl, ql) = (ax * ax + ay * ay, bx * bx + by * by, qx * qx + qy * qy);
        let determinant =
            bl * (ax * qy - ay * qx) - al * (bx * qy - by * qx) - ql * (ax * by - ay * bx);
        let bound = IN_CIRCLE_BOUND * (al * (bl + ql) + bl * ql) + UNDERFLOW;
        if determinant.abs() > bound && self.vertices.scale.is_exact() {
            probe.count(|c| c.in_circle_filtered += 1);
            return determinant > 0.0;
        }
        self.must_flip_exact([p, a, b], q, probe)
    }

    /// The test of a side where the quick filter does not decide.
    #[cold]
    #[inline(never)]
    fn must_flip_exact(
        &self,
        [p, a, b]: [VertexId; 3],
        q: VertexId,
        probe: &mut impl Probe,
    ) -> bool {
        if [p, a, b, q].iter().any(|&v| self.is_artificial(v)) {
            probe.count(|c| c.symbolic += 1);
            return if self.is_artificial(p) || self.is_artificial(q) {
                false
            } else if self.is_artificial(a) {
                self.orient2d([q, b, p], probe) == Greater
            } else {
                self.orient2d([p, a, q], probe) == Greater
            };
        }
        if let Some(inside) = self.in_circle_approximated([p, a, b], q) {
            probe.count(|c| c.in_circle_filtered += 1);
            return inside;
        }
        probe.count(|c| c.in_circle_exact += 1);
        match S::in_circle(self.exact(a), self.exact(b), self.exact(p), self.exact(q)) {
            Greater => true,
            Less => false,
            Equal => {
                probe.count(|c| c.cocircular += 1);
                let of_side = self.leftmost(a, b);
                self.leftmost(self.leftmost(p, q), of_side) != of_side
            }
        }
    }

    /// The in-circle filter for doubles that only approximate the coordinates.
    fn in_circle_approximated(&self, [p, a, b]: [VertexId; 3], q: VertexId) -> Option<bool> {
        let error = 2.0 * self.vertices.scale.error;
        if error == 0.0 {
            return None;
        }
        let [px, py] = self.approx(p);
        let [[ax, ay], [bx, by], [qx, qy]] =
            [a, b, q].map(|v| [self.approx(v)[0] - px, self.approx(v)[1] - py]);
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

//! The decisions of the sweep as exact signs, with vertices named by rank; the empty circle test of section
//! 2 (figures 2 and 3) is [`Signs::must_flip`].
//!
//! **Stages.** The floating-point [`filter`] decides most signs from doubles. The scalar decides the others
//! exactly. Rules decide the tests with an artificial point ([`super::artificial`]).
//!
//! **Canonical rule.** Where four points lie on one circle, the side stays that ends at the leftmost of
//! them (the upper one of two). This is the sign of the in-circle test after each point, lifted to the
//! paraboloid, is lowered by a symbolic amount, the leftmost one most of all (a pulling triangulation). So
//! there is one Delaunay triangulation, and Lawson's flips still end.
//!
//! Differs from the paper: it does not say how signs are computed, nor what happens in a tie.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use super::artificial::{self, Artificial};
use super::vertices::Vertices;
use crate::ids::{VertexId, narrow};
use crate::probe::Probe;
use crate::scalar::{Scalar, Scale, Stage, WholePoints, filter};

/// The exact signs, by rank. A probe that the caller passes counts how they were decided.
#[derive(Debug)]
pub(super) struct Signs<'a, S> {
    points: &'a [[S; 2]],
    pub(super) vertices: Vertices,
    pub(super) artificial: Artificial,
    /// For each vertex its place from left to right, if the search structure asked for them.
    places: Vec<u32>,
    /// How many in-circle tests the filter left open so far, and the vertices as integers once they are many.
    near_ties: usize,
    whole: Option<WholePoints>,
}

/// After so many near-ties, and one for so many vertices, integers are made of all. That takes some 60 instructions a
/// vertex; a near-tie takes some 360 without them.
const NEAR_TIES: usize = 16;
const VERTICES_A_TIE: usize = 3;

impl<'a, S: Scalar> Signs<'a, S> {
    /// The signs of these points, whose sorted and merged vertices are given.
    pub(super) fn new(points: &'a [[S; 2]], mut vertices: Vertices) -> Self {
        let artificial = Artificial::beside(vertices.len());
        vertices.approx.extend(artificial::APPROX);
        Signs {
            points,
            vertices,
            artificial,
            places: Vec::new(),
            near_ties: 0,
            whole: None,
        }
    }

    /// The approximated coordinates of a vertex; infinite x and NaN for an artificial one.
    #[inline(always)]
    pub(super) fn approx(&self, v: VertexId) -> [f64; 2] {
        self.vertices.approx[v.index()]
    }

    /// What a search structure gets for the x of a vertex.
    #[inline(always)]
    pub(super) fn search_x(&self, v: VertexId) -> f64 {
        self.search_x_near(v, self.approx(v))
    }

    /// The same for a vertex with these approximated coordinates.
    #[inline(always)]
    pub(super) fn search_x_near(&self, v: VertexId, near: [f64; 2]) -> f64 {
        match self.places.get(v.index()) {
            Some(&place) => f64::from(place),
            None => near[0],
        }
    }

    #[inline(always)]
    pub(super) fn is_artificial(&self, v: VertexId) -> bool {
        self.artificial.contains(v)
    }

    fn exact(&self, v: VertexId) -> &'a [S; 2] {
        &self.points[self.vertices.input[v.index()] as usize]
    }

    /// Whether a search structure gets places for x.
    pub(super) fn has_places(&self) -> bool {
        !self.places.is_empty()
    }

    /// Numbers the vertices from left to right, of equal x in sweep order.
    pub(super) fn number_by_x(&mut self) {
        let mut order: Vec<VertexId> = (0..self.vertices.len()).map(VertexId::at).collect();
        order.sort_unstable_by(|&a, &b| self.compare_x(a, b).then(a.cmp(&b)));
        self.places = vec![0; order.len()];
        for (place, v) in order.into_iter().enumerate() {
            self.places[v.index()] = narrow(place);
        }
    }

    /// Order by x; P-1 before and P-2 after all.
    #[inline(always)]
    pub(super) fn compare_x(&self, a: VertexId, b: VertexId) -> Ordering {
        self.compare_x_near(a, b, self.approx(b))
    }

    /// The same where `b` has these approximated coordinates.
    #[inline(always)]
    pub(super) fn compare_x_near(&self, a: VertexId, b: VertexId, near_b: [f64; 2]) -> Ordering {
        let x = self.approx(a)[0];
        if x < near_b[0] {
            Less
        } else if x > near_b[0] {
            Greater
        } else {
            self.compare_equal_x(a, b)
        }
    }

    /// Order by x of vertices whose approximated x are equal.
    fn compare_equal_x(&self, a: VertexId, b: VertexId) -> Ordering {
        if self.vertices.scale.tells_equal() {
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
        let near = [self.approx(a), self.approx(b), self.approx(c)];
        self.orient2d_near([a, b, c], near, probe)
    }

    /// The same where these are their doubles.
    #[inline(always)]
    pub(super) fn orient2d_near(
        &self,
        vertices: [VertexId; 3],
        near: [[f64; 2]; 3],
        probe: &mut impl Probe,
    ) -> Ordering {
        match filter::orient2d(near, self.vertices.scale) {
            Some(sign) => {
                probe.count(|c| c.orient2d_filtered += 1);
                sign
            }
            None => self.orient2d_exact(vertices, probe),
        }
    }

    /// The orientation test where the filter for exact doubles does not decide.
    #[cold]
    #[inline(never)]
    fn orient2d_exact(&self, [a, b, c]: [VertexId; 3], probe: &mut impl Probe) -> Ordering {
        let scale = self.vertices.scale;
        let doubles = [a, b, c].map(|v| self.approx(v));
        let filtered = if scale.is_exact() {
            filter::orient2d_on_lattice(doubles, scale)
        } else {
            filter::orient2d_approx(doubles, scale)
        };
        if let Some(sign) = filtered {
            probe.count(|c| c.orient2d_filtered += 1);
            return sign;
        }
        let (sign, stage) = if are_coordinates(doubles, scale) {
            let [a, b, c] = &doubles;
            f64::orient2d_exact(a, b, c)
        } else {
            S::orient2d_exact(self.exact(a), self.exact(b), self.exact(c))
        };
        probe.count(|c| c.count_orient2d(stage));
        sign
    }

    /// On which side of the ray from `from` towards `to` the vertex `v` is: `Greater` for the left.
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
        &mut self,
        [p, a, b]: [VertexId; 3],
        near_p: [f64; 2],
        q: VertexId,
        probe: &mut impl Probe,
    ) -> bool {
        let doubles = [near_p, self.approx(a), self.approx(b), self.approx(q)];
        match filter::in_circle(doubles, self.vertices.scale) {
            Some(sign) => {
                probe.count(|c| c.in_circle_filtered += 1);
                sign == Greater
            }
            None => self.must_flip_exact([p, a, b], q, probe),
        }
    }

    /// The test of a side where the filter for exact doubles does not decide.
    #[cold]
    #[inline(never)]
    fn must_flip_exact(
        &mut self,
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
        match self.in_circle_exact([a, b, p, q], probe) {
            Greater => true,
            Less => false,
            Equal => {
                probe.count(|c| c.cocircular += 1);
                let of_side = self.leftmost(a, b);
                self.leftmost(self.leftmost(p, q), of_side) != of_side
            }
        }
    }

    /// On which side of the circle through `a`, `b`, `c` the vertex `d` lies, all real, where the filter for
    /// exact doubles does not decide: `Greater` for inside.
    fn in_circle_exact(&mut self, [a, b, c, d]: [VertexId; 4], probe: &mut impl Probe) -> Ordering {
        if let Some(whole) = &self.whole
            && let Some(sign) = whole.in_circle([a, b, c, d].map(VertexId::index))
        {
            probe.count(|c| c.count_in_circle(Stage::Integers));
            return sign;
        }
        let scale = self.vertices.scale;
        let doubles = [a, b, c, d].map(|v| self.approx(v));
        let filtered = if scale.is_exact() {
            filter::in_circle_on_lattice(doubles, scale)
        } else {
            filter::in_circle_approx(doubles, scale)
        };
        if let Some(sign) = filtered {
            probe.count(|c| c.in_circle_filtered += 1);
            return sign;
        }
        let (sign, stage) = if let Some(sign) = scale.in_circle_by_integers(doubles) {
            (sign, Stage::Integers)
        } else if are_coordinates(doubles, scale) {
            self.count_near_tie();
            let [a, b, c, d] = &doubles;
            f64::in_circle_exact(a, b, c, d)
        } else {
            let [a, b, c, d] = [a, b, c, d].map(|v| self.exact(v));
            S::in_circle_exact(a, b, c, d)
        };
        probe.count(|c| c.count_in_circle(stage));
        sign
    }

    /// Counts a test that took exact coordinates; makes integers of all vertices when these are many.
    #[cold]
    #[inline(never)]
    fn count_near_tie(&mut self) {
        self.near_ties += 1;
        let n = self.vertices.len();
        if self.near_ties == NEAR_TIES + n / VERTICES_A_TIE && self.vertices.scale.tells_equal() {
            self.whole = Some(WholePoints::of(&self.vertices.approx[..n]));
        }
    }

    /// Bytes of the arrays that grow with the input.
    pub(super) fn memory(&self) -> usize {
        self.vertices.memory() + self.whole.as_ref().map_or(0, WholePoints::memory)
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

/// Whether doubles are the coordinates, up to a power of two, which changes no sign. They lie nearer in memory
/// than the caller's points, which are in any order.
fn are_coordinates<const N: usize>(doubles: [[f64; 2]; N], scale: Scale) -> bool {
    scale.tells_equal() || scale.is_exact() && doubles.iter().flatten().all(|x| x.is_finite())
}

//! The predicates of the sweep: exact signs, with vertices named by rank. The empty circle test of section 2 (figures 2
//! and 3) is [`SweepPredicates::must_flip`]. The floating-point [`filter`] decides most signs from doubles.
//! [`Predicates`] decide the others exactly. Rules decide the tests with an artificial point ([`super::artificial`]).
//!
//! **Canonical rule.** Where four points lie on one circle, the side stays that ends at the leftmost of them (the upper
//! one of two); the paper leaves this open. This is the sign of the in-circle test after each point, lifted to the
//! paraboloid, is lowered by a symbolic amount, the leftmost one most of all (a pulling triangulation). So there is one
//! Delaunay triangulation, and Lawson's flips still end. Where a stream exchanges the coordinates of a window, the rule is
//! exchanged with them ([`Ties::Lowest`]).

use core::cmp::Ordering::{self, Equal, Greater, Less};

use super::artificial::{self, Artificial};
use super::vertices::Vertices;
use crate::ids::VertexId;
use crate::observe::probe::Probe;
use crate::scalar::{ExactPoints, NearTies, Predicates, filter};
use crate::settings::Ties;

/// The exact signs, by rank. A probe that the caller passes counts how they were decided.
#[derive(Debug)]
pub(super) struct SweepPredicates<'a> {
    points: &'a dyn ExactPoints,
    pub(super) vertices: Vertices,
    pub(super) artificial: Artificial,
    near_ties: NearTies,
    ties: Ties,
}

impl<'a> SweepPredicates<'a> {
    /// The predicates of sorted and merged `vertices` of these points.
    pub(super) fn new(points: &'a dyn ExactPoints, mut vertices: Vertices) -> Self {
        let artificial = Artificial::beside(vertices.len());
        vertices.approx.extend(artificial::APPROX);
        SweepPredicates {
            points,
            vertices,
            artificial,
            near_ties: NearTies::default(),
            ties: Ties::default(),
        }
    }

    /// Breaks ties between vertices on one circle by this rule.
    pub(super) fn with_ties(self, ties: Ties) -> Self {
        SweepPredicates { ties, ..self }
    }

    /// The approximations of a vertex; infinite x and NaN for an artificial one.
    #[inline(always)]
    pub(super) fn approx(&self, v: VertexId) -> [f64; 2] {
        self.vertices.approx[v.index()]
    }

    #[inline(always)]
    pub(super) fn is_artificial(&self, v: VertexId) -> bool {
        self.artificial.contains(v)
    }

    /// Order by x; P-1 before and P-2 after all.
    #[inline(always)]
    pub(super) fn compare_x(&self, a: VertexId, b: VertexId) -> Ordering {
        self.compare_x_approx(a, b, self.approx(b))
    }

    /// Order by x where `b` has these approximations.
    #[inline(always)]
    pub(super) fn compare_x_approx(
        &self,
        a: VertexId,
        b: VertexId,
        approx_b: [f64; 2],
    ) -> Ordering {
        let x = self.approx(a)[0];
        if x < approx_b[0] {
            Less
        } else if x > approx_b[0] {
            Greater
        } else {
            self.compare_equal_x(a, b)
        }
    }

    /// Order by x of vertices whose approximations of x are equal.
    fn compare_equal_x(&self, a: VertexId, b: VertexId) -> Ordering {
        if self.vertices.scale.is_injective() {
            return Equal;
        }
        match self.artificial.compare_x(a, b) {
            Equal if !self.is_artificial(a) => {
                let inputs = [a, b].map(|v| self.vertices.input_index(v));
                self.points.compare_x(inputs)
            }
            order => order,
        }
    }

    /// `Greater` if the vertices `a`, `b`, `c`, all real, turn left.
    #[inline(always)]
    pub(super) fn orient2d(&self, [a, b, c]: [VertexId; 3], probe: &mut impl Probe) -> Ordering {
        let approx = [self.approx(a), self.approx(b), self.approx(c)];
        self.orient2d_approx([a, b, c], approx, probe)
    }

    /// `Greater` if three real vertices with these approximations turn left.
    #[inline(always)]
    pub(super) fn orient2d_approx(
        &self,
        vertices: [VertexId; 3],
        approx: [[f64; 2]; 3],
        probe: &mut impl Probe,
    ) -> Ordering {
        match filter::orient2d(approx, self.vertices.scale) {
            Some(sign) => {
                probe.count(|c| c.orient2d_filtered += 1);
                sign
            }
            None => self.orient2d_exact(vertices, probe),
        }
    }

    #[cold]
    #[inline(never)]
    fn orient2d_exact(&self, vertices: [VertexId; 3], probe: &mut impl Probe) -> Ordering {
        let decision = self
            .real()
            .orient2d_below_filter(vertices.map(VertexId::number));
        let (sign, stage) = decision;
        probe.count(|c| match stage {
            None => c.orient2d_filtered += 1,
            Some(stage) => c.count_orient2d(stage),
        });
        sign
    }

    /// The side of ray `from`-`to` that `v` is on: `Greater` for left. `to` is real and lower; `v` may be artificial.
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

    /// Whether side `a`-`b` of the counter-clockwise triangle `p`, `a`, `b` must be flipped to `p`-`q` (figure 3).
    #[inline(always)]
    pub(super) fn must_flip(
        &self,
        [p, a, b]: [VertexId; 3],
        approx_p: [f64; 2],
        q: VertexId,
        probe: &mut impl Probe,
    ) -> bool {
        let doubles = [approx_p, self.approx(a), self.approx(b), self.approx(q)];
        match filter::in_circle(doubles, self.vertices.scale) {
            Some(sign) => {
                probe.count(|c| c.in_circle_filtered += 1);
                sign == Greater
            }
            None => self.must_flip_exact([p, a, b], q, probe),
        }
    }

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
        match self.in_circle_exact([a, b, p, q], probe) {
            Greater => true,
            Less => false,
            Equal => {
                probe.count(|c| c.cocircular += 1);
                if self.ties == Ties::Lowest {
                    return !self.ends_at_lowest([p, a, b], q);
                }
                let of_side = self.leftmost(a, b);
                self.leftmost(self.leftmost(p, q), of_side) != of_side
            }
        }
    }

    /// Which side of the circle through the first three the last vertex is on, all real: `Greater` for inside.
    #[inline(always)]
    fn in_circle_exact(&self, vertices: [VertexId; 4], probe: &mut impl Probe) -> Ordering {
        // On a coarse lattice nearly every test comes here, and the determinant of doubles decides it.
        let scale = &self.vertices.scale;
        let doubles = vertices.map(|v| self.approx(v));
        if scale.is_exact()
            && let Some(sign) = filter::in_circle_on_lattice(doubles, scale)
        {
            probe.count(|c| c.in_circle_filtered += 1);
            return sign;
        }
        self.in_circle_off_lattice(vertices, probe)
    }

    #[cold]
    #[inline(never)]
    fn in_circle_off_lattice(&self, vertices: [VertexId; 4], probe: &mut impl Probe) -> Ordering {
        let decision = self
            .real()
            .in_circle_below_filter(vertices.map(VertexId::number));
        let (sign, stage) = decision;
        probe.count(|c| match stage {
            None => c.in_circle_filtered += 1,
            Some(stage) => c.count_in_circle(stage),
        });
        sign
    }

    #[inline(always)]
    fn real(&self) -> Predicates<'_, dyn ExactPoints + 'a> {
        Predicates {
            points: self.points,
            index: &self.vertices.input,
            approx: &self.vertices.approx,
            scale: &self.vertices.scale,
            near_ties: &self.near_ties,
        }
    }

    pub(super) fn heap_bytes(&self) -> usize {
        self.vertices.heap_bytes() + self.near_ties.heap_bytes()
    }

    /// The leftmost of two vertices, the upper one where x is equal.
    fn leftmost(&self, a: VertexId, b: VertexId) -> VertexId {
        match self.compare_x(a, b) {
            Less => a,
            Greater => b,
            Equal => a.max(b),
        }
    }

    /// The lowest of two vertices, the right one where y is equal.
    fn lowest(&self, a: VertexId, b: VertexId) -> VertexId {
        let inputs = [a, b].map(|v| self.vertices.input_index(v));
        match self.points.compare_y(inputs) {
            Equal => b.max(a),
            _ => b.min(a),
        }
    }

    /// Whether the side `a`-`b` ends at the lowest of four vertices.
    #[cold]
    #[inline(never)]
    fn ends_at_lowest(&self, [p, a, b]: [VertexId; 3], q: VertexId) -> bool {
        let of_side = self.lowest(a, b);
        self.lowest(self.lowest(p, q), of_side) == of_side
    }
}

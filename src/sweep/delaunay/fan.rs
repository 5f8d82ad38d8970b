//! The fan of a vertex `u` that a pseudo-polygon got, and whose triangle `u w v` was turned over
//! ([`super::random_order`]): how the triangles become Delaunay with few flips.
//!
//! ```text
//!    r-----q                 r-----q          First the fan grows, until no triangle of it is turned over, and no
//!     \   / \                 \     \         outer side, opposite `u`, is illegal. Then *spokes* are flipped that are
//!      \ /   \       ->        \     \        illegal: spoke u-q becomes r-p, and the triangle p q r, an *ear*,
//!       u-----p                u-----p        leaves the fan. Which ear leaves first decides how many flips follow:
//!        spoke u-q             ear p q r      the one whose circle is farthest from `u`, measured by the power of `u`.
//! ```
//!
//! Why it is right: in the end the sides of all ears are legalized, so the result never depends on the order, nor on
//! powers that are rounded. docs/proofs/pseudo-polygon.md proves that no more flips are needed than the cost says.
//!
//! Cost: fewer than `2 n` flips for n triangles of the grown fan if the order is right, O(n log n) steps for the heap,
//! but O(n) where no spoke is illegal, as nearly always. Differs from Shewchuk and Brown: they fill the fan again.

use alloc::collections::BinaryHeap;
use alloc::vec::Vec;
use core::cmp::Ordering::Greater;
use core::mem::take;

use super::Delaunay;
use crate::ids::{TriangleId, narrow};
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use crate::sweep::contradiction::inexact_scalar;

/// The fan of a vertex, counter-clockwise around it, and the ears that may leave it.
#[derive(Debug, Default)]
pub(super) struct Fan {
    /// The triangles: number `k` follows spoke `k`, and spoke 0 is the first side.
    triangles: Vec<TriangleId>,
    /// For each spoke the spokes beside it.
    prev: Vec<u32>,
    next: Vec<u32>,
    ears: BinaryHeap<Ear>,
}

/// An ear: the bits of a power that is not negative, the spoke, and the spokes that were beside it.
type Ear = (u64, u32, [u32; 2]);

impl<P: Probe> Delaunay<'_, P> {
    /// Makes the triangles around corner 0 of `t` right, a triangle that was turned over.
    pub(super) fn legalize_turned_over(&mut self, t: TriangleId) {
        let mut fan = take(&mut self.run.fan);
        self.grow_fan(&mut fan, t);
        self.shrink_fan(&mut fan);
        self.run.fan = fan;
        self.legalize();
    }

    /// Flips sides opposite corner 0 of `t` until no triangle around that vertex is turned over, and no such side is
    /// illegal. The vertex stays corner 0 of all its triangles.
    fn grow_fan(&mut self, fan: &mut Fan, t: TriangleId) {
        fan.triangles.clear();
        let approx = self.predicates.approx(self.mesh.get(t).vertex(0));
        let mut at = t;
        loop {
            while self.orient2d(self.mesh.get(at).vertices()) != Greater {
                if self.mesh.twin(HalfEdge::new(at, 0)).cannot_flip() {
                    inexact_scalar();
                }
                self.flip_in_fan(at);
            }
            while self.is_illegal_from(approx, HalfEdge::new(at, 0)) {
                self.flip_in_fan(at);
            }
            fan.triangles.push(at);
            let twin = self.mesh.twin(HalfEdge::new(at, 1));
            if twin.is_border() {
                break;
            }
            at = twin.triangle();
            if at == t {
                inexact_scalar();
            }
        }
    }

    /// Flips the spokes that are illegal, the ear of greatest power first. Sides of ears go on the flip stack.
    fn shrink_fan(&mut self, fan: &mut Fan) {
        let len = narrow(fan.triangles.len());
        fan.prev.clear();
        fan.prev.extend((0..len).map(|k| k.saturating_sub(1)));
        fan.next.clear();
        fan.next.extend(1..=len);
        fan.ears.clear();
        for spoke in 1..len {
            self.push_ear(fan, spoke);
        }
        while let Some((_, spoke, beside)) = fan.ears.pop() {
            let [prev, next] = beside;
            let at = spoke as usize;
            if beside != [fan.prev[at], fan.next[at]] {
                continue;
            }
            let ear = self.flip_spoke(fan.triangles[at]);
            self.flip_stack
                .extend([0, 1, 2].map(|i| HalfEdge::new(ear, i)));
            fan.triangles[prev as usize] = fan.triangles[at];
            fan.next[prev as usize] = next;
            if next < len {
                fan.prev[next as usize] = prev;
                self.push_ear(fan, next);
            }
            if prev > 0 {
                self.push_ear(fan, prev);
            }
        }
    }

    /// Notes the ear of a spoke that is illegal.
    fn push_ear(&mut self, fan: &mut Fan, spoke: u32) {
        let at = spoke as usize;
        let side = HalfEdge::new(fan.triangles[at], 2);
        if self.is_illegal(side) {
            let power = self.power_to_ear(side);
            let beside = [fan.prev[at], fan.next[at]];
            fan.ears.push((power.max(0.0).to_bits(), spoke, beside));
        }
    }

    /// The power of `u` to the circle of the ear `p` `r` `q`, rounded; `side` is the spoke `u`-`q` of `u` `q` `r`.
    fn power_to_ear(&self, side: HalfEdge) -> f64 {
        let [r, u, q] = self.mesh.around(side);
        let p = self.mesh.opposite(self.mesh.twin(side));
        let [ux, uy] = self.predicates.approx(u);
        let from_u = [p, r, q].map(|v| {
            let [x, y] = self.predicates.approx(v);
            [x - ux, y - uy]
        });
        let cross = |i: usize, j: usize| from_u[i][0] * from_u[j][1] - from_u[i][1] * from_u[j][0];
        let square = |i: usize| from_u[i][0] * from_u[i][0] + from_u[i][1] * from_u[i][1];
        let [pr, rq, qp] = [cross(0, 1), cross(1, 2), cross(2, 0)];
        -(square(0) * rq + square(1) * qp + square(2) * pr) / (pr + rq + qp)
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::initialization::initialize;
    use super::super::super::predicates::SweepPredicates;
    use super::super::super::state::Scratch;
    use super::Delaunay;
    use crate::ids::{TriangleId, VertexId};
    use crate::mesh::HalfEdge;
    use crate::random::Random;
    use crate::settings::Settings;
    use alloc::vec;
    use alloc::vec::Vec;
    use core::cmp::Ordering::Greater;

    /// A vertex at the origin and others around it, above it, from right to left.
    fn around_origin(random: &mut Random, corners: usize) -> Vec<[f64; 2]> {
        let mut points = vec![[0.0, 0.0]];
        for _ in 0..corners {
            points.push([
                random.below(1000) as f64 - 500.0,
                1.0 + random.below(1000) as f64,
            ]);
        }
        let turn = |a: &[f64; 2], b: &[f64; 2]| a[0] * b[1] - a[1] * b[0];
        points[1..].sort_unstable_by(|a, b| turn(b, a).total_cmp(&0.0));
        points.dedup_by(|b, a| turn(a, b) == 0.0 && *a != [0.0, 0.0]);
        points
    }

    /// Legalizes a fan whose triangles all run counter-clockwise. Returns how many leave it.
    fn leave_fan(points: &[[f64; 2]]) -> usize {
        let (settings, mut scratch) = (Settings::default(), Scratch::default());
        initialize(points, &[], settings.tuning, &mut scratch).expect("points");
        let Scratch {
            arrays,
            mut buffers,
            ..
        } = scratch;
        let vertices = arrays.vertices;
        let mut number = vec![VertexId::at(0); points.len()];
        for (rank, &input) in vertices.input.iter().enumerate() {
            number[input as usize] = VertexId::at(rank);
        }
        let predicates = SweepPredicates::new(&points, vertices);
        let mut delaunay = Delaunay::new(arrays.mesh, predicates, settings, (), &mut buffers);
        delaunay.mesh.begin(points.len(), 0);
        let mut first = None;
        let mut spoke = HalfEdge::border(delaunay.mesh.add_border());
        for k in 1..points.len() - 1 {
            let [outer, next] = [(); 2].map(|()| delaunay.mesh.add_border());
            let corners = [number[0], number[k], number[k + 1]];
            let twins = [HalfEdge::border(outer), HalfEdge::border(next), spoke];
            let t = delaunay.mesh.add(corners, twins);
            first.get_or_insert(t);
            spoke = delaunay.mesh.border_twin(next);
        }
        delaunay.legalize_turned_over(first.expect("a triangle"));

        let all = (0..points.len() - 2).map(TriangleId::at);
        for t in all.clone() {
            let corners = delaunay.mesh.get(t).vertices();
            assert_eq!(delaunay.orient2d(corners), Greater, "{points:?}");
            for side in 0..3 {
                assert!(!delaunay.is_illegal(HalfEdge::new(t, side)), "{points:?}");
            }
        }
        all.filter(|&t| !delaunay.mesh.get(t).vertices().contains(&number[0]))
            .count()
    }

    /// Triangles of positive area without an illegal side are the only right ones of the polygon.
    #[test]
    fn all_ears_leave_a_fan_that_are_right_without_it() {
        let mut random = Random::new();
        let mut left = 0;
        for round in 0..2000 {
            let points = around_origin(&mut random, 3 + round % 60);
            left += leave_fan(&points);
        }
        assert!(left > 10_000, "{left}");
    }
}

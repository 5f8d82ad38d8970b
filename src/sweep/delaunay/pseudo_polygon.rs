//! Long pseudo-polygons: their vertices are inserted in random order (Shewchuk and Brown 2015), so that one edge flips
//! few sides for each triangle that it pierces, whatever the chain is.
//!
//! The edge, its two ends and any vertices of the chain, in the order of the chain, make a polygon. The empty one is the
//! edge alone; each vertex inserted makes the polygon of one vertex more; the last one is the pseudo-polygon. A vertex
//! `u` comes between `v` and `w`, its neighbours of the moment. Either it lies outside and adds the triangle `u w v`
//! (left), or it lies inside and cuts that triangle off (right):
//!
//! ```text
//!            u                                         The edge is below, the chain runs from the right
//!          .' `.                                       to the left. Dashes are sides of the polygon with
//!        .'     `.             w - - - - - - - v       `u`, dots the side w-v of the polygon without it.
//!       w . . . . v             \  `-.   .-'  /        On the right the triangle `u w v` is turned over:
//!      /           \             \    `u'    /         it runs clockwise. It is made all the same, and
//!     /     leg     \             \    |leg /          sides opposite `u` are flipped until no triangle
//!    /       |       \             \   |   /           around `u` is turned over. Only sides that cross
//!   --------edge-------           --- edge ---         the triangle `u w v` are flipped for that.
//! ```
//!
//! Why it is right. Each vertex of the chain was the end of a side that the edge pierced: its *leg*, from the edge to
//! the vertex. Legs do not cross, and meet the edge in the order of the chain. Between the legs of two neighbours lies a
//! simple quadrilateral: edge, leg, side, leg. So each polygon is made of quadrilaterals that are glued leg to leg, a
//! surface without holes, which may lie over itself: it need not be simple in the plane. If the angle at `u` within this
//! surface is less than 360 degrees, then `u` lies outside or in the quadrilateral of `v` and `w`, and `u w v` is a
//! triangle beside or in the surface. After the flips every triangle is counter-clockwise. Then the sides around
//! `u` are legalized, and a triangulation of such a surface whose sides are locally Delaunay is the only one (the canonical
//! rule). The last polygon is the pseudo-polygon, which lies in the plane. A hanging edge is two sides of the surface,
//! and a vertex that the chain visits twice is two vertices of it, with two legs. No two neighbours lie at
//! the same point: the last vertex between two visits has an angle of 360 degrees, and is not taken out.
//!
//! So the vertices are taken out in random order, but only where the angle is less than 360 degrees. Of two neighbours
//! the one that is farther from the edge has such an angle (Shewchuk and Brown, section 3), so there is a choice among
//! half of the vertices or more. Signs tell the angle: on which side of the leg each neighbour lies, and, where both are
//! on one side, which of them is the nearer one in the turn around `u`.
//!
//! Cost: up to three orientation tests for each draw, expected two draws or fewer for each vertex. A vertex makes fewer
//! than ten new triangles, expected, whatever the chain is (below). They take at most one flip each, or two where the
//! triangle `u w v` was turned over ([`super::fan`]): the flips are expected linear in what the edge pierces.
//!
//! # Why few triangles are new
//!
//! Let `t` be a triangle of the polygon with `u`, but not of the polygon without `u`. Either `u` is a corner of `t`, or
//! `u` lies inside, and its two sides hide a vertex from `t` that lies in the open disk `D` of `t` or on its circle. In
//! the second case let `K` be the part of the surface in `D` and around `t`. No vertex lies in `K`, so each side that
//! bounds `K` crosses all of `D`: `K` is `D` without some caps, and convex. The hidden vertex is behind a side at `u`
//! that bounds `K`, say `w-u` (`u-v` is the mirror image). Neither `w` nor `u` lies in `D`. Side `u-v` meets `D`, or
//! `v` lies on the circle: if not, without `u` only side `w-v` would be seen behind `w-u`, and no vertex.
//!
//! *The leg of `v` does not meet `K`.* `K` lies on the left of the line from `w` to `u`, and `v` on the right. Suppose
//! that the leg of `v` meets `K` in `B`. Then it passes the line, in `q`.
//! - `q` is not on side `w-u`. For in the plane, too, legs do not cross, and if the leg of `v` crossed `w-u`, then `w`
//!   would lie in the quadrilateral of `u` and `v` (the angle at `u` is less than 360 degrees), and the leg of `w`
//!   could not get out to the edge. Likewise the leg of `w` does not cross `u-v`.
//! - `q` is not beyond `w`. For then the leg of `w` would begin inside the triangle `v q u`, and could not leave it; or
//!   it would begin on the left of the line, and meet the edge on the left of the leg of `v`, though `w` comes before
//!   `v`.
//! - So `q` is beyond `u`. If `u-v` meets `D` in `A`, then `A-B` lies in `D`, and passes the line between `u` and `q`,
//!   as `A` comes before `u` on the way from `v`, and `B` after `q`. But `D` meets the line between `w` and `u` alone.
//!   If `u-v` does not meet `D`, then `v` lies on the circle, so the leg lies in `D` from `v` to `B`, and passes the
//!   line in `D`, that is on `w-u`: but `q` is not there.
//!
//! An end of the edge is its own leg, and does not lie in `K` either.
//!
//! *Five vertices for each triangle.* So `K` lies on the right of the leg of `v`, where `w` and `u` are. Suppose that
//! `u'` with `w'` and `v'`, farther along the chain, hides a vertex from the same `t` in the same way. Side `w'-u'`
//! bounds `K`, and so lies on the right of the leg of `v`: `u'` is `v`, and `w'` is `u`. But then `K` lies on the left
//! of the line from `w` to `u` and touches `u-v`, on its right. So there is at most one such `u` for `t`, and one
//! mirrored: `t` is new for these two and for its three corners.
//!
//! *Ten triangles for each vertex.* A polygon of `k` vertices between the ends of the edge has `k` triangles. `u` was
//! drawn at random from those that can be taken out, `(k + 1) / 2` or more: no two that cannot are neighbours, and none
//! is a neighbour of an end. So fewer than `5 k / (k / 2)` triangles are new, expected. As many go, less one.
//!
//! Differs from the paper: there the apex over the edge is picked by the empty circle, recursively.

use core::cmp::Ordering::{Equal, Greater, Less};

use super::Delaunay;
use super::cavity::PseudoPolygonChain;
use super::run::Run;
use crate::ids::{TriangleId, VertexId};
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use crate::trace::Why;
use core::mem::take;

impl<P: Probe> Delaunay<'_, P> {
    /// Fills a pseudo-polygon if its chain is long, and the paper's order is not asked for. Of the chain only the part of
    /// the edge is left. Returns whether the pseudo-polygon has been filled.
    pub(super) fn fill_in_random_order(&mut self, chain: &mut PseudoPolygonChain) -> bool {
        let len = chain.corners.len();
        if len <= self.tuning.short_chain || self.is_paper {
            return false;
        }
        let mut run = take(self.run);
        let is_drawn = self.draw_pseudo_polygon(&mut run, chain);
        *self.run = run;
        if !is_drawn {
            return false;
        }
        self.flip_limit.grant_for_chain(len);
        let corners = &mut chain.corners;
        corners[0].border = self.insert_run(corners, Why::PseudoPolygon, Self::settle);
        corners.swap(1, len - 1);
        corners.truncate(2);
        true
    }

    /// Draws an order of insertion. `false` if there is none, which the signs of an exact scalar hardly allow.
    fn draw_pseudo_polygon(&mut self, run: &mut Run, chain: &PseudoPolygonChain) -> bool {
        let vertex = |at: u32| chain.corners[at as usize].vertex;
        run.draw_those(chain.corners.len(), |u, neighbors| {
            let beyond = chain.beyond[u as usize];
            self.is_less_than_full_turn(vertex(u), neighbors.map(vertex), beyond)
        })
    }

    /// Whether the angle at `u` from `w` to `v`, counter-clockwise, is less than 360 degrees. Within that angle the leg
    /// of `u` leads to `beyond`.
    fn is_less_than_full_turn(
        &mut self,
        u: VertexId,
        [v, w]: [VertexId; 2],
        beyond: VertexId,
    ) -> bool {
        let sides = [v, w].map(|neighbor| self.orient2d([u, beyond, neighbor]));
        match sides {
            // Less than 180 degrees on one side of the leg, and at most 180 on the other.
            [Greater, Less] | [Greater, Equal] | [Equal, Less] => true,
            // From `w` over the leg to `v`, one of the two angles is more than 180 degrees.
            [Greater, Greater] | [Less, Less] => self.orient2d([u, v, w]) == Greater,
            _ => false,
        }
    }

    /// Legalizes after corner 0 of `t`, a triangle that may be turned over, has been inserted.
    fn settle(&mut self, t: TriangleId) {
        let [u, w, v] = self.mesh.get(t).vertices();
        if self.orient2d([u, w, v]) == Greater {
            self.flip_stack.push(HalfEdge::new(t, 0));
            self.legalize();
        } else {
            self.legalize_turned_over(t);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::initialization::initialize;
    use super::super::super::predicates::SweepPredicates;
    use super::super::super::scratch::Scratch;
    use super::super::run::Random;
    use super::Delaunay;
    use crate::ids::{TriangleId, VertexId};
    use crate::mesh::HalfEdge;
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

    /// Makes all triangles of a fan right, none of which is turned over. Returns how many leave it.
    fn leave_fan(points: &[[f64; 2]]) -> usize {
        let (settings, mut scratch) = (Settings::default(), Scratch::default());
        initialize(points, &[], settings.tuning, &mut scratch).expect("points");
        let Scratch { held, mut lent, .. } = scratch;
        let vertices = held.vertices;
        let mut number = vec![VertexId::at(0); points.len()];
        for (rank, &input) in vertices.input.iter().enumerate() {
            number[input as usize] = VertexId::at(rank);
        }
        let predicates = SweepPredicates::new(&points, vertices);
        let mut delaunay = Delaunay::new(held.mesh, predicates, settings, (), &mut lent.delaunay);
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

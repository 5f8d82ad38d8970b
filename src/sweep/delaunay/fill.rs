//! Filling a chain up to its hull: pockets, basins, upper hull (figure 15a), pseudo-polygons (figures 12 and 13).
//!
//! A chain is a polyline of border half-edges with the empty region to its left. Where it turns left, a triangle can
//! close the corner. Graham's scan closes corners until no left turn remains. A piece of the front becomes its upper
//! hull, a pseudo-polygon the constrained edge.
//!
//! ```text
//!    0 . . .       empty region             6    The chain runs from 0 to 6. At 1 to 4 it turns left,
//!     \      . . . . . .                 _-'     and with the chord 0-5 (dotted) these corners make
//!      \           chord . . . . .    _-'        a convex polygon: a *convex run*, which is closed as a
//!       1                        . 5-'           whole. At 5 the chain turns right, so the run ends
//!        `-_                    _-'              there. Now the chain runs 0-5-6 and turns left at 5,
//!           2-_              _-4                 so that corner is closed next. In a long run, corners
//!              `--_      _--'                    come in random order ([`super::random_order`]): one
//!                  `-3--'                        after the other, each could flip all triangles before.
//! ```
//!
//! Why it is right: chains of the front are x-monotone, and a pseudo-polygon is weakly visible from its edge. So every
//! corner that turns strictly left is an ear, and stays one when others are cut off (Toussaint and Avis 1982). At the
//! free end of a hanging edge the chain turns back by 180 degrees: no left turn. A vertex visited twice is two corners.
//!
//! Cost: O(k) orientation tests for k sides, and expected O(k) flips inside convex runs. The paper closes corners of
//! the upper hull one by one, and picks the apex over an edge by the empty circle, recursively, in O(k^2).

use alloc::vec::Vec;
use core::cmp::Ordering::Greater;

use super::Delaunay;
use crate::ids::{BorderId, TriangleId, VertexId};
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use crate::trace::Why;
use crate::tuning::{CLOSED_ONE_BY_ONE, LONG_FLIP_STACK};

/// A vertex of a chain and the border half-edge from it to the next one (meaningless for the last one). If that border
/// half-edge has a triangle outside, closing the corner joins it to the new triangle, and their common side goes on the
/// flip stack. Otherwise the border half-edge stays, and the new triangle borders on it.
#[derive(Clone, Copy, Debug)]
pub(in crate::sweep) struct ChainVertex {
    pub(in crate::sweep) vertex: VertexId,
    pub(in crate::sweep) border: BorderId,
}

impl<P: Probe> Delaunay<'_, P> {
    /// Fills the region left of `chain`, and leaves its hull. Sides between new and old triangles go on the flip stack.
    pub(in crate::sweep) fn fill(&mut self, chain: &mut Vec<ChainVertex>, why: Why) {
        let before = chain.len();
        self.flip_limit.grant_for_chain(before);
        // `chain[..done]` nowhere turns left; `chain[ahead..]` is still to be scanned.
        let (mut done, mut ahead) = (1, 1);
        while ahead < before {
            if done < 2 || !self.turns_left(chain[done - 2], chain[done - 1], chain[ahead]) {
                chain[done] = chain[ahead];
                done += 1;
                ahead += 1;
                continue;
            }
            // A left turn: a convex run begins here, `chain[start..=ahead]`. Extend it as far as it goes.
            let start = ahead - 2;
            [chain[start], chain[start + 1]] = [chain[done - 2], chain[done - 1]];
            while before > CLOSED_ONE_BY_ONE
                && ahead + 1 < before
                && self.stays_convex(&chain[start..=ahead], chain[ahead + 1])
            {
                ahead += 1;
            }
            // The run becomes one side. Its last corner is scanned again.
            done -= 1;
            chain[done - 1].border = match chain[start..=ahead] {
                [a, b, c] => self.fill_ear([a, b, c], why),
                ref corners => self.fill_convex_run(corners, why),
            };
        }
        chain.truncate(done);
    }

    fn turns_left(&mut self, a: ChainVertex, b: ChainVertex, c: ChainVertex) -> bool {
        self.orient2d([a.vertex, b.vertex, c.vertex]) == Greater
    }

    /// Whether a convex run with its chord, a strictly convex polygon, stays one with one more corner.
    fn stays_convex(&mut self, corners: &[ChainVertex], corner: ChainVertex) -> bool {
        // In a run of three, `second` and `a` are the same corner.
        let [first, second] = [corners[0], corners[1]];
        let [a, b] = [corners[corners.len() - 2], corners[corners.len() - 1]];
        self.turns_left(a, b, corner)
            && self.turns_left(b, corner, first)
            && self.turns_left(corner, first, second)
    }

    /// Closes one corner; returns the border half-edge that replaces its two.
    pub(in crate::sweep) fn fill_ear(&mut self, [a, b, c]: [ChainVertex; 3], why: Why) -> BorderId {
        let joined = [a, b].map(|corner| self.mesh.has_border_twin(corner.border));
        // If a triangle is joined at the first side, the chord takes over the number of that side.
        let chord = if joined[0] {
            a.border
        } else {
            self.mesh.add_border()
        };
        let [below_a, below_b] = [a, b].map(|corner| self.outer_side(corner));
        let vertices = [b.vertex, c.vertex, a.vertex];
        let t = self.add_triangle(vertices, [HalfEdge::border(chord), below_a, below_b], why);
        for (corner, is_joined) in [1, 2].into_iter().zip(joined) {
            if is_joined {
                self.flip_stack.push(HalfEdge::new(t, corner));
            }
        }
        if self.flip_stack.len() > LONG_FLIP_STACK {
            self.legalize();
        }
        chord
    }

    /// The twin that a new triangle gets at the side from `corner`.
    fn outer_side(&self, corner: ChainVertex) -> HalfEdge {
        if self.mesh.has_border_twin(corner.border) {
            self.mesh.border_twin(corner.border)
        } else {
            HalfEdge::border(corner.border)
        }
    }

    /// Triangulates the polygon of a convex run; returns the border half-edge that closes it.
    fn fill_convex_run(&mut self, corners: &[ChainVertex], why: Why) -> BorderId {
        self.run.draw(corners.len());
        self.insert_run(corners, why, |delaunay, t| {
            delaunay.flip_stack.push(HalfEdge::new(t, 0));
            delaunay.legalize();
        })
    }

    /// Inserts the corners of a run in the order drawn; `settle` legalizes around corner 0 of each new triangle. Returns
    /// the border half-edge that closes the run.
    #[inline(always)]
    pub(super) fn insert_run(
        &mut self,
        corners: &[ChainVertex],
        why: Why,
        settle: impl Fn(&mut Self, TriangleId),
    ) -> BorderId {
        self.mesh.reserve_borders(2 * corners.len());
        let chord = self.mesh.add_border();

        // Each corner `u` makes a triangle with its neighbours `v` and `w`, below the side between them.
        let mut top = HalfEdge::border(chord);
        for k in 0..self.run.order.len() {
            let u = self.run.order[k];
            let [v, w] = self.run.neighbors(u);
            if k > 0 {
                top = self.mesh.border_twin(self.run.borders[v as usize]);
            }
            for (from, to) in [(v, u), (u, w)] {
                let border = corners[from as usize].border;
                // A side of the chain without a triangle outside keeps its number.
                let is_last = to == from + 1 && !self.mesh.has_border_twin(border);
                self.run.borders[from as usize] = if is_last {
                    border
                } else {
                    self.mesh.add_border()
                };
            }
            let vertices = [u, w, v].map(|at| corners[at as usize].vertex);
            let [left, right] = [v, u].map(|at| HalfEdge::border(self.run.borders[at as usize]));
            let t = self.add_triangle(vertices, [top, left, right], why);
            settle(self, t);
        }

        // The triangles on the sides of the chain are joined to their neighbours outside.
        for (k, corner) in corners[..corners.len() - 1].iter().enumerate() {
            let (border, outer) = (self.run.borders[k], corner.border);
            if border != outer {
                let above = self.mesh.border_twin(border);
                self.mesh.connect(above, self.mesh.border_twin(outer));
                self.flip_stack.push(above);
            }
        }
        // A front segment bears the number of its left end, whatever triangle is below it.
        let (first, outer) = (self.run.borders[0], corners[0].border);
        if first == outer {
            return chord;
        }
        self.mesh
            .connect(self.mesh.border_twin(chord), HalfEdge::border(outer));
        outer
    }
}

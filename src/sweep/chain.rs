//! Fills a chain of open sides up to its hull: pockets and basins of the front, the upper hull
//! (figure 15a), and pseudo-polygons (figures 12 and 13).
//!
//! A chain is a polyline of open sides with the empty region to its left. Wherever it turns left, the
//! corner can be closed by a triangle. Graham's scan does that until no left turn remains: from the
//! front a chain under a chord comes out as that chord, the whole front as the upper hull, and a
//! pseudo-polygon as the constrained edge.
//!
//! ```text
//!    empty region (to the left of the chain)
//!    0 . . . . . . . . . . . . . . 6          Corners 1 to 4 turn left and stay convex when closed by
//!     \                           /           the chord 0-5: they are one stretch, closed as a whole,
//!      1                         /            in random order. The chain then runs 0-5-6. If it
//!       \                  5 ---              turns left at 5, the scan closes that corner next.
//!        2 --- 3 --- 4 ---/
//! ```
//!
//! Why it is right: the chains of the front are x-monotone; a pseudo-polygon is weakly visible from its
//! constrained edge. In both every corner that turns left strictly is an ear, and stays so when others
//! are cut off (Toussaint and Avis 1982). A hanging edge turns back by 180 degrees, which is no left
//! turn, so its two sides are covered from either side; a vertex visited twice is two corners.
//!
//! Long convex stretches are where Lawson's flips would be quadratic: corners closed from left to right
//! along a parabola make a fan that is flipped anew with each. So a maximal convex stretch is closed as
//! a whole, by inserting its vertices in random order into the polygon of those before (Chew 1990).
//!
//! Cost: O(k) orientation tests for k sides, and expected O(k) flips inside the convex stretches.
//!
//! Differs from the paper: it closes corner by corner in order along the hull, and picks the apex of
//! each pseudo-polygon by the empty circle, recursively (after Anglada 1997), which costs O(k^2).

use std::cmp::Ordering::Greater;

use super::corner::Corner;
use super::fabric::Fabric;
use crate::ids::OpenId;
use crate::mesh::Side;
use crate::probe::Probe;
use crate::scalar::Scalar;
use crate::trace::Why;

impl<S: Scalar, P: Probe> Fabric<'_, S, P> {
    /// Fills `chain` to its left, which leaves its hull. Returns how many triangles that took. Joined
    /// sides become suspects.
    pub(super) fn fill(&mut self, chain: &mut Vec<Corner>, why: Why) -> u64 {
        let before = chain.len();
        // `chain[..done]` turns left nowhere; `chain[ahead..]` is not yet seen.
        let (mut done, mut ahead) = (1, 1);
        while ahead < before {
            if done < 2 || !self.turns_left(chain[done - 2], chain[done - 1], chain[ahead]) {
                chain[done] = chain[ahead];
                done += 1;
                ahead += 1;
                continue;
            }
            // A left turn: the convex stretch that begins here, as far as it goes.
            self.stretch.corners.clear();
            let first = [chain[done - 2], chain[done - 1], chain[ahead]];
            self.stretch.corners.extend(first);
            while ahead + 1 < before && self.stays_convex(chain[ahead + 1]) {
                ahead += 1;
                self.stretch.corners.push(chain[ahead]);
            }
            // The chain now runs from the first to the last of the stretch, which is seen again.
            done -= 1;
            chain[done - 1].open = if self.stretch.corners.len() == 3 {
                self.fill_ear(first, why)
            } else {
                self.fill_stretch(why)
            };
        }
        chain.truncate(done);
        (before - done) as u64
    }

    fn turns_left(&mut self, a: Corner, b: Corner, c: Corner) -> bool {
        self.orient2d([a.vertex, b.vertex, c.vertex]) == Greater
    }

    /// Whether the stretch, strictly convex and closed by its chord, remains so with one more corner.
    fn stays_convex(&mut self, corner: Corner) -> bool {
        // In a stretch of three, `second` and `a` are the same corner.
        let corners = &self.stretch.corners;
        let [first, second] = [corners[0], corners[1]];
        let [a, b] = [corners[corners.len() - 2], corners[corners.len() - 1]];
        self.turns_left(a, b, corner)
            && self.turns_left(b, corner, first)
            && self.turns_left(corner, first, second)
    }

    /// Closes one corner; returns the open side that replaces its two.
    fn fill_ear(&mut self, [a, b, c]: [Corner; 3], why: Why) -> OpenId {
        let joined = [a, b].map(|corner| self.mesh.has_below(corner.open));
        // The number of the first side becomes free for the chord where a triangle is joined there.
        let chord = if joined[0] {
            a.open
        } else {
            self.mesh.add_open()
        };
        let [below_a, below_b] = [a, b].map(|corner| self.below_or_open(corner));
        let vertices = [b.vertex, c.vertex, a.vertex];
        let t = self.make(vertices, [Side::open(chord), below_a, below_b], why);
        for (corner, is_joined) in [1, 2].into_iter().zip(joined) {
            if is_joined {
                self.suspects.push(Side::new(t, corner));
            }
        }
        chord
    }

    /// What a triangle above the side from `corner` borders on.
    fn below_or_open(&self, corner: Corner) -> Side {
        if self.mesh.has_below(corner.open) {
            self.mesh.below(corner.open)
        } else {
            Side::open(corner.open)
        }
    }

    /// Triangulates the convex polygon of the stretch; returns the open side that closes it.
    fn fill_stretch(&mut self, why: Why) -> OpenId {
        self.stretch.draw();
        let chord = self.mesh.add_open();

        // Each corner `u` makes a triangle with its neighbours `v` and `w`, below the side between them.
        let mut top = Side::open(chord);
        for k in 0..self.stretch.order.len() {
            let u = self.stretch.order[k];
            let [v, w] = self.stretch.neighbors(u);
            if k > 0 {
                top = self.mesh.below(self.stretch.open[v as usize]);
            }
            for (from, to) in [(v, u), (u, w)] {
                let open = self.stretch.corners[from as usize].open;
                // A side of the chain on which nothing borders keeps its number.
                let is_last = to == from + 1 && !self.mesh.has_below(open);
                self.stretch.open[from as usize] =
                    if is_last { open } else { self.mesh.add_open() };
            }
            let vertices = [u, w, v].map(|at| self.stretch.corners[at as usize].vertex);
            let [left, right] = [v, u].map(|at| Side::open(self.stretch.open[at as usize]));
            let t = self.make(vertices, [top, left, right], why);
            self.suspects.push(Side::new(t, 0));
            self.legalize();
        }

        // The triangles on the sides of the chain are joined to those outside.
        for k in 0..self.stretch.corners.len() - 1 {
            let (open, outer) = (self.stretch.open[k], self.stretch.corners[k].open);
            if open != outer {
                let above = self.mesh.below(open);
                self.mesh.connect(above, self.mesh.below(outer));
                self.suspects.push(above);
            }
        }
        // A front segment bears the number of its left end, whatever triangle is below it.
        let (first, outer) = (self.stretch.open[0], self.stretch.corners[0].open);
        if first == outer {
            return chord;
        }
        self.mesh.connect(self.mesh.below(chord), Side::open(outer));
        outer
    }
}

//! Fills a chain of sides up to its hull: pockets and basins of the front, the upper hull
//! (figure 15a), and pseudo-polygons (figures 12 and 13).
//!
//! A chain is a polyline of open sides with the empty region to its left. Wherever it turns left, the
//! corner can be closed by a triangle. Graham's scan does that until no left turn remains: from the
//! front a chain under a chord comes out as that chord, the whole front as the upper hull, and a
//! pseudo-polygon as the constrained edge.
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

use super::Sweep;
use crate::Scalar;
use crate::front::FrontSearch;
use crate::mesh::{Link, VertexId, index};
use crate::probe::Probe;
use crate::trace::Why;

/// A vertex of a chain and the open side from it to the next one (of the last: none).
///
/// The side's number leads to the triangle below it, if there is one: then the two triangles are
/// joined and their side legalized. Otherwise the number will lead to the new triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) vertex: VertexId,
    pub(super) side: u32,
}

/// Working memory; positions are those in the stretch being closed.
#[derive(Debug, Default)]
pub(super) struct Filling {
    chain: Vec<Corner>,
    stretch: Vec<Corner>,
    /// The inner positions in order of insertion.
    order: Vec<u32>,
    /// For each position its neighbours among those inserted before it.
    prev: Vec<u32>,
    next: Vec<u32>,
    /// The open side from each position inserted to its next one.
    side: Vec<u32>,
}

impl Filling {
    /// Draws an order of insertion for the inner ones of `len` positions, always the same one.
    fn draw(&mut self, len: u32) {
        let inner = 1..len - 1;
        self.order.clear();
        self.order.extend(inner);
        let mut random = 0x2545_F491_u32;
        for i in (1..self.order.len()).rev() {
            random ^= random << 13;
            random ^= random >> 17;
            random ^= random << 5;
            self.order.swap(i, random as usize % (i + 1));
        }
        self.prev.clear();
        self.prev.extend((0..len).map(|i| i.saturating_sub(1)));
        self.next.clear();
        self.next.extend(1..=len);
        // Taken out in reverse, each keeps the neighbours that it had last.
        for &u in self.order.iter().rev() {
            let (v, w) = (self.prev[u as usize], self.next[u as usize]);
            self.next[v as usize] = w;
            self.prev[w as usize] = v;
        }
        self.side.clear();
        self.side.resize(len as usize, 0);
    }
}

impl<S: Scalar, F: FrontSearch, P: Probe> Sweep<'_, S, F, P> {
    /// Fills the front from node `from` to node `to`, both real, up to its upper hull. Returns how many
    /// triangles that took.
    pub(super) fn fill_front(&mut self, from: VertexId, to: VertexId, why: Why) -> u64 {
        let mut chain = std::mem::take(&mut self.filling.chain);
        chain.clear();
        let mut at = from;
        while at != to {
            chain.push(Corner {
                vertex: at,
                side: at,
            });
            at = self.front.next(at);
        }
        chain.push(Corner {
            vertex: to,
            side: to,
        });

        let sides = self.mesh.open_sides();
        let triangles = self.fill(&mut chain, why);
        self.legalize();
        self.mesh.close(sides);

        for pair in chain.windows(2) {
            while self.front.next(pair[0].vertex) != pair[1].vertex {
                self.take_off_front(self.front.next(pair[0].vertex));
            }
        }
        self.filling.chain = chain;
        triangles
    }

    /// Fills `chain` to its left, which leaves its hull. Returns how many triangles that took. Joined
    /// sides become suspects.
    pub(super) fn fill(&mut self, chain: &mut Vec<Corner>, why: Why) -> u64 {
        let before = chain.len();
        let mut stretch = std::mem::take(&mut self.filling.stretch);
        // `chain[..done]` turns left nowhere; `chain[ahead..]` is not yet seen.
        let (mut done, mut ahead) = (1, 1);
        while ahead < before {
            if done < 2 || !self.turns_left(chain[done - 2], chain[done - 1], chain[ahead]) {
                chain[done] = chain[ahead];
                done += 1;
                ahead += 1;
                continue;
            }
            stretch.clear();
            stretch.extend([chain[done - 2], chain[done - 1], chain[ahead]]);
            while ahead + 1 < before && self.stays_convex(&stretch, chain[ahead + 1]) {
                ahead += 1;
                stretch.push(chain[ahead]);
            }
            // The chain now runs from the first to the last of the stretch, which is seen again.
            done -= 1;
            chain[done - 1].side = match stretch[..] {
                [a, b, c] => self.fill_ear([a, b, c], why),
                _ => self.fill_convex(&stretch, why),
            };
        }
        chain.truncate(done);
        self.filling.stretch = stretch;
        (before - done) as u64
    }

    fn turns_left(&mut self, a: Corner, b: Corner, c: Corner) -> bool {
        self.predicates.orient2d(a.vertex, b.vertex, c.vertex) == Greater
    }

    /// Whether a strictly convex stretch remains so with one more corner, closed by its chord.
    fn stays_convex(&mut self, stretch: &[Corner], corner: Corner) -> bool {
        // Of three corners, with which a stretch begins, the second is both.
        let [first, second] = [stretch[0], stretch[1]];
        let [a, b] = [stretch[stretch.len() - 2], stretch[stretch.len() - 1]];
        self.turns_left(a, b, corner)
            && self.turns_left(b, corner, first)
            && self.turns_left(corner, first, second)
    }

    /// Closes one corner; returns the open side that replaces its two.
    fn fill_ear(&mut self, [a, b, c]: [Corner; 3], why: Why) -> u32 {
        let below = [a, b].map(|corner| self.mesh.open(corner.side));
        let is_free = below.map(|link| link == Link::OUTSIDE);
        let chord = if is_free[0] {
            self.mesh.open_side()
        } else {
            a.side
        };
        let links = [a, b].map(|corner| self.below_or_open(corner));
        let v = [b.vertex, c.vertex, a.vertex];
        let t = self.make(v, [Link::open(chord), links[0], links[1]], why);
        for (corner, is_free) in [1, 2].into_iter().zip(is_free) {
            if !is_free {
                self.suspects.push(Link::new(t, corner));
            }
        }
        chord
    }

    /// What a triangle above the side from `corner` borders on.
    fn below_or_open(&self, corner: Corner) -> Link {
        match self.mesh.open(corner.side) {
            Link::OUTSIDE => Link::open(corner.side),
            below => below,
        }
    }

    /// Triangulates the convex polygon of a stretch; returns the open side that closes it.
    fn fill_convex(&mut self, stretch: &[Corner], why: Why) -> u32 {
        let sides = &stretch[..stretch.len() - 1];
        let mut work = std::mem::take(&mut self.filling);
        work.draw(index(stretch.len()));

        let chord = self.mesh.open_side();
        let mut top = Link::open(chord);
        for &u in &work.order {
            let (v, w) = (work.prev[u as usize], work.next[u as usize]);
            if u != work.order[0] {
                top = self.mesh.open(work.side[v as usize]);
            }
            for (from, to) in [(v, u), (u, w)] {
                let side = sides[from as usize].side;
                let is_last = to == from + 1 && self.mesh.open(side) == Link::OUTSIDE;
                work.side[from as usize] = if is_last { side } else { self.mesh.open_side() };
            }
            let corners = [u, w, v].map(|at| stretch[at as usize].vertex);
            let bottom = [v, u].map(|at| Link::open(work.side[at as usize]));
            let t = self.make(corners, [top, bottom[0], bottom[1]], why);
            self.suspects.push(Link::new(t, 0));
            self.legalize();
        }

        for (corner, &side) in sides.iter().zip(&work.side) {
            if side != corner.side {
                let above = self.mesh.open(side);
                self.mesh.connect(above, self.mesh.open(corner.side));
                self.suspects.push(above);
            }
        }
        // A front segment bears the number of its left end, whatever triangle is below it.
        let closing = if work.side[0] == sides[0].side {
            chord
        } else {
            sides[0].side
        };
        if closing != chord {
            self.mesh
                .connect(self.mesh.open(chord), Link::open(closing));
        }
        self.filling = work;
        closing
    }
}

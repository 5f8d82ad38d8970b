//! Insertion in random order: convex runs, and the vertices of long pseudo-polygons, so that one edge flips few sides for
//! each triangle that it pierces, whatever the chain is.
//!
//! A run is a stretch of a chain whose corners are inserted one by one, each between the two that are its neighbours at
//! that moment. To find these, all corners are first taken out of the run in reverse order, and each keeps the two
//! neighbours that it has then (Chew 1990).
//!
//! ```text
//!            u                                         A vertex `u` comes between `v` and `w`. Either it
//!          .' `.                                       lies outside and adds the triangle `u w v` (left), or
//!        .'     `.             w - - - - - - - v       it lies inside and cuts that triangle off (right). Then
//!       w . . . . v             \  `-.   .-'  /        the triangle is turned over: it runs clockwise. It is
//!      /           \             \    `u'    /         made all the same, and sides opposite `u` are flipped
//!     /     leg     \             \    |leg /          until no triangle around `u` is turned over
//!   --------edge-------           --- edge ---         ([`super::fan`]).
//! ```
//!
//! Why it is right: each vertex of a pseudo-polygon is joined to the edge by a *leg*, the side that the edge pierced. Only
//! a vertex whose angle is less than 360 degrees is taken out; two signs beside the leg tell that. Of two neighbours one
//! has such an angle (Shewchuk and Brown 2015). docs/proofs/pseudo-polygon.md has the proof.
//!
//! Cost: O(k) for k corners of a convex run, but a sort of each long round. For a pseudo-polygon up to three orientation
//! tests a draw, two draws or fewer and ten new triangles or fewer a vertex, all expected. Differs from the paper: there
//! the apex over the edge is picked by the empty circle, recursively.

use alloc::vec::Vec;
use core::cmp::Ordering::{Equal, Greater, Less};
use core::mem::take;

use super::Delaunay;
use super::cavity::PseudoPolygonChain;
use super::fan::Fan;
use crate::ids::{BorderId, TriangleId, VertexId, narrow};
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use crate::random::Random;
use crate::trace::Why;
use crate::tuning::{IN_ONE_ROUND, MOST_DRAWS};

/// A run. A position is an index into the run.
#[derive(Debug, Default)]
pub(in crate::sweep) struct Run {
    /// The inner positions in order of insertion.
    pub(super) order: Vec<u32>,
    /// For each position its neighbours among the positions inserted before it.
    prev: Vec<u32>,
    next: Vec<u32>,
    /// The border half-edge from each position inserted to its next one.
    pub(super) borders: Vec<BorderId>,
    /// Buffers of [`super::fan`].
    pub(super) fan: Fan,
}

impl Run {
    /// Draws an order for a convex run of `corners` corners; it depends on their number alone. It is inserted in rounds,
    /// each as large as all before it and from left to right (Amenta, Choi and Rote 2003): a round has random corners, but
    /// visits memory in order.
    pub(super) fn draw(&mut self, corners: usize) {
        self.take_in(corners);
        Random::new().shuffle(&mut self.order);
        // The last half from left to right, then the half before, and so on.
        let mut end = self.order.len();
        while end > IN_ONE_ROUND {
            self.order[end / 2..end].sort_unstable();
            end /= 2;
        }
        for k in (0..self.order.len()).rev() {
            self.take_out(self.order[k]);
        }
    }

    /// Draws an order of insertion: in reverse, each position `may_leave` from between its neighbours of the moment.
    /// Returns whether there is one.
    pub(super) fn draw_removable(
        &mut self,
        corners: usize,
        mut may_leave: impl FnMut(u32, [u32; 2]) -> bool,
    ) -> bool {
        self.take_in(corners);
        let mut random = Random::new();
        random.shuffle(&mut self.order);
        // The first corner inserted is the last one taken out, and lies between the ends.
        for last in (1..self.order.len()).rev() {
            let mut draws = 0;
            while !may_leave(self.order[last], self.neighbors(self.order[last])) {
                if draws == MOST_DRAWS {
                    return false;
                }
                draws += 1;
                self.order.swap(last, random.below(last));
            }
            self.take_out(self.order[last]);
        }
        true
    }

    /// Takes in all positions, from left to right. All but the ends are to be inserted.
    fn take_in(&mut self, corners: usize) {
        let len = narrow(corners);
        self.order.clear();
        self.order.extend(1..len - 1);
        self.prev.clear();
        self.prev.extend((0..len).map(|i| i.saturating_sub(1)));
        self.next.clear();
        self.next.extend(1..=len);
        self.borders.clear();
        self.borders.resize(corners, BorderId::new(0));
    }

    /// Makes the neighbours of a position each other's. The position keeps them.
    fn take_out(&mut self, u: u32) {
        let [v, w] = self.neighbors(u);
        self.next[v as usize] = w;
        self.prev[w as usize] = v;
    }

    /// The neighbours of position `u` when it is inserted.
    pub(super) fn neighbors(&self, u: u32) -> [u32; 2] {
        [self.prev[u as usize], self.next[u as usize]]
    }
}

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
        run.draw_removable(chain.corners.len(), |u, neighbors| {
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

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
//! triangle beside or in the surface. After the flips every triangle is counter-clockwise. Then all sides around `u`
//! are legalized, and a triangulation of such a surface whose sides are locally Delaunay is the only one (the canonical
//! rule). The last polygon is the pseudo-polygon, which lies in the plane. A hanging edge is two sides of the surface,
//! and a vertex that the chain visits twice is two vertices of it, with two legs. No two neighbours lie at
//! the same point: the last vertex between two visits has an angle of 360 degrees, and is not taken out.
//!
//! So the vertices are taken out in random order, but only where the angle is less than 360 degrees. Of two neighbours
//! the one that is farther from the edge has such an angle (Shewchuk and Brown, section 3), so there is a choice among
//! half of the vertices or more. Signs tell the angle: on which side of the leg each neighbour lies, and, where both are
//! on one side, which of them is the nearer one in the turn around `u`.
//!
//! Cost: up to three orientation tests for each draw, expected two draws or fewer for each vertex. The flips that insert
//! `u` are at most the sides of `u` in the polygon, and the vertex to insert is a random one of at least half of the
//! vertices: expected O(1). The flips that follow where a triangle was turned over are few in every family measured, and
//! have no proof here. (Shewchuk and Brown fill that fan again, by recursion.)
//!
//! Differs from the paper: there the apex over the edge is picked by the empty circle, recursively.

use core::cmp::Ordering::{Equal, Greater, Less};

use super::Delaunay;
use super::cavity::PseudoPolygonChain;
use super::run::Run;
use crate::ids::{TriangleId, VertexId};
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use crate::sweep::flip_limit::inexact_scalar;
use crate::trace::Why;
use core::mem::take;

/// Chains of at most this many vertices are filled as the chains of the front are: they cannot flip much. Small inputs
/// are tested as if they were large.
const SHORT: usize = if cfg!(any(test, fuzzing)) { 3 } else { 16 };

impl<P: Probe> Delaunay<'_, P> {
    /// Fills a pseudo-polygon if its chain is long, and nobody watches the steps. Of the chain only the part of the edge
    /// is left. Returns whether the pseudo-polygon has been filled.
    pub(super) fn fill_in_random_order(&mut self, chain: &mut PseudoPolygonChain) -> bool {
        let len = chain.corners.len();
        if len <= SHORT || self.is_observed() {
            return false;
        }
        let mut run = take(&mut self.run);
        let is_drawn = self.draw_pseudo_polygon(&mut run, chain);
        self.run = run;
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
        if self.orient2d([u, w, v]) != Greater {
            self.turn_back(t);
        } else {
            self.flip_stack.push(HalfEdge::new(t, 0));
        }
        self.legalize();
    }

    /// Flips sides opposite corner 0 of `t` until no triangle around that vertex is turned over; all sides around it go
    /// on the flip stack. The vertex stays corner 0 of all its triangles.
    fn turn_back(&mut self, t: TriangleId) {
        let mut at = t;
        loop {
            while self.orient2d(self.mesh.get(at).vertices()) != Greater {
                if self.mesh.twin(HalfEdge::new(at, 0)).cannot_flip() {
                    inexact_scalar();
                }
                self.flip_in_fan(at);
            }
            self.flip_stack.push(HalfEdge::new(at, 0));
            let spoke = HalfEdge::new(at, 1);
            let twin = self.mesh.twin(spoke);
            if twin.is_border() {
                return;
            }
            self.flip_stack.push(spoke);
            at = twin.triangle();
            if at == t {
                inexact_scalar();
            }
        }
    }
}

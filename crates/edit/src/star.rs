//! The star of a new vertex: what a sweep of its region would make, if the region is closed and no edge runs through it.
//!
//! **Why it is right.** The region is all that the vertex leaves wrong, so none of its sides stays, and every new triangle
//! has the vertex as a corner: without it the triangle would have been there before. So the vertex sees the whole border
//! (Lawson 1977). Ties do no harm: their rule is that of points on a paraboloid, of which the
//! first one is a little lower than it should be, the second one far less, and so on.
//!
//! ```text
//!      .-----.            .-----.         Each side of the border makes a triangle with the vertex. A border that is
//!     / \   / \          / \   / \        open, where the vertex lies beyond the hull, and parts of edges inside are
//!    /___\ /___\   -->  /   \ /   \       left to the sweep.
//!    \   / \x  /        \----x----/
//!     \ /___\ /          \  / \  /
//!      '-----'            '-----'
//! ```
//!
//! **Cost.** Constant time for each side of the border.

use sweep_cdt::scalar::{Scalar, orient2d};

use crate::edits::{Change, Edits, Vertices};
use crate::locate::Place;
use crate::mesh::{NONE, next, number, prev, side_of};
use crate::region::outlined;
use crate::triangulation::DynamicTriangulation;

impl<S: Scalar + Clone> DynamicTriangulation<S> {
    /// Splits an edge that is one side at a place on the side or in a triangle at it, with two edges in its stead. The
    /// edge is open while the vertex comes: beyond its halves, each part of the plane has the star as its canonical
    /// triangulation. Nothing changes where that takes a sweep, or the place lies elsewhere.
    pub(crate) fn split(&mut self, edge: usize, side: u32, place: &[S; 2]) -> Option<Change> {
        let ends = self.edges[edge].expect("an edge that is there");
        let across = self.mesh.twin(side);
        if across == NONE || self.mesh.covers(side) > 1 {
            return None;
        }
        let at = if self.is_right_of(side, place) {
            across
        } else {
            side
        };
        let is_before = |side: u32| {
            let [a, b] = self.mesh.ends(side).map(|v| self.points.place(v));
            orient2d(a, b, place).is_gt()
        };
        if ![next(at), prev(at)].into_iter().all(is_before) {
            return None;
        }
        let v = self.points.reserve(place.clone());
        for side in [side, across] {
            self.mesh.set_covers(side, 0);
        }
        self.add_conflicts(v, Place::Triangle(at / 3));
        let first = self.swept.len();
        if !self.has_star(v) {
            self.region.clear();
            self.mesh.undo();
            self.points.release(v);
            return None;
        }
        let of = ends.map(|point| self.points.vertex(point as usize).expect("an end"));
        for i in first..self.swept.len() {
            let spoke = side_of(self.swept[i], 2);
            if of.contains(&self.mesh.ends(spoke)[1]) {
                for side in [spoke, self.mesh.twin(spoke)] {
                    self.mesh.set_covers(side, 1);
                }
            }
        }
        let (new, [a, b]) = (self.points.next(), ends.map(|point| point as usize));
        let edits = Edits {
            points: vec![self.points.place(v).clone()],
            edges: vec![[a, new], [new, b]],
            remove_edges: vec![edge],
            ..Edits::default()
        };
        self.edges[edge] = None;
        let vertices = Vertices {
            of_new: vec![v],
            reserved: vec![v],
        };
        Some(self.commit(edits, &[(edge, ends)], &vertices, false))
    }

    /// Puts the star of a new vertex in the place of the region, if the sweep would make that; the region is empty then.
    pub(crate) fn has_star(&mut self, v: u32) -> bool {
        let (border, pieces) = outlined(&self.mesh, &self.region);
        if !self.region.beyond.is_empty() || !pieces.is_empty() {
            return false;
        }
        for &t in &self.region.triangles {
            self.mesh.kill(t);
        }
        self.region.clear();
        self.local.resize(self.points.bound(), NONE);
        let first = self.swept.len();
        for (i, side) in border.iter().enumerate() {
            let [a, b] = side.ends;
            let t = self.mesh.add([v, a, b]);
            self.mesh.begin(side_of(t, 0), side.across, side.covers);
            if side.across != NONE {
                self.mesh.set_twin(side.across, side_of(t, 0));
            }
            self.mesh.set_at(a, side_of(t, 1));
            self.local[a as usize] = number(i);
            self.swept.push(t);
        }
        let mut vertices = Vec::with_capacity(border.len() + 1);
        let mut edges = Vec::with_capacity(border.len());
        for (i, side) in border.iter().enumerate() {
            let [a, b] = side.ends;
            let after = self.local[b as usize] as usize;
            let [t, after_t] = [i, after].map(|i| self.swept[first + i]);
            self.mesh.begin(side_of(t, 1), side_of(after_t, 2), 0);
            self.mesh.begin(side_of(after_t, 2), side_of(t, 1), 0);
            vertices.push(a);
            edges.push([i, after]);
        }
        vertices.push(v);
        self.last = self.swept[first];
        self.mesh.set_at(v, side_of(self.last, 0));
        self.sweeps.push((vertices, edges));
        true
    }
}

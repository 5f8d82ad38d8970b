//! Fortune's sweep line (1987), the paper's F-S: the beach line moves up; where an arc vanishes, a triangle is made.
//!
//! ```text
//!           p                            The *chain* runs through the sites of the arcs, from left to right.
//!           |           a . . . c        On the left the new site p is tied to a, whose arc lies below it: a
//!      .--- a           \      /         becomes a, p, a. On the right the arc of b vanishes between those of
//!     b      `--- c      `- b -'         a and c: the triangle a, b, c is made, and b leaves the chain.
//! ```
//!
//! Which arc lies below a site, and when an arc vanishes, are signs of parabolas, and of circles against the sweep
//! line. A [`Scalar`] has no such signs, and they do not follow from those it has. So, as in the paper's comparison,
//! floating point chooses ([`super::beach_line`]). Exact predicates judge the outcome:
//! - a triangle is made only where the chain turns strictly left, so all triangles are counter-clockwise;
//! - when no such corner is left, the chain must be a convex polygon around the points: its sites rise in sweep order
//!   and then fall, no corner turns left, and the lowest and the highest turn strictly right;
//! - then all sides are legalized. Few must be flipped: ties, and where floating point chose wrong.
//!
//! Why it is right: triangles are joined to the chain at whole sides, so together they are a disk. Its boundary is a
//! convex polygon, and all its triangles are counter-clockwise. So each point of the polygon is covered once: this is a
//! triangulation. Legalization leads to the same result from any triangulation. Where the chain is no convex polygon,
//! divide and conquer begins anew: where many points are nearly on a line, such as along the sides of a hexagon, or
//! where doubles are infinite.
//!
//! Cost: O(n log n) for n points spread evenly; for others the walks along the beach line, and the flips where floating
//! point chooses wrong, may be O(n^2). Differs from Fortune: triangles in place of the Voronoi diagram; exact predicates.

use alloc::collections::BinaryHeap;
use alloc::vec::Vec;
use core::cmp::Ordering::{Greater, Less};
use core::cmp::Reverse;

use super::super::Sweep;
use super::super::delaunay::ChainVertex;
use super::super::delaunay::Delaunay;
use super::beach_line::{BeachLine, top};
use crate::error::Error;
use crate::ids::VertexId;
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use crate::trace::Why;

/// An arc that will vanish: the key of the sweep line's height, the arc, and how often its neighbours had changed.
type Vanishing = Reverse<(u64, u32, u32)>;

/// A key that grows with the height.
fn key(height: f64) -> u64 {
    let bits = height.to_bits();
    let negative = bits >> 63 == 1;
    if negative { !bits } else { bits | 1 << 63 }
}

impl<P: Probe> Sweep<'_, P> {
    /// Sweeps with a beach line, and then inserts the edges; afterwards the hull is complete. Returns false if all
    /// vertices lie on one line or the sweep led to no triangulation.
    pub(in crate::sweep) fn sweep_beach_line(&mut self) -> Result<bool, Error> {
        let n = self.delaunay.predicates.vertices.len();
        if self.begin_off_line().is_none() {
            return Ok(false);
        }
        self.clear();
        let line = self.delaunay.beach_line();
        if !self.delaunay.is_convex(&line) {
            return Ok(false);
        }
        self.delaunay.legalize_all();
        let start = self.delaunay.ghosts_around(&line);
        self.delaunay.mesh.truncate_borders(n + 2);
        self.finish_from_ghosts(start)
    }
}

impl<P: Probe> Delaunay<'_, P> {
    /// Sweeps all points and circles. Returns the beach line; the triangles are in the mesh.
    fn beach_line(&mut self) -> BeachLine {
        let n = self.predicates.vertices.len();
        let mut line = BeachLine::new(&self.predicates.vertices.approx[..n]);
        let mut events: BinaryHeap<Vanishing> = BinaryHeap::new();
        for p in (1..n).map(VertexId::at) {
            let site = self.predicates.approx(p);
            while let Some(&Reverse(event)) = events.peek()
                && event.0 <= key(site[1])
            {
                events.pop();
                self.vanish(event, &mut line, &mut events);
            }
            let (left, steps) = line.below(site, &self.predicates.vertices.approx);
            self.probe.count(|c| c.front_steps += steps);
            let right = line.cut(left, p, self.mesh.add_border());
            for arc in [left, right] {
                self.foresee(arc, &mut line, &mut events);
            }
        }
        while let Some(Reverse(event)) = events.pop() {
            self.vanish(event, &mut line, &mut events);
        }
        line
    }

    /// Notes when an arc with new neighbours will vanish, if ever.
    fn foresee(&mut self, arc: u32, line: &mut BeachLine, events: &mut BinaryHeap<Vanishing>) {
        let changes = line.change(arc);
        if let Some(corner) = line.corner(arc) {
            let sites = corner.map(|(site, _)| site);
            if sites[0] != sites[2] && self.orient2d(sites) == Greater {
                let height = top(sites.map(|v| self.predicates.approx(v)));
                events.push(Reverse((key(height), arc, changes)));
            }
        }
    }

    /// Makes the triangle of an arc that vanishes, unless its neighbours have changed.
    fn vanish(
        &mut self,
        (_, arc, changes): (u64, u32, u32),
        line: &mut BeachLine,
        events: &mut BinaryHeap<Vanishing>,
    ) {
        if !line.is_as_after(arc, changes) {
            return;
        }
        if let Some(corner) = line.corner(arc) {
            let corner = corner.map(|(vertex, border)| ChainVertex { vertex, border });
            let border = self.fill_ear(corner, Why::Point);
            // All sides are tested at the end.
            self.clear_stack();
            for neighbor in line.remove(arc, border) {
                self.foresee(neighbor, line, events);
            }
        }
    }

    /// Whether the chain of all sites, from the lowest one, is a convex polygon with a triangle at each side.
    fn is_convex(&mut self, line: &BeachLine) -> bool {
        let chain: Vec<VertexId> = line.sites().map(|(site, _)| site).collect();
        let sides = chain.len() - 1;
        let highest = VertexId::at(self.predicates.vertices.len() - 1);
        let rising = chain.iter().take_while(|&&v| v != highest).count();
        if chain[sides] != chain[0] || rising == chain.len() {
            return false;
        }
        let (up, down) = chain.split_at(rising);
        let is_monotone = up.is_sorted_by(|a, b| a < b) && down.is_sorted_by(|a, b| a > b);
        let has_triangles = || {
            line.sites()
                .take(sides)
                .all(|(_, border)| self.mesh.has_border_twin(border))
        };
        if !is_monotone || !has_triangles() {
            return false;
        }
        (0..sides).all(|i| {
            let before = if i == 0 { sides - 1 } else { i - 1 };
            let turn = self.orient2d([chain[before], chain[i], chain[i + 1]]);
            turn == Less || turn != Greater && i != 0 && i != rising
        })
    }

    /// Puts ghosts around the chain of all sites. Returns the ghost of the hull side that starts at the lowest.
    fn ghosts_around(&mut self, line: &BeachLine) -> HalfEdge {
        let chain: Vec<_> = line.sites().collect();
        let mut ghosts = Vec::with_capacity(chain.len());
        // The chain is clockwise around the hull.
        for pair in chain.windows(2) {
            let [(b, border), (a, _)] = [pair[0], pair[1]];
            let ghost = self.add_ghost(a, b);
            self.mesh.connect(ghost, self.mesh.border_twin(border));
            ghosts.push(ghost);
        }
        let mut after = ghosts[ghosts.len() - 1];
        let start = after;
        for &ghost in &ghosts {
            self.join_ghosts(ghost, after);
            after = ghost;
        }
        start
    }
}

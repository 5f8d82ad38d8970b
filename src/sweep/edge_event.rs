//! The edge event (section 3.4.2): the edges whose upper end has just been swept are inserted.
//!
//! Each edge is first surveyed from its upper to its lower end. Where it runs above the front, the
//! *pocket* between them is filled (figures 13 and 14). Then the edge lies inside the triangulation, and
//! it is inserted part by part: each vertex on it ends one *part* and starts the next. A part that is a
//! side already is marked as fixed. For any other part the pierced triangles are replaced by two
//! pseudo-polygons (figure 12). Overlapping edges share their parts.
//!
//! ```text
//!    upper                               A pocket (figure 13): the front runs below the edge, here at
//!     \  ` . .                           a, b and c, and comes back to it. Filled to its upper hull,
//!      \       ` . . edge                the pocket has the edge for a side. (Where the front comes
//!       \ pocket     ` . .               back above the edge, as in figure 14, the edge pierces
//!        a ----- b         ` . lower     triangles of the filled pocket.)
//!                 `-.      .-'
//!                    `-c-'
//! ```
//!
//! Why it is right: a pocket lies above the front, so it is empty. It ends at nodes on or above the edge, so
//! when it is filled, the edge lies inside the triangulation. A new edge blocks views and opens none, so all
//! sides that it does not pierce remain locally Delaunay.
//!
//! Cost: the edge visits the nodes and triangles on its way twice, once to survey and once to insert.
//!
//! Differs from the paper: pockets are filled before triangles are removed. (The paper collects both in
//! one lower pseudo-polygon.) Several edges at one vertex are inserted in an order that lets one turn
//! around the vertex find them all. (The paper takes any order.)

use std::cmp::Ordering::Equal;

use super::obstacles::{Crossed, Part};
use super::state::Sweep;
use crate::error::Error;
use crate::front::FrontSearch;
use crate::ids::{VertexId, narrow};
use crate::mesh::Side;
use crate::probe::Probe;
use crate::scalar::Scalar;
use crate::trace::{EdgePosition, Event, Why};

impl<S: Scalar, F: FrontSearch, P: Probe> Sweep<'_, S, F, P> {
    /// Inserts the edges whose upper end is `upper`, the vertex swept last.
    pub(super) fn edge_event(&mut self, upper: VertexId) -> Result<(), Error> {
        let mut list = self.edges.at(upper).to_vec();
        // An edge of no length needs nothing.
        list.retain(|&(lower, _)| lower != upper);
        if list.len() > 1 {
            list.sort_by(|&(a, _), &(b, _)| {
                let turn = self.fabric.orient2d([upper, a, b]);
                // On one line: the nearer end first, which is the higher one.
                turn.reverse().then_with(|| b.cmp(&a))
            });
            // Counter-clockwise, but the last one, the rightmost, goes first. Once it and the leftmost
            // are in, no pocket is left beside the upper end, and one turn around it finds all others.
            list.rotate_right(1);
        }
        let mut around = self.leftmost(upper);
        for (lower, edge) in list {
            self.fabric.report(|name| Event::Edge {
                edge,
                upper: name(upper),
                lower: name(lower),
            });
            self.insert_edge(upper, lower, edge, &mut around)
                .map_err(|crossed| self.crossing(edge, crossed))?;
        }
        Ok(())
    }

    /// Inserts one edge. `around` is a side opposite the upper end; afterwards it is one beside the edge.
    ///
    /// The survey follows the whole edge, so it finds any edge that crosses. What comes later fills pockets
    /// and flips free sides; it fixes no other sides than the parts of this edge.
    fn insert_edge(
        &mut self,
        upper: VertexId,
        lower: VertexId,
        edge: u32,
        around: &mut Side,
    ) -> Result<(), Crossed> {
        let mut part = match self.survey(upper, lower, around)? {
            Some(part) => part,
            None => self.traverse(upper, lower, *around)?,
        };
        let first_inside = narrow(self.chains.inside.len());
        let mut onward;
        [*around, onward] = self.insert_part(upper, part);
        // A part that ends before the edge does ends at a vertex on it, where the next one starts.
        while part.end != lower {
            let at = part.end;
            let vertices = &self.fabric.signs.vertices;
            self.chains.inside.push(vertices.input_index(at));
            part = self.traverse(at, lower, onward)?;
            [_, onward] = self.insert_part(at, part);
        }
        let inside = narrow(self.chains.inside.len());
        if inside > first_inside {
            self.chains.split.push((edge, first_inside, inside));
        }
        Ok(())
    }

    /// Follows the whole edge and fills the pockets under it. Returns the part if there is only one and
    /// no pocket was filled, for then the obstacles found are still true.
    fn survey(
        &mut self,
        upper: VertexId,
        lower: VertexId,
        around: &mut Side,
    ) -> Result<Option<Part>, Crossed> {
        self.obstacles.pockets.clear();
        let first = self.traverse(upper, lower, *around)?;
        let mut part = first;
        let mut pockets = self.report_part(upper, first, 0);
        while part.end != lower {
            let from = part.end;
            part = self.traverse(from, lower, part.onward)?;
            pockets = self.report_part(from, part, pockets);
        }
        let is_unchanged = first.end == lower && self.obstacles.pockets.is_empty();
        while let Some([from, to]) = self.obstacles.pockets.pop() {
            let added = self.fill_front(from, to, Why::Pocket);
            self.fabric.probe.count(|c| c.pocket_triangles += added);
        }
        // Filling may have flipped the triangle that `around` was a side of.
        if self.fabric.mesh.opposite(*around) != upper {
            *around = self.leftmost(upper);
        }
        Ok(is_unchanged.then_some(first))
    }

    /// Reports the position of a part that has just been surveyed. `pockets` of the edge were known before
    /// it; returns how many are known now.
    fn report_part(&mut self, from: VertexId, part: Part, pockets: usize) -> usize {
        let now = self.obstacles.pockets.len();
        let has_pocket = now > pockets;
        let position = match part.present {
            Some(_) => EdgePosition::Present,
            None if !has_pocket => EdgePosition::BelowFront,
            None if self.obstacles.pierced.is_empty() => EdgePosition::FrontOnly,
            None => EdgePosition::Mixed,
        };
        self.fabric.report(|name| Event::Part {
            from: name(from),
            to: name(part.end),
            position,
        });
        now
    }

    /// Makes a part of an edge a fixed side. [`Sweep::traverse`] has just found what is in its way.
    /// Returns two sides, one opposite each end.
    fn insert_part(&mut self, from: VertexId, part: Part) -> [Side; 2] {
        if let Some(side) = part.present {
            self.fabric.mesh.fix(side);
            self.fabric.probe.count(|c| c.edges_present += 1);
            self.fabric.report(|name| Event::Fixed {
                side: [from, part.end].map(name),
            });
            [part.start, part.onward]
        } else {
            self.fabric.probe.count(|c| c.edges_inserted += 1);
            self.fabric.replace_pierced(from, part.end, &self.obstacles)
        }
    }

    /// Names the two input edges that cross: the one being inserted, and the first one of those that
    /// contain the fixed side.
    fn crossing(&mut self, edge: u32, [r, s]: Crossed) -> Error {
        let mut crossed = u32::MAX;
        let (low, high) = (r.min(s), r.max(s));
        for (upper, lower, other) in self.edges.iter() {
            if other < crossed
                && lower <= low
                && high <= upper
                && lower != upper
                && [r, s]
                    .iter()
                    .all(|&v| self.fabric.orient2d([upper, lower, v]) == Equal)
            {
                crossed = other;
            }
        }
        let edges = [edge.min(crossed) as usize, edge.max(crossed) as usize];
        Error::CrossingEdges { edges }
    }
}

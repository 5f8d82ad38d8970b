//! The edge event (section 3.4.2): the edges whose upper end has just been swept are inserted.
//!
//! Each edge is first surveyed from its upper to its lower end. Where it runs above the front, the
//! pocket under it is filled (figures 13 and 14), after which the edge lies inside the triangulation.
//! A part of it that is a side already is marked as fixed; for any other part the pierced triangles
//! give way to two pseudo-polygons (figure 12). A vertex on the edge ends a part and starts the next,
//! and overlapping edges share their parts.
//!
//! ```text
//!          upper                       A pocket under an edge (figure 13): the front falls away
//!         /    ` .                     below the edge and comes back to it. Filled to its upper
//!        /  pocket ` .                 hull, the pocket has the edge for a side, or triangles
//!       /    ____      ` lower         that the edge pierces.
//!      a ---b    c ----- d
//! ```
//!
//! Why it is right: a pocket lies between the front and a chord with both ends on or above the edge, so
//! it is empty and filling it is a matter of the front alone. Inserting an edge takes visibility away,
//! never adds any, so all sides that are not pierced remain locally Delaunay.
//!
//! Cost: the nodes and triangles that the edge meets, twice.
//!
//! Differs from the paper: pockets are filled before triangles are removed, where the paper collects
//! both into one lower pseudo-polygon; several edges at one vertex are inserted counter-clockwise, each
//! starting its turn around the vertex where the one before left off.

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
        // Edges of no length are there already.
        list.retain(|&(lower, _)| lower != upper);
        if list.len() > 1 {
            list.sort_by(|&(a, _), &(b, _)| {
                let turn = self.fabric.orient2d([upper, a, b]);
                // On one line: the nearer end first, which is the higher one.
                turn.reverse().then_with(|| b.cmp(&a))
            });
            // The leftmost edge goes first. Once it and the rightmost are in, the pockets beside the
            // upper end are filled, and one turn around it finds all others.
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

    /// Inserts one edge. `around` is a side opposite the upper end, and will be one near the edge.
    ///
    /// An edge that it crosses is met by the survey, which follows it to its end: afterwards pockets are
    /// filled and free sides are flipped, and the only new fixed sides are parts of this edge.
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

    /// Follows the whole edge and fills the pockets under it. Returns its only part if nothing of what
    /// was found has changed since.
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

    /// Reports what is in the way of a part that has just been surveyed, when `pockets` of the edge were
    /// known before. Returns how many are now.
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

    /// Makes a part of an edge a fixed side, after [`Sweep::traverse`] found what is in its way.
    /// Returns a side opposite either end.
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

    /// Names the input edges that cross: the one being inserted and, of those that contain the fixed
    /// side, the first.
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

//! The edge event (section 3.4.2): the edges whose upper end has just been swept are inserted.
//!
//! Each edge is first surveyed from its upper to its lower end. Where it runs above the front, the
//! pocket under it is filled (figures 13 and 14), after which the edge lies inside the triangulation.
//! A part of it that is a side already is marked as fixed; for any other part the pierced triangles
//! give way to two pseudo-polygons (figure 12). A vertex on the edge ends a part and starts the next,
//! and overlapping edges share their parts.
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

use super::Sweep;
use super::traverse::{Crossed, Part, Spoke};
use crate::front::FrontSearch;
use crate::mesh::{VertexId, index};
use crate::probe::Probe;
use crate::trace::{EdgePosition, Event, Why};
use crate::{Error, Scalar};

impl<S: Scalar, F: FrontSearch, P: Probe> Sweep<'_, S, F, P> {
    /// Inserts the edges whose upper end is `upper`, the vertex swept last.
    pub(super) fn edge_event(&mut self, upper: VertexId) -> Result<(), Error> {
        let mut list = self.edges.at(upper).to_vec();
        // Edges of no length are there already.
        list.retain(|&(lower, _)| lower != upper);
        if list.len() > 1 {
            list.sort_by(|&(a, _), &(b, _)| {
                let turn = self.predicates.orient2d(upper, a, b);
                // On one line: the nearer end first, which is the higher one.
                turn.reverse().then_with(|| b.cmp(&a))
            });
            // The last one before the first: with the pockets under the outermost two filled, the
            // others have none beside the upper end, and one turn around it finds them all.
            list.rotate_right(1);
        }
        let mut around = self.leftmost(upper);
        for (lower, edge) in list {
            self.tell(|name| Event::Edge {
                edge,
                upper: name(upper),
                lower: name(lower),
            });
            self.insert_edge(upper, lower, edge, &mut around)
                .map_err(|crossed| self.crossing(edge, crossed))?;
        }
        Ok(())
    }

    /// Inserts one edge. `around` is a triangle at the upper end, and will be one near the edge.
    ///
    /// An edge that it crosses is met by the survey, which follows it to its end: afterwards pockets are
    /// filled and free sides are flipped, and the only new fixed sides are parts of this edge.
    fn insert_edge(
        &mut self,
        upper: VertexId,
        lower: VertexId,
        edge: u32,
        around: &mut Spoke,
    ) -> Result<(), Crossed> {
        let mut part = match self.survey(upper, lower, around)? {
            Some(part) => part,
            None => self.traverse(upper, lower, *around)?,
        };
        let first_inside = index(self.chains.inside.len());
        let mut onward;
        [*around, onward] = self.insert_part(upper, part);
        while part.end != lower {
            let at = part.end;
            self.chains
                .inside
                .push(self.predicates.vertices.input[at as usize]);
            part = self.traverse(at, lower, onward)?;
            [_, onward] = self.insert_part(at, part);
        }
        let inside = index(self.chains.inside.len());
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
        around: &mut Spoke,
    ) -> Result<Option<Part>, Crossed> {
        self.traversal.pockets.clear();
        let first = self.traverse(upper, lower, *around)?;
        let mut part = first;
        let mut pockets = self.tell_part(upper, first, 0);
        while part.end != lower {
            let from = part.end;
            part = self.traverse(from, lower, part.onward)?;
            pockets = self.tell_part(from, part, pockets);
        }
        let is_unchanged = first.end == lower && self.traversal.pockets.is_empty();
        while let Some([from, to]) = self.traversal.pockets.pop() {
            let added = self.fill_front(from, to, Why::Pocket);
            self.predicates.probe.count(|c| c.pocket_triangles += added);
        }
        if self.mesh.get(around.triangle).vertex(around.corner) != upper {
            *around = self.leftmost(upper);
        }
        Ok(is_unchanged.then_some(first))
    }

    /// Tells what is in the way of a part that has just been surveyed, when `pockets` of the edge were
    /// known before. Returns how many are now.
    fn tell_part(&mut self, from: VertexId, part: Part, pockets: usize) -> usize {
        let now = self.traversal.pockets.len();
        let position = match (
            part.present,
            now > pockets,
            self.traversal.pierced.is_empty(),
        ) {
            (Some(_), ..) => EdgePosition::Present,
            (None, false, _) => EdgePosition::BelowFront,
            (None, true, true) => EdgePosition::FrontOnly,
            (None, true, false) => EdgePosition::Mixed,
        };
        self.tell(|name| Event::Part {
            from: name(from),
            to: name(part.end),
            position,
        });
        now
    }

    /// Makes a part of an edge a fixed side, after [`Sweep::traverse`] found what is in its way.
    /// Returns a triangle at either end.
    fn insert_part(&mut self, from: VertexId, part: Part) -> [Spoke; 2] {
        if let Some(side) = part.present {
            self.mesh.fix(side);
            self.predicates.probe.count(|c| c.edges_present += 1);
            self.tell(|name| Event::Fixed {
                side: [from, part.end].map(name),
            });
            [part.start, part.onward]
        } else {
            self.predicates.probe.count(|c| c.edges_inserted += 1);
            self.retriangulate(from, part.end)
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
                    .all(|&v| self.predicates.orient2d(upper, lower, v) == Equal)
            {
                crossed = other;
            }
        }
        let edges = [edge.min(crossed) as usize, edge.max(crossed) as usize];
        Error::CrossingEdges { edges }
    }
}

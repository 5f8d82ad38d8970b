//! The edge event (section 3.4.2): the edges whose upper end has just been swept are inserted, each as one *part* down to
//! the first vertex on it. The rest waits until the hull is complete ([`super::waiting_edges`]).
//!
//! Where the part runs above the front, the *pocket* between them is filled (figures 13 and 14). Then the part lies inside
//! the triangulation. If it is a side already, that side becomes constrained. Otherwise two pseudo-polygons replace the
//! pierced triangles (figure 12). Fast path: if at most [`EDGES_LOOKED_FOR`] edges end here and all are sides already,
//! they are found by vertex ids, without predicates.
//!
//! ```text
//!    upper                               A pocket (figure 13): the front runs below the edge, here at
//!     \  ` . .                           a, b and c, and comes back to it. Filled to its upper hull,
//!      \       ` . . edge                the pocket has the edge for a side. (Where the front comes
//!       \ pocket     ` . .               back above the edge, as in figure 14, the edge pierces
//!        a ----- b         ` . lower     triangles of the filled pocket.)
//!                 `-.__c__-'
//! ```
//!
//! Why it is right: a pocket lies above the front, so it is empty. It ends at nodes on or above the edge, so once it is
//! filled, the edge lies inside the triangulation. A new edge blocks views and opens none: other sides stay legal.
//!
//! Cost: one turn around the upper end by tests for all edges there; one test for each node passed and each triangle
//! pierced, or two where a pocket is filled. Differs from the paper: pockets are filled before triangles are removed,
//! where it collects both in one pseudo-polygon, and edges at one vertex come in an order that one turn can follow.

use alloc::vec::Vec;
use core::cmp::Ordering::Equal;
use core::mem::take;

use super::Sweep;
use super::traversal::{CrossedSide, Part, Traversal};
use super::waiting_edges::WaitingEdge;
use crate::error::Error;
use crate::ids::VertexId;
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use crate::trace::{EdgePosition, Event, Why};
use crate::tuning::EDGES_LOOKED_FOR;

impl<P: Probe> Sweep<'_, P> {
    /// Inserts the edges whose upper end is `upper`, the vertex swept last.
    pub(super) fn edge_event(&mut self, upper: VertexId) -> Result<(), Error> {
        let leftmost = self.leftmost(upper);
        if !self.find_sides(upper, leftmost) {
            let mut list = take(&mut self.lists.inserted);
            list.clear();
            list.extend_from_slice(self.lists.edges.at(upper));
            let inserted = self.insert_edges(upper, &mut list, leftmost);
            self.lists.inserted = list;
            return inserted;
        }
        for k in 0..self.traversed.present.len() {
            let (lower, edge) = self.lists.edges.at(upper)[k];
            self.constrain_edge(upper, lower, edge, self.traversed.present[k]);
        }
        Ok(())
    }

    /// Whether the edges with upper end `upper` are sides already; then `traversed.present` lists these. `leftmost` is
    /// the side opposite `upper` of the leftmost triangle there.
    #[inline(always)]
    fn find_sides(&mut self, upper: VertexId, leftmost: HalfEdge) -> bool {
        self.traversed.present.clear();
        let edges = self.lists.edges.at(upper);
        if edges.len() > EDGES_LOOKED_FOR {
            return false;
        }
        for &(lower, _) in edges {
            let Some(side) = self.spoke(leftmost, lower) else {
                return false;
            };
            self.traversed.present.push(side);
        }
        true
    }

    /// The side between `v` and the vertex opposite `leftmost`, a node of the front, if there is one.
    #[inline(always)]
    fn spoke(&self, leftmost: HalfEdge, v: VertexId) -> Option<HalfEdge> {
        let mesh = &self.delaunay.mesh;
        let [_, a, mut b] = mesh.around(leftmost);
        if a == v {
            return Some(leftmost.prev());
        }
        let mut at = leftmost;
        while b != v {
            let twin = mesh.twin(at.next());
            if twin.is_border() {
                return None;
            }
            at = twin.next();
            [_, _, b] = mesh.around(at);
        }
        Some(at.next())
    }

    /// Makes a side that is a whole edge constrained.
    #[inline(always)]
    fn constrain_edge(&mut self, upper: VertexId, lower: VertexId, edge: u32, side: HalfEdge) {
        self.delaunay.report(|name| Event::Edge {
            edge: edge as usize,
            upper: name(upper),
            lower: name(lower),
        });
        self.delaunay.report(|name| Event::Part {
            from: name(upper),
            to: name(lower),
            position: EdgePosition::Present,
        });
        self.constrain_side([upper, lower], side);
    }

    /// Makes the side between `ends` constrained.
    #[inline(always)]
    fn constrain_side(&mut self, ends: [VertexId; 2], side: HalfEdge) {
        self.delaunay.mesh.constrain(side);
        self.delaunay.probe.count(|c| c.edges_present += 1);
        self.delaunay.report(|name| Event::Fixed {
            side: ends.map(name),
        });
    }

    /// Inserts the edges of `list` (lower ends and input indices), which run down from `upper`, each to the first
    /// vertex on it. `around` is a half-edge opposite `upper`. Sorts the list.
    pub(super) fn insert_edges(
        &mut self,
        upper: VertexId,
        list: &mut Vec<(VertexId, u32)>,
        mut around: HalfEdge,
    ) -> Result<(), Error> {
        list.retain(|&(lower, _)| lower != upper);
        if list.len() > 1 {
            list.sort_by(|&(a, _), &(b, _)| {
                let turn = self.delaunay.orient2d([upper, a, b]);
                // On one line: the higher end first.
                turn.reverse().then_with(|| b.cmp(&a))
            });
            // Counter-clockwise, but the rightmost edge (with its equals) goes first. Once it and the leftmost are in,
            // no pocket is left beside the upper end, and one turn around it finds all others.
            let &(last, _) = list.last().expect("there are two");
            let is_equal = |&&(lower, _): &&(VertexId, u32)| lower == last;
            let equal = list.iter().rev().take_while(is_equal).count();
            list.rotate_right(equal);
        }
        let mut before = None;
        for &(lower, edge) in &*list {
            self.delaunay.report(|name| Event::Edge {
                edge: edge as usize,
                upper: name(upper),
                lower: name(lower),
            });
            let end = self
                .insert_edge(upper, lower, &mut around)
                .map_err(|crossed| self.crossing(edge, crossed))?;
            match before {
                // Equal edges are neighbours in the list.
                Some(of) if self.chains.are_equal(edge, of) => self.chains.share(edge, of),
                _ => {
                    before = Some(edge);
                    let from = end.unwrap_or(upper);
                    let waiting = WaitingEdge { from, edge, lower };
                    if end.is_none() {
                        self.waiting.defer(waiting);
                    } else if from != lower {
                        self.note_passed(edge, from)?;
                        self.waiting.push_rest(waiting);
                    }
                }
            }
        }
        Ok(())
    }

    /// Notes for the result that an edge passes through a vertex.
    pub(super) fn note_passed(&mut self, edge: u32, v: VertexId) -> Result<(), Error> {
        let vertex = self.delaunay.predicates.vertices.input_index(v);
        self.chains.pass(edge, vertex)
    }

    /// Inserts an edge down to the first vertex on it, which is returned; `None` if the edge has to be deferred. `around`,
    /// opposite `upper`, moves beside the edge.
    #[inline(always)]
    pub(super) fn insert_edge(
        &mut self,
        upper: VertexId,
        lower: VertexId,
        around: &mut HalfEdge,
    ) -> Result<Option<VertexId>, CrossedSide> {
        self.traversed.pockets.clear();
        let mut found = self.traverse(upper, lower, around)?;
        if let Traversal::Part(part) = found {
            self.report_part(upper, part);
        }
        // The pockets of an edge that is deferred are filled, too: then no other edge passes their nodes again.
        if self.fill_pockets() {
            // Filling may have flipped the triangle of `around`.
            if self.delaunay.mesh.opposite(*around) != upper {
                *around = self.leftmost(upper);
            }
            if let Traversal::Part(_) = found {
                found = self.traverse(upper, lower, around)?;
            }
        }
        self.waiting.spend(self.traversed.pierced.len());
        let Traversal::Part(part) = found else {
            return Ok(None);
        };
        *around = self.insert_part(upper, part);
        Ok(Some(part.end))
    }

    fn fill_pockets(&mut self) -> bool {
        let has_pockets = !self.traversed.pockets.is_empty();
        while let Some([from, to]) = self.traversed.pockets.pop() {
            self.fill_front(from, to, Why::Pocket);
        }
        has_pockets
    }

    fn report_part(&mut self, from: VertexId, part: Part) {
        let position = match part.present {
            Some(_) => EdgePosition::Present,
            None if self.traversed.pockets.is_empty() => EdgePosition::BelowFront,
            None if self.traversed.pierced.is_empty() => EdgePosition::FrontOnly,
            None => EdgePosition::Mixed,
        };
        self.delaunay.report(|name| Event::Part {
            from: name(from),
            to: name(part.end),
            position,
        });
    }

    /// Makes a part that [`Sweep::traverse`] has just found a constrained side. Returns a side opposite `from`.
    #[inline(always)]
    pub(super) fn insert_part(&mut self, from: VertexId, part: Part) -> HalfEdge {
        if let Some(side) = part.present {
            self.constrain_side([from, part.end], side);
            part.start
        } else {
            self.delaunay.probe.count(|c| c.edges_inserted += 1);
            let start = self
                .delaunay
                .replace_pierced(from, part.end, &self.traversed);
            self.lists
                .vertex_triangles
                .renew(&self.delaunay.mesh, &self.traversed.pierced);
            start
        }
    }

    /// Names the two input edges that cross: `edge`, and the first of those that contain the crossed side.
    pub(super) fn crossing(&mut self, edge: u32, [r, s]: CrossedSide) -> Error {
        let mut crossed = u32::MAX;
        let (low, high) = (r.min(s), r.max(s));
        for (upper, lower, other) in self.lists.edges.iter() {
            if other < crossed
                && lower <= low
                && high <= upper
                && lower != upper
                && [r, s]
                    .iter()
                    .all(|&v| self.delaunay.orient2d([upper, lower, v]) == Equal)
            {
                crossed = other;
            }
        }
        let edges = [edge.min(crossed) as usize, edge.max(crossed) as usize];
        Error::CrossingEdges { edges }
    }
}

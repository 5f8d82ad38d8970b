//! Which crossing is named: the one that the paper's order of insertion meets first.
//!
//! A run that has deferred edges ([`super::waiting_edges`]) meets some crossing of many. The error names the pair that
//! the edge events in sweep order, and then the rests, would have met first, so that one input has one error,
//! too. Each part of an edge has its [`Moment`] in that order. The first crossing is the one whose later part comes
//! first.
//!
//! So all begins anew, with the points alone, and with only those parts that come before the later part of the crossing
//! just met; in random order, as deferred edges. Each crossing met that way leaves fewer parts. When none is met any
//! more, the parts of the next moment are inserted as the paper would, and cross what is there.
//!
//! Why it is right: parts of one moment begin at one vertex, so they do not cross each other, and the first of them that
//! crosses anything crosses a part of an earlier moment.
//!
//! Cost: expected O(log k) rounds for k parts, each that of a run without crossings, because the crossing that a round
//! meets is that of random parts. The moment of the crossing itself is run in the paper's order, and where many edges
//! with vertices inside begin at one vertex, each of them turns around it: both can be quadratic on a star.

use alloc::vec::Vec;
use core::cmp::Ordering::Equal;
use core::cmp::Reverse;

use super::Sweep;
use super::contradiction::inexact_scalar;
use super::waiting_edges::WaitingEdge;
use crate::error::Error;
use crate::ids::VertexId;
use crate::observe::probe::Probe;
use crate::random::Random;

/// When the paper's order inserts a part of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Moment {
    /// In the edge event of this vertex, the upper end of the edge.
    EdgeEvent(VertexId),
    /// With the rests that begin at this vertex, after all edge events and from the last vertex to the first.
    Rest(Reverse<VertexId>),
}

impl<P: Probe> Sweep<'_, P> {
    /// Returns the crossing that the paper's order meets first.
    pub(super) fn first_crossing(&mut self) -> Error {
        // No edge begins at the first vertex, so all parts come before.
        let mut end = Moment::Rest(Reverse(VertexId::new(0)));
        loop {
            self.divide_and_conquer_points();
            self.waiting.allow_all();
            match self.insert_before(end) {
                Ok(rests) => return self.crossing_at(end, rests),
                Err(moment) if moment < end => end = moment,
                Err(_) => inexact_scalar(),
            }
        }
    }

    /// Inserts all parts that come before `end` in random order. Returns the rests that begin at the vertex of
    /// `end`, or the moment of the later part of two that cross.
    fn insert_before(&mut self, end: Moment) -> Result<Vec<WaitingEdge>, Moment> {
        let parts = self
            .lists
            .edges
            .iter()
            .filter(|&(upper, lower, _)| lower != upper && Moment::EdgeEvent(upper) < end);
        let begin = |(upper, lower, edge)| WaitingEdge {
            from: upper,
            edge,
            lower,
        };
        let mut edges: Vec<WaitingEdge> = parts.map(begin).collect();
        // The first of equal edges stands for all.
        edges.sort_unstable_by_key(|edge| (edge.from, edge.lower, edge.edge));
        edges.dedup_by_key(|edge| (edge.from, edge.lower));
        let mut random = Random::new();
        random.shuffle(&mut edges);
        for edge in &mut edges {
            self.advance(edge)?;
        }
        let Moment::Rest(Reverse(last)) = end else {
            return Ok(Vec::new());
        };
        random.shuffle(&mut edges);
        for edge in &mut edges {
            while edge.from > last && edge.from > edge.lower {
                self.advance(edge)?;
            }
        }
        edges.retain(|edge| edge.from == last && edge.from != edge.lower);
        edges.sort_unstable();
        Ok(edges)
    }

    /// Inserts the first part of an edge, which then begins behind it.
    fn advance(&mut self, edge: &mut WaitingEdge) -> Result<(), Moment> {
        let &mut WaitingEdge { from, lower, .. } = edge;
        match self.insert_first_part(from, lower) {
            Ok(end) => {
                edge.from = end;
                Ok(())
            }
            Err([a, b]) => {
                let part = self.moment(from, lower);
                Err(part.max(self.moment(a.max(b), a.min(b))))
            }
        }
    }

    /// When the part that begins at `from` and leads towards `lower` is inserted first: by an edge that ends there, or by
    /// a rest that begins there.
    fn moment(&mut self, from: VertexId, lower: VertexId) -> Moment {
        for &(end, _) in self.lists.edges.at(from) {
            if end != from && self.delaunay.orient2d([from, lower, end]) == Equal {
                return Moment::EdgeEvent(from);
            }
        }
        Moment::Rest(Reverse(from))
    }

    /// Inserts the parts of a moment in the paper's order, after all parts before it: one of them crosses another edge.
    fn crossing_at(&mut self, moment: Moment, rests: Vec<WaitingEdge>) -> Error {
        let (upper, mut list) = match moment {
            Moment::EdgeEvent(upper) => (upper, self.lists.edges.at(upper).to_vec()),
            Moment::Rest(Reverse(from)) => {
                let ends = |edge: WaitingEdge| (edge.lower, edge.edge);
                (from, rests.into_iter().map(ends).collect())
            }
        };
        let around = self.side_opposite(upper);
        match self.insert_edges(upper, &mut list, around) {
            Err(error) => error,
            Ok(()) => inexact_scalar(),
        }
    }
}

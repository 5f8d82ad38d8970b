//! Edges as chains of sides, from below.
//!
//! An edge waits at the last vertex that its chain has reached. A side is offered at its lower end, and is kept there until
//! that vertex is forgotten. When one of the two comes, they meet: a side that leads towards the upper end, and not beyond
//! it, is taken by the edge, which then waits at the side's upper end, or is done. A side may be taken by several edges,
//! which overlap: these wait together, by their upper ends. At the end no edge waits, and no side is left that must be part of one: because its triangles say so,
//! or because it is not Delaunay.
//!
//! Cost: a search among the sides and the directions of edges at one vertex, for each side and each edge; of edges that
//! overlap, where one begins on another, the fewer ones join the others.
//!
//! Edges are best given with their lower ends, before triangles. One that overlaps others and comes when a vertex on it
//! has been forgotten waits in vain: a right result is then refused, and a wrong one never accepted.

use alloc::collections::BTreeMap;
use core::cmp::Ordering;
use core::mem;

use super::StreamVerifier;
use super::border::upward;
use super::records::{Place, Towards, Up};
use super::violation::StreamViolation;
use crate::scalar::Scalar;

impl<S: Scalar + Clone> StreamVerifier<S> {
    /// An edge from a vertex that is known to a vertex at `upper`, which may be to come.
    ///
    /// # Errors
    /// The vertex is not known, or `upper` is not finite, or not above it by y, then x. (An edge of no length is none.)
    pub fn edge(&mut self, number: u64, from: u64, upper: [S; 2]) -> Result<(), StreamViolation> {
        let lower = &self.known(from)?.point;
        if !upper.iter().all(S::is_finite) || upward(lower, &upper).is_ge() {
            return Err(StreamViolation::BadEdge { edge: number });
        }
        self.report.edges += 1;
        let towards = self.towards(from, &upper);
        let ends = self.at(from).waiting.entry(towards).or_default();
        let place = upper.clone();
        ends.entry(Place(upper)).or_default().push(number);
        self.meet(from, &place);
        Ok(())
    }

    /// The ends of a side, the lower one first.
    fn lower_first(&self, [u, v]: [u64; 2]) -> [u64; 2] {
        match upward(&self.vertices[&u].point, &self.vertices[&v].point) {
            Ordering::Less => [u, v],
            _ => [v, u],
        }
    }

    /// Offers a side to the edges at its lower end. Must one take it?
    pub(super) fn offer(&mut self, side: [u64; 2], must_be_taken: bool) {
        let [low, high] = self.lower_first(side);
        let point = self.vertices[&high].point.clone();
        let towards = self.towards(low, &point);
        // Another side in this direction overlaps this one, and the border will show it.
        self.at(low).up.entry(towards).or_insert(Up {
            high,
            point: point.clone(),
            is_taken: false,
            unless_taken: None,
        });
        if must_be_taken {
            self.must_be_taken(side, StreamViolation::NoEdge { side: [low, high] });
        }
        self.meet(low, &point);
    }

    /// Notes that an edge must take a side, or else the side is a fault; `false` if it was not offered to any.
    pub(super) fn must_be_taken(&mut self, side: [u64; 2], fault: StreamViolation) -> bool {
        let [low, high] = self.lower_first(side);
        let towards = self.towards(low, &self.vertices[&high].point);
        let offered = self.at(low).up.get_mut(&towards);
        let Some(up) = offered.filter(|up| up.high == high) else {
            return false;
        };
        if !up.is_taken && up.unless_taken.is_none() {
            up.unless_taken = Some(fault);
            for end in [low, high] {
                self.at(end).unclaimed += 1;
            }
        }
        true
    }

    /// The direction from a vertex up to a place.
    fn towards(&self, vertex: u64, place: &[S; 2]) -> Towards<S> {
        Towards {
            from: self.vertices[&vertex].point.clone(),
            to: place.clone(),
        }
    }

    /// Lets the edges that wait at a vertex in the direction of a place, and from there at others, take their sides.
    fn meet(&mut self, vertex: u64, place: &[S; 2]) {
        let mut next = self.pass_on(vertex, place);
        while let Some((high, place)) = next {
            next = self.pass_on(high, &place);
        }
    }

    /// Lets edges take the side up from a vertex in the direction of a place. Returns the side's upper end and the end of
    /// an edge, if edges go on.
    fn pass_on(&mut self, at: u64, place: &[S; 2]) -> Option<(u64, [S; 2])> {
        let towards = self.towards(at, place);
        let side = self.vertices[&at].up.get(&towards)?;
        let (high, end) = (side.high, Place(side.point.clone()));
        if !self.vertices.contains_key(&high) {
            return None;
        }
        // Those that end before the side does cannot take it.
        let all = self.at(at).waiting.get_mut(&towards)?;
        let mut ends = all.split_off(&end);
        if all.is_empty() {
            self.at(at).waiting.remove(&towards);
        }
        if ends.is_empty() {
            return None;
        }
        let side = self.at(at).up.get_mut(&towards)?;
        let was_awaited = !side.is_taken && side.unless_taken.is_some();
        side.is_taken = true;
        if was_awaited {
            self.at(at).unclaimed -= 1;
            self.at(high).unclaimed -= 1;
        }
        ends.remove(&end);
        let last = ends.last_key_value()?.0.0.clone();
        let towards = self.towards(high, &last);
        let there = self.at(high).waiting.entry(towards).or_default();
        if there.len() < ends.len() {
            mem::swap(there, &mut ends);
        }
        for (end, edges) in ends {
            there.entry(end).or_default().extend(edges);
        }
        Some((high, last))
    }

    /// At the end no edge waits, and each constrained side is taken.
    pub(super) fn no_chain_is_broken(&self) -> Result<(), StreamViolation> {
        let waiting = self.vertices.iter().flat_map(|(&vertex, found)| {
            let edges = found.waiting.values().flat_map(BTreeMap::values).flatten();
            edges.map(move |&edge| (edge, vertex))
        });
        if let Some((edge, vertex)) = waiting.min() {
            return Err(StreamViolation::BrokenEdge { edge, vertex });
        }
        let faults = self.vertices.iter().flat_map(|(&low, found)| {
            let open = found.up.values().filter(|side| !side.is_taken);
            open.filter_map(move |side| Some(([low, side.high], side.unless_taken?)))
        });
        match faults.min_by_key(|(side, _)| *side) {
            Some((_, fault)) => Err(fault),
            None => Ok(()),
        }
    }
}

//! Edges as chains of sides, from below.
//!
//! An edge waits at the last vertex that its chain has reached. A side is offered at its lower end, and is kept there until
//! that vertex is forgotten. When one of the two comes, they meet: a side that leads towards the upper end, and not beyond
//! it, is taken by the edge, which then waits at the side's upper end, or is done. A side may be taken by several edges,
//! which overlap. At the end no edge waits, and no side is left that must be part of one: because its triangles say so,
//! or because it is not Delaunay.
//!
//! Edges are best given with their lower ends, before triangles. One that overlaps others and comes when a vertex on it
//! has been forgotten waits in vain: a right result is then refused, and a wrong one never accepted.

use core::cmp::Ordering;

use super::StreamVerifier;
use super::border::upward;
use super::records::{Up, Vertex};
use super::violation::StreamViolation;
use crate::scalar::{Scalar, filtered_orient2d};

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
        self.at(from).waiting.push((number, upper));
        self.meet(from);
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
        self.at(low).up.push(Up {
            high,
            point,
            is_taken: false,
            unless_taken: None,
        });
        if must_be_taken {
            self.must_be_taken(side, StreamViolation::NoEdge { side: [low, high] });
        }
        self.meet(low);
    }

    /// Notes that an edge must take a side, or else the side is a fault; `false` if it was not offered to any.
    pub(super) fn must_be_taken(&mut self, side: [u64; 2], fault: StreamViolation) -> bool {
        let [low, high] = self.lower_first(side);
        let mut offered = self.at(low).up.iter_mut();
        let Some(up) = offered.find(|up| up.high == high) else {
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

    /// Lets edges that wait at a vertex, and from there at others, take the sides up from it.
    fn meet(&mut self, vertex: u64) {
        let mut places = alloc::vec![vertex];
        while let Some(at) = places.pop() {
            let waiting = core::mem::take(&mut self.at(at).waiting);
            for (edge, upper) in waiting {
                let Some(taken) = self.side_towards(at, &upper) else {
                    self.at(at).waiting.push((edge, upper));
                    continue;
                };
                let side = &mut self.at(at).up[taken];
                let high = side.high;
                let was_awaited = !side.is_taken && side.unless_taken.is_some();
                side.is_taken = true;
                let goes_on = upward(&side.point, &upper).is_lt();
                if was_awaited {
                    self.at(at).unclaimed -= 1;
                    self.at(high).unclaimed -= 1;
                }
                if goes_on {
                    self.at(high).waiting.push((edge, upper));
                    places.push(high);
                }
            }
        }
    }

    /// The side up from a vertex that is part of an edge to `upper`, if its end is known still.
    fn side_towards(&self, at: u64, upper: &[S; 2]) -> Option<usize> {
        let Vertex { point, up, .. } = &self.vertices[&at];
        up.iter().position(|side| {
            filtered_orient2d(point, upper, &side.point).is_eq()
                && upward(&side.point, upper).is_le()
                && self.vertices.contains_key(&side.high)
        })
    }

    /// At the end no edge waits, and each constrained side is taken.
    pub(super) fn no_chain_is_broken(&self) -> Result<(), StreamViolation> {
        let mut broken = None;
        for (&vertex, found) in &self.vertices {
            for &(edge, _) in &found.waiting {
                broken = broken.min(Some((edge, vertex))).or(Some((edge, vertex)));
            }
        }
        if let Some((edge, vertex)) = broken {
            return Err(StreamViolation::BrokenEdge { edge, vertex });
        }
        let faults = self.vertices.iter().flat_map(|(&low, found)| {
            let open = found.up.iter().filter(|side| !side.is_taken);
            open.filter_map(move |side| Some(([low, side.high], side.unless_taken?)))
        });
        match faults.min_by_key(|(side, _)| *side) {
            Some((_, fault)) => Err(fault),
            None => Ok(()),
        }
    }
}

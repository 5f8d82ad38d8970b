//! Edges as chains of sides, from below.
//!
//! An edge waits at the last vertex that its chain has reached. A side is offered at its lower end while any edge waits.
//! It begins a *run*, which grows where vertices are [forgotten](super::forget). When an edge and a run that leads towards
//! its upper end, and not beyond it, meet at a vertex, the edge takes the run, and then waits at the run's upper end, or is
//! done. A run may be taken by several edges, which overlap: these wait together, by their upper ends. At the end no edge
//! waits, and no side is left that must be part of one: because its triangles say so, or because it is not Delaunay.
//!
//! Why sides are seen by all edges: an edge comes before triangles with a corner at or above its lower end, so before each
//! side on it. What comes later is refused at once.
//!
//! Cost: a search among the runs and the directions of edges at one vertex, for each side and each edge; of edges that
//! overlap, where one begins on another, the fewer ones join the others. But where the triangles at such edges come from
//! above, each edge takes its sides by itself, as far as they are not joined.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::mem;

use super::StreamVerifier;
use super::border::upward;
use super::records::{Place, Towards, Up};
use super::violation::StreamViolation;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::Level;

impl<S: Scalar + Clone> StreamVerifier<S> {
    /// An edge from a vertex that is known to a vertex at `upper`, which may be to come. Edges come before triangles; or
    /// each with its lower end, in the order of a sweep: before any triangle with a corner there or above, by y, then x.
    ///
    /// # Errors
    /// The vertex is not known, or `upper` is not finite, or not above it by y, then x. (An edge of no length is none.)
    /// Or the edge comes too late.
    pub fn edge(&mut self, number: u64, from: u64, upper: [S; 2]) -> Result<(), StreamViolation> {
        let from = self.known(from)?;
        let lower = &self.vertices.at(from).point;
        if !upper.iter().all(S::is_finite) || upward(lower, &upper).is_ge() {
            return Err(StreamViolation::BadEdge { edge: number });
        }
        let reached = self.highest.as_ref();
        if reached.is_some_and(|highest| upward(lower, highest).is_le()) {
            return Err(StreamViolation::LateEdge { edge: number });
        }
        let towards = Towards::new(lower, &upper);
        self.report.edges += 1;
        if self.level >= Level::Constrained {
            *self.ends.entry(Place(upper.clone())).or_default() += 1;
            let vertex = self.vertices.at_mut(from);
            let ends = vertex.waiting.entry(towards).or_default();
            ends.entry(Place(upper)).or_default().push(number);
        }
        Ok(())
    }

    /// Offers a side, with the places of its ends, to the edges at its lower end. Must one take it?
    pub(super) fn offer(&mut self, side: [u64; 2], places: [&[S; 2]; 2], must_be_taken: bool) {
        let [(low, from), (high, to)] = lower_first(side, places);
        let vertex = self.at(low);
        let is_awaited = !vertex.waiting.is_empty();
        // Another side in this direction overlaps this one, and the border will show it.
        if let Entry::Vacant(none) = vertex.up.entry(Towards::new(from, to)) {
            none.insert(Up {
                high,
                point: to.clone(),
                is_taken: false,
                unless_taken: None,
            });
            self.at(high).down.insert(Towards::new(to, from), low);
        }
        if must_be_taken {
            let fault = StreamViolation::NoEdge { side: [low, high] };
            self.must_be_taken(side, places, fault);
        }
        if is_awaited {
            self.meet(low, to.clone());
        }
    }

    /// Notes that an edge must take a side, or else the side is a fault; `false` if it was not offered to any.
    pub(super) fn must_be_taken(
        &mut self,
        side: [u64; 2],
        places: [&[S; 2]; 2],
        fault: StreamViolation,
    ) -> bool {
        let [(low, from), (high, to)] = lower_first(side, places);
        let offered = self.at(low).up.get_mut(&Towards::new(from, to));
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

    /// Lets the edges that wait at a vertex in the direction of a place, and from there at others, take their runs.
    fn meet(&mut self, vertex: u64, place: [S; 2]) {
        let mut next = Some((vertex, place));
        while let Some((at, place)) = next {
            next = self.pass_on(at, &place);
        }
    }

    /// Lets edges take the run up from a vertex in the direction of a place. Returns the run's upper end and the end of
    /// an edge, if edges go on.
    fn pass_on(&mut self, at: u64, place: &[S; 2]) -> Option<(u64, [S; 2])> {
        let vertex = self.vertices.get(at)?;
        let towards = Towards::new(&vertex.point, place);
        let run = vertex.up.get(&towards)?;
        let (high, end) = (run.high, Place(run.point.clone()));
        self.vertices.slot(high)?;
        // Those that end before the run does cannot take it.
        let waiting = &mut self.at(at).waiting;
        let all = waiting.get_mut(&towards)?;
        let mut ends = all.split_off(&end);
        if all.is_empty() {
            waiting.remove(&towards);
        }
        if ends.is_empty() {
            return None;
        }
        self.loose.extend([at, high]);
        let vertex = self.at(at);
        let run = vertex.up.get_mut(&towards)?;
        let was_awaited = !run.is_taken && run.unless_taken.is_some();
        run.is_taken = true;
        if was_awaited {
            vertex.unclaimed -= 1;
            self.at(high).unclaimed -= 1;
        }
        if let Some(done) = ends.remove(&end) {
            self.end(end, done.len());
        }
        let last = ends.last_key_value()?.0.0.clone();
        let vertex = self.at(high);
        let towards = Towards::new(&vertex.point, &last);
        let there = vertex.waiting.entry(towards).or_default();
        if there.len() < ends.len() {
            mem::swap(there, &mut ends);
        }
        for (end, edges) in ends {
            there.entry(end).or_default().extend(edges);
        }
        Some((high, last))
    }

    /// So many edges that waited are done, and end at a place.
    fn end(&mut self, place: Place<S>, edges: usize) {
        if let Entry::Occupied(mut waiting) = self.ends.entry(place) {
            *waiting.get_mut() -= edges;
            if *waiting.get() == 0 {
                waiting.remove();
            }
        }
    }

    /// At the end no edge waits, and each constrained side is taken.
    pub(super) fn no_chain_is_broken(&self) -> Result<(), StreamViolation> {
        let waiting = self.vertices.iter().flat_map(|vertex| {
            let edges = vertex.waiting.values().flat_map(BTreeMap::values).flatten();
            edges.map(|&edge| (edge, vertex.number))
        });
        if let Some((edge, vertex)) = waiting.min() {
            return Err(StreamViolation::BrokenEdge { edge, vertex });
        }
        let faults = self.vertices.iter().flat_map(|low| {
            let open = low.up.values().filter(|run| !run.is_taken);
            open.filter_map(|run| Some(([low.number, run.high], run.unless_taken?)))
        });
        match faults.min_by_key(|(side, _)| *side) {
            Some((_, fault)) => Err(fault),
            None => Ok(()),
        }
    }
}

/// The ends of a side with their places, the lower one first.
fn lower_first<S: Scalar>([u, v]: [u64; 2], [p, q]: [&[S; 2]; 2]) -> [(u64, &[S; 2]); 2] {
    match upward(p, q) {
        Ordering::Less => [(u, p), (v, q)],
        _ => [(v, q), (u, p)],
    }
}

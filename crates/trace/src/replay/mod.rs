//! Replays a trace on an empty mesh, without any geometry, and refuses one that no run can have made.
//! [`Trace::replay`](crate::Trace::replay) says what is checked. Each event is checked against the state that the
//! events before it made: mesh, front, the edge being inserted, and, where the sweep has no choice, the events that
//! must follow. Cost: O(log n) an event, and O(n log n) for the checks at the end.

mod edge;
mod events;
mod mesh;

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use crate::bad_trace::BadTrace;
use edge::Edge;
use mesh::{Front, Mesh};
use sweep_cdt::trace::{Event, Vertex};

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Phase {
    Sorting,
    Sweeping,
    Finalizing,
    Removing,
    Finished,
}

#[derive(Debug)]
struct Replay {
    phase: Phase,
    order: Vec<Vertex>,
    ranks: BTreeMap<Vertex, usize>,
    swept: usize,
    mesh: Mesh,
    front: Front,
    /// The events that must come next, in this order.
    due: VecDeque<Event>,
    /// The left end of the segment of a left case, whose second triangle is still to come.
    below: Option<Vertex>,
    edge: Option<Edge>,
    edges: BTreeSet<usize>,
    /// For the ends of each edge that was begun, upper end first, the end of its first part.
    first_parts: BTreeMap<[Vertex; 2], Vertex>,
    /// Pending edges: the vertex on the edge where each goes on, its lower end, its number.
    rests: BTreeSet<(Vertex, Vertex, usize)>,
}

pub(super) fn replay(events: &[Event]) -> Result<Vec<[usize; 3]>, BadTrace> {
    let mut replay = Replay::new();
    for (line, &event) in (2..).zip(events) {
        replay
            .step(event)
            .map_err(|message| BadTrace { line, message })?;
    }
    if replay.phase != Phase::Finished {
        let (line, message) = (events.len() + 2, "the trace ends too early".to_owned());
        return Err(BadTrace { line, message });
    }
    let index = |v| match v {
        Vertex::Input(v) => v,
        Vertex::Left | Vertex::Right => unreachable!("artificial triangles are gone"),
    };
    let triangles = replay.mesh.triangles().into_iter();
    Ok(triangles.map(|vertices| vertices.map(index)).collect())
}

fn ensure(condition: bool, message: impl FnOnce() -> String) -> Result<(), String> {
    if condition { Ok(()) } else { Err(message()) }
}

impl Replay {
    fn new() -> Replay {
        Replay {
            phase: Phase::Sorting,
            order: Vec::new(),
            ranks: BTreeMap::new(),
            swept: 0,
            mesh: Mesh::default(),
            front: Front::new(),
            due: VecDeque::new(),
            below: None,
            edge: None,
            edges: BTreeSet::new(),
            first_parts: BTreeMap::new(),
            rests: BTreeSet::new(),
        }
    }

    fn step(&mut self, event: Event) -> Result<(), String> {
        ensure(self.phase != Phase::Finished, || {
            "the trace is over".to_owned()
        })?;
        let due = self.due.front().copied();
        if let Some(due) = due {
            ensure(event == due, || format!("`{due}` must be here"))?;
            self.due.pop_front();
        }
        let is_within = matches!(
            event,
            Event::Triangle { .. }
                | Event::Test { .. }
                | Event::Flip { .. }
                | Event::FrontInsert { .. }
                | Event::FrontRemove { .. }
        );
        if !is_within {
            self.front.settle(&self.mesh)?;
        }
        self.apply(event, due.is_some())
    }
}

//! The sweep (section 3): initialization, point events and edge events in sweep order, finalization.
//!
//! Invariants between two events, for the vertices swept so far:
//! - the region under the front and above the lower hull is triangulated, and so is, by artificial
//!   triangles, all below;
//! - that triangulation is the canonical constrained Delaunay one of its region, with the edges
//!   inserted so far;
//! - the front runs from P-1 to P-2 and is strictly x-monotone.
//!
//! Cost: O(n log n) expected on the inputs that one meets; O(n^2) at worst, since Lawson's flips can be
//! that many for any algorithm that keeps a Delaunay triangulation of the points swept so far.
//!
//! Differs from the paper: see the parts ([`point_event`], [`edge_event`], [`fill`], [`finalize`]).

mod edge_event;
mod fill;
mod finalize;
mod legalize;
mod point_event;
mod retriangulate;
mod traverse;

use std::time::Instant;

use crate::front::{Domain, Front, FrontNode, FrontSearch};
use crate::input::{self, Edges};
use crate::mesh::{Link, Mesh, TriangleId, VertexId, index};
use crate::predicates::Predicates;
use crate::probe::Probe;
use crate::trace::{Event, Vertex, Why};
use crate::triangulation::Chains;
use crate::triangulator::Progress;
use crate::{Error, Heuristics, Scalar, Stats, Triangulation};

/// How many point events pass between two reports of progress.
const REPORT: VertexId = 4096;

/// The state between two events.
struct Sweep<'a, S, F, P> {
    predicates: Predicates<'a, S, P>,
    edges: Edges,
    chains: Chains,
    mesh: Mesh,
    front: Front,
    search: F,
    heuristics: Heuristics,
    /// Sides that legalization still has to test.
    suspects: Vec<Link>,
    /// Working memory of the parts, kept from one event to the next.
    filling: fill::Filling,
    traversal: traverse::Traversal,
}

/// Runs the three parts of section 3.2.
pub(crate) fn run<S: Scalar, F: FrontSearch, P: Probe>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    heuristics: Heuristics,
    mut progress: Progress<'_>,
    probe: P,
) -> Result<(Triangulation, Stats, P), Error> {
    let start = Instant::now();
    let vertices = input::vertices(points)?;
    let (listed, ends) = input::edges(&vertices, points.len(), edges)?;
    let n = index(vertices.input.len());
    let search = F::new(Domain::new(&vertices.near));
    let mut sweep = Sweep {
        predicates: Predicates::new(points, vertices, probe),
        edges: listed,
        chains: Chains {
            ends,
            ..Chains::default()
        },
        mesh: Mesh::new(2 * n as usize + 2, n as usize + 2),
        front: Front::new(n as usize),
        search,
        heuristics,
        suspects: Vec::new(),
        filling: fill::Filling::default(),
        traversal: traverse::Traversal::default(),
    };

    sweep.tell_order(n);
    let swept = Instant::now();
    for v in 0..n {
        if v == 0 {
            sweep.first_triangle();
        } else {
            sweep.point_event(v);
        }
        if !sweep.edges.at(v).is_empty() {
            sweep.edge_event(v)?;
        }
        if v % REPORT == 0
            && let Some(progress) = &mut progress
        {
            progress(v as usize, n as usize);
        }
    }

    let finalized = Instant::now();
    let mut stats = Stats {
        points: points.len(),
        edges: edges.len(),
        initialization: swept - start,
        sweeping: finalized - swept,
        memory: sweep.memory(),
        ..Stats::default()
    };
    let (result, probe) = sweep.finalize();
    stats.finalization = finalized.elapsed();
    stats.duplicates = result.duplicates.len();
    stats.triangles = result.len();
    stats.hull = result.hull.len();
    Ok((result, stats, probe))
}

impl<S: Scalar, F: FrontSearch, P: Probe> Sweep<'_, S, F, P> {
    /// The initial triangle of the first vertex and the artificial points (figure 6).
    fn first_triangle(&mut self) {
        let (left, right) = (self.predicates.left, self.predicates.right);
        let links = [Link::OUTSIDE, Link::open(0), Link::open(left)];
        self.make([0, left, right], links, Why::First);
        self.put_on_front(0, left);
    }

    /// Adds a triangle to the mesh.
    #[inline(always)]
    fn make(&mut self, vertices: [VertexId; 3], links: [Link; 3], why: Why) -> TriangleId {
        self.tell(|name| Event::Triangle {
            vertices: vertices.map(name),
            why,
        });
        self.mesh.add(vertices, links)
    }

    /// Tells the observer of a step, if there is one; vertices get their names in `event`.
    #[inline(always)]
    fn tell(&mut self, event: impl FnOnce(&dyn Fn(VertexId) -> Vertex) -> Event) {
        if P::EVENTS {
            let predicates = &self.predicates;
            let event = event(&|v| match predicates.vertices.input.get(v as usize) {
                Some(&input) => Vertex::Input(input),
                None if v == predicates.left => Vertex::Left,
                None => Vertex::Right,
            });
            self.predicates.probe.event(event);
        }
    }

    /// Tells the observer the sweep order.
    fn tell_order(&mut self, vertices: VertexId) {
        if P::EVENTS {
            for v in 0..vertices {
                self.tell(|name| Event::Sorted { vertex: name(v) });
            }
        }
    }

    /// Puts `v` on the front between `left` and the node after it.
    #[inline(always)]
    fn put_on_front(&mut self, v: VertexId, left: VertexId) {
        self.front.put(v, left);
        self.tell(|name| Event::FrontInsert {
            vertex: name(v),
            after: name(left),
        });
        self.search
            .inserted(FrontNode::new(v), self.predicates.near(v)[0]);
    }

    /// Takes `v`, which triangles now cover, off the front.
    #[inline(always)]
    fn take_off_front(&mut self, v: VertexId) {
        self.front.take(v);
        self.tell(|name| Event::FrontRemove { vertex: name(v) });
        self.search
            .removed(FrontNode::new(v), self.predicates.near(v)[0]);
    }

    /// Bytes of the arrays that grow with the input.
    fn memory(&self) -> usize {
        let vertices = &self.predicates.vertices;
        self.mesh.memory()
            + self.front.memory()
            + vertices.near.capacity() * size_of::<[f64; 2]>()
            + vertices.input.capacity() * size_of::<u32>()
            + self.edges.memory()
            + self.chains.ends.capacity() * size_of::<[u32; 2]>()
    }
}

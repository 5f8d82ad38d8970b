//! The triangles and the exact signs: the part of the state that knows neither the front nor the edges.
//!
//! Legalization ([`super::legalization`]) and the filling of chains ([`super::chain`]) need no more than
//! this. The state of the whole sweep ([`super::state`]) contains it and adds the front and the edges.

use std::cmp::Ordering;
use std::mem::take;

use super::flip_limit::FlipLimit;
use super::memory::Memory;
use super::polygons::Polygons;
use super::signs::SweepPredicates;
use super::stretch::Stretch;
use crate::ids::{TriangleId, VertexId};
use crate::mesh::{Mesh, Side};
use crate::probe::Probe;
use crate::trace::{Event, Vertex, Why};

/// Triangles, exact signs, and the sides that legalization still has to test.
#[derive(Debug)]
pub(super) struct Fabric<'a, S, P> {
    pub(super) mesh: Mesh,
    pub(super) signs: SweepPredicates<'a, S>,
    /// Sides that may be illegal.
    pub(super) suspects: Vec<Side>,
    pub(super) flip_limit: FlipLimit,
    /// Working memory of the chains, kept from one to the next.
    pub(super) stretch: Stretch,
    /// The same of pseudo-polygons.
    pub(super) polygons: Polygons,
    pub(super) probe: P,
}

impl<'a, S: crate::scalar::Scalar, P: Probe> Fabric<'a, S, P> {
    /// The triangles of `memory`, with the signs of their vertices. `has_budget` if the work may be abandoned.
    pub(super) fn new(
        signs: SweepPredicates<'a, S>,
        has_budget: bool,
        probe: P,
        memory: &mut Memory,
    ) -> Self {
        let flip_limit = FlipLimit::new(signs.vertices.len(), has_budget);
        Fabric {
            mesh: take(&mut memory.mesh),
            signs,
            suspects: take(&mut memory.suspects),
            flip_limit,
            stretch: take(&mut memory.stretch),
            polygons: take(&mut memory.polygons),
            probe,
        }
    }

    /// Adds a triangle to the mesh.
    #[inline(always)]
    pub(super) fn make(&mut self, v: [VertexId; 3], across: [Side; 3], why: Why) -> TriangleId {
        self.report(|name| Event::Triangle {
            vertices: v.map(name),
            why,
        });
        let t = self.mesh.add(v, across);
        self.probe.record(|r| r.made(t, why));
        t
    }

    /// Whether steps are reported to somebody.
    #[inline(always)]
    pub(super) fn is_observed(&self) -> bool {
        P::RECORDS && self.probe.wants_events()
    }

    /// Reports a step to the observer, if there is one; vertices get their names in `event`.
    #[inline(always)]
    pub(super) fn report(&mut self, event: impl FnOnce(&dyn Fn(VertexId) -> Vertex) -> Event) {
        if self.is_observed() {
            self.pass_on(event);
        }
    }

    /// Passes a step on to the observer.
    #[cold]
    #[inline(never)]
    fn pass_on(&mut self, event: impl FnOnce(&dyn Fn(VertexId) -> Vertex) -> Event) {
        let signs = &self.signs;
        let event = event(&|v| match signs.vertices.input.get(v.index()) {
            Some(&input) => Vertex::Input(input),
            None if v == signs.artificial.left => Vertex::Left,
            None => Vertex::Right,
        });
        self.probe.event(event);
    }

    /// `Greater` if three real vertices turn left.
    #[inline(always)]
    pub(super) fn orient2d(&mut self, vertices: [VertexId; 3]) -> Ordering {
        self.signs.orient2d(vertices, &mut self.probe)
    }

    /// The same where these are their doubles.
    #[inline(always)]
    pub(super) fn orient2d_near(
        &mut self,
        vertices: [VertexId; 3],
        near: [[f64; 2]; 3],
    ) -> Ordering {
        self.signs.orient2d_near(vertices, near, &mut self.probe)
    }

    /// Which side of the ray `from`-`to` a vertex is on; see [`SweepPredicates::side`].
    pub(super) fn side(&mut self, ray: [VertexId; 2], v: VertexId) -> Ordering {
        self.signs.side(ray, v, &mut self.probe)
    }
}

//! The triangles and the predicates: the part of the state that knows neither the front nor the edges. Legalization
//! ([`legalization`]) and the filling of chains ([`fill`]) need no more; [`super`] adds the rest.
mod cavity;
mod fan;
mod fill;
mod legalization;
mod pseudo_polygon;
mod run;

use alloc::vec::Vec;
use core::cmp::Ordering;
use core::mem::take;

use super::flip_limit::FlipLimit;
use super::predicates::SweepPredicates;
use super::scratch::Scratch;
use crate::ids::{TriangleId, VertexId};
use crate::mesh::{HalfEdge, Mesh};
use crate::observe::probe::Probe;
use crate::trace::{Event, Vertex, Why};
pub(super) use cavity::Polygons;
pub(super) use fill::ChainVertex;
pub(super) use run::{Random, Run};

/// Triangles, predicates, and the sides that legalization still has to test.
#[derive(Debug)]
pub(super) struct Delaunay<'a, P> {
    pub(super) mesh: Mesh,
    pub(super) predicates: SweepPredicates<'a>,
    pub(super) flip_stack: Vec<HalfEdge>,
    pub(super) flip_limit: FlipLimit,
    /// Buffers of [`Delaunay::insert_run`].
    pub(super) run: Run,
    /// Buffers of [`Delaunay::replace_pierced`].
    pub(super) polygons: Polygons,
    pub(super) probe: P,
}

impl<'a, P: Probe> Delaunay<'a, P> {
    /// The triangles of `scratch`, with the predicates of their vertices. `has_budget` if the work may be abandoned.
    pub(super) fn new(
        predicates: SweepPredicates<'a>,
        has_budget: bool,
        probe: P,
        scratch: &mut Scratch,
    ) -> Self {
        let flip_limit = FlipLimit::new(predicates.vertices.len(), has_budget);
        Delaunay {
            mesh: take(&mut scratch.mesh),
            predicates,
            flip_stack: take(&mut scratch.flip_stack),
            flip_limit,
            run: take(&mut scratch.run),
            polygons: take(&mut scratch.polygons),
            probe,
        }
    }

    #[inline(always)]
    pub(super) fn add_triangle(
        &mut self,
        v: [VertexId; 3],
        twins: [HalfEdge; 3],
        why: Why,
    ) -> TriangleId {
        self.report(|name| Event::Triangle {
            vertices: v.map(name),
            why,
        });
        let t = self.mesh.add(v, twins);
        self.probe.record(|r| r.made(t, why));
        t
    }

    /// Whether steps are reported to somebody.
    #[inline(always)]
    pub(super) fn is_observed(&self) -> bool {
        P::RECORDS && self.probe.wants_events()
    }

    /// Reports a step to the observer, if there is one; `event` gets a function that names vertices.
    #[inline(always)]
    pub(super) fn report(&mut self, event: impl FnOnce(&dyn Fn(VertexId) -> Vertex) -> Event) {
        if self.is_observed() {
            self.pass_on(event);
        }
    }

    #[cold]
    #[inline(never)]
    fn pass_on(&mut self, event: impl FnOnce(&dyn Fn(VertexId) -> Vertex) -> Event) {
        let predicates = &self.predicates;
        let event = event(&|v| match predicates.vertices.input.get(v.index()) {
            Some(&input) => Vertex::Input(input),
            None if v == predicates.artificial.left => Vertex::Left,
            None => Vertex::Right,
        });
        self.probe.event(event);
    }

    /// `Greater` if three real vertices turn left.
    #[inline(always)]
    pub(super) fn orient2d(&mut self, vertices: [VertexId; 3]) -> Ordering {
        self.predicates.orient2d(vertices, &mut self.probe)
    }

    /// `Greater` if three real vertices with these approximations turn left.
    #[inline(always)]
    pub(super) fn orient2d_approx(
        &mut self,
        vertices: [VertexId; 3],
        approx: [[f64; 2]; 3],
    ) -> Ordering {
        self.predicates
            .orient2d_approx(vertices, approx, &mut self.probe)
    }

    /// Which side of the ray `from`-`to`, down or up, a vertex is on; see [`SweepPredicates::side`].
    pub(super) fn side(&mut self, [from, to]: [VertexId; 2], v: VertexId) -> Ordering {
        if to < from {
            self.predicates.side([from, to], v, &mut self.probe)
        } else {
            let side = self.predicates.side([to, from], v, &mut self.probe);
            side.reverse()
        }
    }
}

//! The triangles and the predicates: the part of the state that knows neither the front nor the edges. Legalization
//! ([`legalization`]) and the filling of chains ([`fill`]) need no more; [`super`] adds the rest.
mod cavity;
mod fan;
mod fill;
mod legalization;
mod random_order;

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::flip_limit::FlipLimit;
use super::predicates::SweepPredicates;
use crate::ids::{TriangleId, VertexId};
use crate::mesh::{HalfEdge, Mesh};
use crate::observe::probe::Probe;
use crate::settings::{Algorithm, Settings};
use crate::trace::{Event, Vertex, Why};
use crate::tuning::Tuning;
use cavity::Polygons;
pub(super) use fill::ChainVertex;
use random_order::Run;

/// The memory of legalization and filling.
#[derive(Debug, Default)]
pub(super) struct Buffers {
    flip_stack: Vec<HalfEdge>,
    run: Run,
    polygons: Polygons,
}

/// Triangles, predicates, and the sides that legalization still has to test. The whole sweep uses
/// the first six fields; the others are this folder's own.
#[derive(Debug)]
pub(super) struct Delaunay<'a, P> {
    pub(super) mesh: Mesh,
    pub(super) predicates: SweepPredicates<'a>,
    pub(super) flip_limit: FlipLimit,
    pub(super) probe: P,
    /// Whether edges are inserted as in the paper.
    pub(super) is_paper: bool,
    pub(super) tuning: &'static Tuning,
    flip_stack: &'a mut Vec<HalfEdge>,
    /// Of [`Delaunay::insert_run`].
    run: &'a mut Run,
    /// Of [`Delaunay::replace_pierced`].
    polygons: &'a mut Polygons,
}

impl<'a, P: Probe> Delaunay<'a, P> {
    /// The triangles of `mesh`, with the predicates of their vertices.
    pub(super) fn new(
        mesh: Mesh,
        predicates: SweepPredicates<'a>,
        settings: Settings,
        probe: P,
        buffers: &'a mut Buffers,
    ) -> Self {
        let Settings {
            algorithm, tuning, ..
        } = settings;
        let reserve = (algorithm == Algorithm::Auto).then_some(tuning.reserve);
        let flip_limit = FlipLimit::new(predicates.vertices.len(), reserve);
        let Buffers {
            flip_stack,
            run,
            polygons,
        } = buffers;
        // A panic of the caller's scalar may have left sides there.
        flip_stack.clear();
        Delaunay {
            mesh,
            predicates,
            flip_limit,
            probe,
            is_paper: algorithm == Algorithm::Paper,
            tuning,
            flip_stack,
            run,
            polygons,
        }
    }

    /// Forgets the sides on the flip stack.
    #[cfg(feature = "comparison")]
    pub(super) fn clear_stack(&mut self) {
        self.flip_stack.clear();
    }

    /// Puts sides on the flip stack.
    pub(super) fn stack(&mut self, sides: impl IntoIterator<Item = HalfEdge>) {
        self.flip_stack.extend(sides);
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
            Some(&input) => Vertex::Input(input as usize),
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

//! Initialization (section 3.3): the vertices in sweep order, the edges at their upper ends, the
//! artificial points and the first triangle.
//!
//! Cost: that of the sort ([`super::order`]), and O(n) for n points and edges.
//!
//! Differs from the paper: see [`super::vertices`], [`super::edges`] and [`super::artificial`].

use std::mem::take;
use std::sync::Arc;

use super::fabric::Fabric;
use super::located::Located;
use super::memory::Memory;
use super::signs::SweepPredicates;
use super::state::Sweep;
use super::vertices::Vertices;
use crate::chains::ChainNotes;
use crate::error::Error;
use crate::front::{Domain, Search};
use crate::ids::{OpenId, VertexId, narrow};
use crate::mesh::Side;
use crate::probe::Probe;
use crate::recorder::Phase;
use crate::scalar::Scalar;
use crate::settings::{Algorithm, Settings};
use crate::trace::{Event, Why};

/// Sorts and merges the points, lists the edges and makes the first triangle.
pub(super) fn initialize<'a, S: Scalar, P: Probe>(
    points: &'a [[S; 2]],
    edges: &[[usize; 2]],
    settings: Settings<'_>,
    search: Search<'a>,
    mut probe: P,
    memory: &mut Memory,
) -> Result<Sweep<'a, S, P>, Error> {
    probe.begin(Phase::Initialization);
    // Vertices and edges; too many or wrong ones are refused.
    if points.len() > LIMIT {
        return Err(Error::TooManyPoints {
            given: points.len(),
            limit: LIMIT,
        });
    }
    let located = Located::new(points)?;
    let order = take(&mut memory.order);
    let inputs = 0..narrow(points.len());
    let vertices = Vertices::new(&located, inputs, order, &mut memory.sort);
    drop(located);
    if edges.len() > LIMIT {
        return Err(Error::TooManyEdges {
            given: edges.len(),
            limit: LIMIT,
        });
    }
    let mut ends = take(&mut memory.ends);
    memory
        .edges
        .set(&vertices, points.len(), edges, &mut ends)?;
    memory.initialized();
    let chains = ChainNotes::new(Arc::new(ends));
    let sweep = begin(points, vertices, chains, settings, search, probe, memory);
    Ok(sweep)
}

/// The state with the first triangle of these vertices; `memory` lists their edges.
pub(super) fn begin<'a, S: Scalar, P: Probe>(
    points: &'a [[S; 2]],
    vertices: Vertices,
    chains: ChainNotes,
    settings: Settings<'_>,
    mut search: Search<'a>,
    probe: P,
    memory: &mut Memory,
) -> Sweep<'a, S, P> {
    search.begin(Domain::new(&vertices.approx));
    // There is an open side for each vertex, the segment of the front that starts there.
    let n = vertices.len();
    memory.mesh.begin(2 * n + 2, n + 2);
    let signs = SweepPredicates::new(points, vertices);
    let has_budget = settings.algorithm == Algorithm::Auto;
    let fabric = Fabric::new(signs, has_budget, probe, memory);
    let front = memory.take_front(n);
    let mut sweep = Sweep::new(fabric, front, chains, settings.heuristics, search, memory);
    sweep.report_order(n);
    if n > 0 {
        sweep.first_triangle();
    }
    sweep
}

/// How many points and how many edges can be numbered: there are twice as many triangles as points, and a few
/// artificial ones.
pub(super) const LIMIT: usize = Side::LIMIT / 2 - 4;

impl<S: Scalar, P: Probe> Sweep<'_, S, P> {
    /// Reports the sweep order to the observer.
    fn report_order(&mut self, vertices: usize) {
        if self.fabric.is_observed() {
            for v in (0..vertices).map(VertexId::at) {
                self.fabric.report(|name| Event::Sorted { vertex: name(v) });
            }
        }
    }

    /// The triangle of the first vertex and the artificial points (figure 6).
    pub(super) fn first_triangle(&mut self) {
        let first = VertexId::new(0);
        let artificial = self.fabric.signs.artificial;
        let (left, right) = (artificial.left, artificial.right);
        let across = [
            Side::NOTHING,
            Side::open(OpenId::segment(first)),
            Side::open(OpenId::segment(left)),
        ];
        self.fabric.make([first, left, right], across, Why::First);
        self.put_on_front(self.new_vertex(first), left);
    }
}

//! Initialization (section 3.3): the vertices in sweep order ([`super::vertices`]), the edges at their upper ends
//! ([`super::edges`]), the artificial points ([`super::artificial`]) and the first triangle; these files name
//! differences from the paper. Cost: that of the sort, and O(n) for n points and edges.

use alloc::sync::Arc;
use core::mem::take;

use super::Sweep;
use super::state::Scratch;
use super::vertices::{ApproxPoints, SortBuffers};
use crate::error::Error;
use crate::front::{Front, FrontInput, FrontSearch, Search};
use crate::ids::{BorderId, VertexId, narrow};
use crate::memory::{expect_room, of_triangulation};
use crate::mesh::HalfEdge;
use crate::observe::probe::Probe;
use crate::scalar::{ExactPoints, Scalar};
use crate::settings::Settings;
use crate::trace::{Event, Why};
use crate::triangulation::edge_chains::EdgeChainBuilder;
use crate::tuning::Tuning;

/// Sorts and merges the points, and lists the edges at their upper ends, all in `scratch`.
pub(super) fn initialize<S: Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    tuning: &Tuning,
    scratch: &mut Scratch,
) -> Result<(), Error> {
    // Too many vertices or edges, or wrong ones, are refused.
    if points.len() > LIMIT {
        return Err(Error::TooManyPoints {
            given: points.len(),
            limit: LIMIT,
        });
    }
    if edges.len() > LIMIT {
        return Err(Error::TooManyEdges {
            given: edges.len(),
            limit: LIMIT,
        });
    }
    // What earlier runs have left is there.
    if scratch.arrays.vertices.approx.capacity() < points.len() {
        expect_room(of_triangulation(points.len(), edges.len()))?;
    }
    let approx = ApproxPoints::new(points)?;
    let inputs = 0..narrow(points.len());
    let vertices = &mut scratch.arrays.vertices;
    vertices.set(&approx, inputs, &mut scratch.sort, tuning);
    drop(approx);
    scratch
        .lists
        .edges
        .set(vertices, points.len(), edges, &mut scratch.ends)?;
    scratch.arrays.chains = EdgeChainBuilder::new(Arc::new(take(&mut scratch.ends)));
    if !scratch.is_kept {
        scratch.sort = SortBuffers::default();
    }
    Ok(())
}

/// The state with the first triangle of the vertices in `scratch`, with the edges there.
pub(super) fn begin<'a, P: Probe>(
    points: &'a dyn ExactPoints,
    settings: Settings,
    front: Option<&'a mut dyn FrontSearch>,
    probe: P,
    scratch: &'a mut Scratch,
) -> Sweep<'a, P> {
    let arrays = &mut scratch.arrays;
    arrays.table.tune(settings.tuning);
    let mut search = Search::with(front, take(&mut arrays.table));
    search.begin(FrontInput::new(&arrays.vertices.approx));
    // Each vertex has a border half-edge: the segment of the front that starts there.
    let n = arrays.vertices.len();
    arrays.mesh.begin(2 * n + 2, n + 2);
    match &mut arrays.front {
        Some(front) => front.begin(n),
        None => arrays.front = Some(Front::new(n)),
    }
    let mut sweep = Sweep::new(points, settings, search, probe, scratch);
    sweep.report_order(n);
    if n > 0 {
        sweep.first_triangle();
    }
    sweep
}

/// How many points, and how many edges, can be numbered: the triangles are twice as many as the points, and a few more.
pub(super) const LIMIT: usize = HalfEdge::LIMIT / 2 - 4;

impl<P: Probe> Sweep<'_, P> {
    fn report_order(&mut self, vertices: usize) {
        if self.delaunay.is_observed() {
            for v in (0..vertices).map(VertexId::at) {
                self.delaunay
                    .report(|name| Event::Sorted { vertex: name(v) });
            }
        }
    }

    /// Makes the triangle of the first vertex and the artificial points (figure 6).
    pub(super) fn first_triangle(&mut self) {
        let first = VertexId::new(0);
        let artificial = self.delaunay.predicates.artificial;
        let (left, right) = (artificial.left, artificial.right);
        let twin = [
            HalfEdge::NOTHING,
            HalfEdge::border(BorderId::segment(first)),
            HalfEdge::border(BorderId::segment(left)),
        ];
        self.delaunay
            .add_triangle([first, left, right], twin, Why::First);
        self.put_on_front(self.new_vertex(first), left);
    }
}

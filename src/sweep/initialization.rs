//! Initialization (section 3.3): the vertices in sweep order, the edges at their upper ends, the
//! artificial points and the first triangle.
//!
//! Cost: that of the sort ([`super::order`]), and O(n) for n points and edges.
//!
//! Differs from the paper: see [`super::vertices`], [`super::edges`] and [`super::artificial`].

use super::edges::{Edges, Rests};
use super::fabric::Fabric;
use super::incidence::Incidence;
use super::obstacles::Obstacles;
use super::settings::Settings;
use super::signs::Signs;
use super::state::Sweep;
use super::vertices::Vertices;
use crate::algorithm::Algorithm;
use crate::chains::ChainNotes;
use crate::error::Error;
use crate::front::{Domain, Front, FrontSearch};
use crate::ids::{OpenId, VertexId};
use crate::mesh::Side;
use crate::probe::Probe;
use crate::scalar::Scalar;
use crate::stats::Phase;
use crate::trace::{Event, Why};

/// Sorts and merges the points, lists the edges and makes the first triangle.
pub(super) fn initialize<'a, S: Scalar, F: FrontSearch, P: Probe>(
    points: &'a [[S; 2]],
    edges: &[[usize; 2]],
    settings: Settings<'_>,
    mut search: F,
    mut probe: P,
) -> Result<Sweep<'a, S, F, P>, Error> {
    probe.begin(Phase::Initialization);
    // Vertices and edges; too many or wrong ones are refused.
    check_count(points.len(), |given, limit| Error::TooManyPoints {
        given,
        limit,
    })?;
    let vertices = Vertices::new(points)?;
    check_count(edges.len(), |given, limit| Error::TooManyEdges {
        given,
        limit,
    })?;
    let (edges, ends) = Edges::new(&vertices, points.len(), edges)?;
    search.begin(Domain::new(&vertices.approx));

    // The state without triangles, and then the first one.
    let n = vertices.len();
    let mut sweep = Sweep {
        fabric: Fabric::new(
            Signs::new(points, vertices),
            settings.algorithm == Algorithm::Auto,
            probe,
        ),
        front: Front::new(n),
        search,
        heuristics: settings.heuristics,
        edges,
        chains: ChainNotes::new(ends),
        rests: Rests::new(),
        incidence: Incidence::default(),
        list: Vec::new(),
        obstacles: Obstacles::default(),
        chain: Vec::new(),
    };
    sweep.report_order(n);
    if n > 0 {
        sweep.first_triangle();
    }
    Ok(sweep)
}

/// Refuses more points or edges than can be numbered.
fn check_count(given: usize, too_many: impl Fn(usize, usize) -> Error) -> Result<(), Error> {
    // There are twice as many triangles as points, and a few artificial ones.
    let limit = Side::LIMIT / 2 - 4;
    if given > limit {
        Err(too_many(given, limit))
    } else {
        Ok(())
    }
}

impl<S: Scalar, F: FrontSearch, P: Probe> Sweep<'_, S, F, P> {
    /// Reports the sweep order to the observer.
    fn report_order(&mut self, vertices: usize) {
        if P::EVENTS {
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
        self.put_on_front(first, left);
    }
}

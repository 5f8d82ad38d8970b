//! One band: swept as if it were all there is, and then enclosed in ghosts. Cost: that of the sweep.

use alloc::sync::Arc;
use alloc::vec::Vec;

use super::super::divide_and_conquer::SubTriangulation;
use super::super::initialization::begin;
use super::super::state::{Arrays, Scratch};
use super::super::vertices::Vertices;
use super::partition::Edge;
use crate::error::Error;
use crate::front::FrontSearch;
use crate::ids::VertexId;
use crate::mesh::Mesh;
use crate::observe::probe::{Observer, Probe};
use crate::observe::recorder::Recorder;
use crate::scalar::ExactPoints;
use crate::settings::Settings;
use crate::triangulation::edge_chains::EdgeChainBuilder;

/// A band before the sweep.
pub(super) struct Band<'f> {
    pub(super) vertices: Vertices,
    /// Lists of the edges within the band.
    pub(super) edges: Vec<Vec<Edge>>,
    /// The rank of the band's first vertex in the whole.
    pub(super) first: usize,
    /// The search structure, if the caller gives one.
    pub(super) front: Option<&'f mut (dyn FrontSearch + Send)>,
}

/// A band after the sweep. Vertices and triangles are numbered within the band.
#[derive(Debug)]
pub(super) struct Swept {
    pub(super) vertices: Vertices,
    pub(super) mesh: Mesh,
    pub(super) part: SubTriangulation,
    pub(super) chains: EdgeChainBuilder,
    pub(super) counts: Option<Recorder>,
}

/// The input: what all bands share.
pub(super) struct Shared<'a> {
    pub(super) points: &'a (dyn ExactPoints + Sync),
    /// The ends of each edge as input indices, upper end first.
    pub(super) inputs: Arc<Vec<[u32; 2]>>,
    /// The number of all vertices, which is also the number of the ghosts' common vertex.
    pub(super) outside: VertexId,
    pub(super) settings: Settings,
    /// Whether the work is counted.
    pub(super) counts: bool,
}

impl Shared<'_> {
    /// Triangulates a band of at least two vertices with the edges within it.
    pub(super) fn sweep(&self, band: Band<'_>) -> Result<Swept, Error> {
        if !self.counts {
            return Ok(self.sweep_with(band, ())?.0);
        }
        let (swept, observer) = self.sweep_with(band, Observer::default())?;
        Ok(Swept {
            counts: Some(observer.recorder),
            ..swept
        })
    }

    fn sweep_with<P: Probe>(&self, band: Band<'_>, probe: P) -> Result<(Swept, P), Error> {
        let Band {
            vertices,
            edges,
            first,
            front,
        } = band;
        let n = vertices.len();
        let arrays = Arrays {
            vertices,
            chains: EdgeChainBuilder::new(Arc::clone(&self.inputs)),
            ..Arrays::default()
        };
        let mut scratch = Scratch {
            arrays,
            ..Scratch::default()
        };
        if first == 0 {
            // Room for the triangles of the other bands, too.
            scratch.arrays.mesh.reserve(2 * self.outside.index());
        }
        scratch.lists.edges.list(n, edges.iter().flatten().copied());
        drop(edges);
        let (points, settings) = (self.points, self.settings);
        let front = front.map(|front| front as _);
        let mut sweep = begin(points, settings, front, probe, &mut scratch);
        sweep.triangulate(settings, None)?;
        let bytes = sweep.heap_bytes();
        sweep.delaunay.probe.record(|r| r.stats.memory = bytes);
        let part = sweep.enclose(n, VertexId::at(self.outside.index() - first));
        let (mut arrays, probe) = sweep.give_back();
        arrays.vertices.approx.truncate(n);
        let swept = Swept {
            vertices: arrays.vertices,
            mesh: arrays.mesh,
            part,
            chains: arrays.chains,
            counts: None,
        };
        Ok((swept, probe))
    }
}

//! One band: swept as if it were all there is, and then enclosed in ghosts. Cost: that of the sweep.

use alloc::boxed::Box;
use alloc::sync::Arc;
use alloc::vec::Vec;
use core::mem::take;

use super::super::divide_and_conquer::SubTriangulation;
use super::super::initialization::begin;
use super::super::scratch::{Held, Lent};
use super::super::vertices::Vertices;
use super::BandProbe;
use super::partition::Edge;
use crate::error::Error;
use crate::front::{FrontSearch, Search};
use crate::ids::VertexId;
use crate::mesh::Mesh;
use crate::scalar::ExactPoints;
use crate::settings::Settings;
use crate::triangulation::edge_chains::EdgeChainBuilder;

/// The search structure of a band.
pub(crate) type Structure<'f> = Box<dyn FrontSearch + Send + 'f>;

/// A band before the sweep.
pub(super) struct Band<'f> {
    pub(super) vertices: Vertices,
    /// Lists of the edges within the band.
    pub(super) edges: Vec<Vec<Edge>>,
    /// The rank of the band's first vertex in the whole.
    pub(super) first: usize,
    pub(super) search: Structure<'f>,
}

/// A band after the sweep. Vertices and triangles are numbered within the band.
#[derive(Debug)]
pub(super) struct Swept<C> {
    pub(super) vertices: Vertices,
    pub(super) mesh: Mesh,
    pub(super) part: SubTriangulation,
    pub(super) chains: EdgeChainBuilder,
    pub(super) counts: C,
}

/// The input: what all bands share.
pub(super) struct Shared<'a> {
    pub(super) points: &'a (dyn ExactPoints + Sync),
    /// The ends of each edge as input indices, upper end first.
    pub(super) inputs: Arc<Vec<[u32; 2]>>,
    /// The number of all vertices, which is also the number of the ghosts' common vertex.
    pub(super) outside: VertexId,
}

impl Shared<'_> {
    /// Triangulates a band of at least two vertices with the edges within it.
    pub(super) fn sweep<P: BandProbe>(
        &self,
        Band {
            vertices,
            edges,
            first,
            mut search,
        }: Band<'_>,
        settings: Settings<'_>,
    ) -> Result<Swept<P::Counts>, Error> {
        let n = vertices.len();
        let mut held = Held {
            vertices,
            ..Held::default()
        };
        if first == 0 {
            // Room for the triangles of the other bands, too.
            held.mesh.reserve(2 * self.outside.index());
        }
        let mut lent = Lent::default();
        lent.edges.list(n, edges.iter().flatten().copied());
        drop(edges);
        let chains = EdgeChainBuilder::new(Arc::clone(&self.inputs));
        let (search, probe) = (Search::with(&mut *search), P::default());
        let mut sweep = begin(
            self.points,
            chains,
            settings,
            search,
            probe,
            held,
            &mut lent,
        );
        sweep.triangulate(settings)?;
        let bytes = sweep.heap_bytes();
        sweep.delaunay.probe.record(|r| r.stats.memory = bytes);
        let part = sweep.enclose(n, VertexId::at(self.outside.index() - first));
        let chains = take(&mut sweep.chains);
        let (mut held, probe) = sweep.give_back();
        held.vertices.approx.truncate(n);
        Ok(Swept {
            vertices: held.vertices,
            mesh: held.mesh,
            part,
            chains,
            counts: probe.counts(),
        })
    }
}

//! One band: swept as if it were all there is, and then enclosed in ghosts.
//!
//! Cost: that of the sweep.

use std::sync::Arc;

use super::super::divide_and_conquer::Part;
use super::super::initialization::begin;
use super::super::memory::Memory;
use super::super::vertices::Vertices;
use super::strata::Edge;
use crate::chains::ChainNotes;
use crate::error::Error;
use crate::front::{FrontSearch, Search};
use crate::ids::VertexId;
use crate::mesh::Mesh;
use crate::scalar::Scalar;
use crate::settings::Settings;

/// A search structure of a band.
pub(crate) type Structure<'f> = Box<dyn FrontSearch + Send + 'f>;

/// A band before the sweep.
pub(super) struct Band<'f> {
    pub(super) vertices: Vertices,
    /// Lists of the edges within it.
    pub(super) edges: Vec<Vec<Edge>>,
    /// The number of its first vertex in the whole.
    pub(super) first: usize,
    pub(super) search: Structure<'f>,
}

/// A band after the sweep. Vertices and triangles are numbered within the band.
#[derive(Debug)]
pub(super) struct Swept {
    pub(super) vertices: Vertices,
    pub(super) mesh: Mesh,
    pub(super) part: Part,
    pub(super) chains: ChainNotes,
}

/// The input: what all bands share.
#[derive(Debug)]
pub(super) struct Shared<'a, S> {
    pub(super) points: &'a [[S; 2]],
    /// The ends of each edge as input indices, upper end first.
    pub(super) inputs: Arc<Vec<[u32; 2]>>,
    /// The number of all vertices, which stands for that of the ghosts.
    pub(super) outside: VertexId,
}

impl<S: Scalar> Shared<'_, S> {
    /// Triangulates a band of at least two vertices with the edges within it.
    pub(super) fn sweep(
        &self,
        Band {
            vertices,
            edges,
            first,
            mut search,
        }: Band<'_>,
        settings: Settings<'_>,
    ) -> Result<Swept, Error> {
        let n = vertices.len();
        let mut memory = Memory::default();
        if first == 0 {
            // The triangles of the others will follow.
            memory.mesh.reserve(2 * self.outside.index());
        }
        memory.edges.list(n, edges.iter().flatten().copied());
        drop(edges);
        let chains = ChainNotes::new(Arc::clone(&self.inputs));
        let mut sweep = begin(
            self.points,
            vertices,
            chains,
            settings,
            Search::with(&mut *search),
            (),
            &mut memory,
        );
        sweep.triangulate(settings)?;
        let part = sweep.enclose(n, VertexId::at(self.outside.index() - first));
        let mut vertices = sweep.fabric.signs.vertices;
        vertices.approx.truncate(n);
        Ok(Swept {
            vertices,
            mesh: sweep.fabric.mesh,
            part,
            chains: sweep.chains,
        })
    }
}

//! One band: swept as if it were all there is, and then enclosed in ghosts.
//!
//! Cost: that of the sweep.

use std::ops::Range;
use std::sync::Arc;

use super::super::divide_and_conquer::Part;
use super::super::initialization::begin;
use super::super::memory::Memory;
use super::super::vertices::Vertices;
use crate::chains::ChainNotes;
use crate::error::Error;
use crate::front::{Front, FrontSearch};
use crate::ids::{VertexId, narrow};
use crate::mesh::Mesh;
use crate::scalar::Scalar;
use crate::settings::Settings;

/// A band before the sweep.
#[derive(Debug)]
pub(super) struct Band<F> {
    pub(super) vertices: Vertices,
    /// The numbers of its vertices in the whole.
    pub(super) place: Range<usize>,
    pub(super) search: F,
}

/// A band after the sweep. Vertices and triangles are numbered within the band.
#[derive(Debug)]
pub(super) struct Swept {
    pub(super) vertices: Vertices,
    pub(super) mesh: Mesh,
    pub(super) part: Part,
    pub(super) chains: ChainNotes,
    /// The memory of the front, of the lowest band only.
    pub(super) front: Option<Front>,
}

/// The input: what all bands share.
#[derive(Debug)]
pub(super) struct Shared<'a, S> {
    pub(super) points: &'a [[S; 2]],
    /// The ends of each edge, upper end first, numbered in the whole.
    pub(super) ends: Vec<[VertexId; 2]>,
    /// The same as input indices.
    pub(super) inputs: Arc<Vec<[u32; 2]>>,
    /// The number of all vertices, which stands for that of the ghosts.
    pub(super) outside: VertexId,
}

impl<S: Scalar> Shared<'_, S> {
    /// Triangulates a band of at least two vertices with the edges within it.
    pub(super) fn sweep<F: FrontSearch>(
        &self,
        Band {
            vertices,
            place,
            search,
        }: Band<F>,
        settings: Settings<'_>,
    ) -> Result<Swept, Error> {
        let mut memory = Memory::default();
        memory
            .edges
            .list(vertices.len(), self.within(place.clone()));
        let chains = ChainNotes::new(Arc::clone(&self.inputs));
        let mut sweep = begin(
            self.points,
            vertices,
            chains,
            settings,
            search,
            (),
            &mut memory,
        );
        sweep.triangulate(settings)?;
        let part = sweep.enclose(
            place.len(),
            VertexId::at(self.outside.index() - place.start),
        );
        let mut vertices = sweep.fabric.signs.vertices;
        vertices.approx.truncate(place.len());
        Ok(Swept {
            vertices,
            mesh: sweep.fabric.mesh,
            part,
            chains: sweep.chains,
            front: (place.start == 0).then_some(sweep.front),
        })
    }

    /// The edges within a band: input index, and both ends as the band numbers them.
    fn within(
        &self,
        place: Range<usize>,
    ) -> impl DoubleEndedIterator<Item = (u32, [VertexId; 2])> + Clone {
        let numbered = self.ends.iter().enumerate();
        numbered.filter_map(move |(edge, &[upper, lower])| {
            let is_within = place.start <= lower.index() && upper.index() < place.end;
            let number = |v: VertexId| VertexId::at(v.index() - place.start);
            is_within.then(|| (narrow(edge), [upper, lower].map(number)))
        })
    }
}

//! Scratch: the memory that one run leaves for the next.
//!
//! A run takes its buffers from a [`Scratch`]. If that is kept, the run puts them back at its end with whatever they
//! hold: the next run clears what it takes, and if the sizes suffice, it neither asks the system for pages nor frees
//! any. Otherwise the scratch is empty at the start, costs nothing, and buffers that only the initialization needs are
//! freed at its end.

use super::delaunay::{ChainVertex, Polygons, Run};
use super::edges::Edges;
use super::pending_edges::VertexTriangles;
use super::traversal::Traversed;
use super::vertices::{SortBuffers, Vertices};
use crate::front::Front;
use crate::ids::{TriangleId, VertexId};
use crate::mesh::{HalfEdge, Mesh};
use crate::triangulation::Triangulation;
use alloc::vec::Vec;

/// Buffers for the next run.
#[derive(Debug, Default)]
pub(crate) struct Scratch {
    pub(super) is_kept: bool,
    pub(super) sort: SortBuffers,
    pub(super) vertices: Vertices,
    /// The edges: their list, and their ends as input indices.
    pub(super) edges: Edges,
    pub(super) ends: Vec<[u32; 2]>,
    /// The state between two events, and its buffers.
    pub(super) mesh: Mesh,
    pub(super) front: Option<Front>,
    pub(super) flip_stack: Vec<HalfEdge>,
    pub(super) run: Run,
    pub(super) polygons: Polygons,
    pub(super) list: Vec<(VertexId, u32)>,
    pub(super) traversed: Traversed,
    pub(super) chain: Vec<ChainVertex>,
    pub(super) vertex_triangles: VertexTriangles,
    /// Finalization: the hull as input indices, and the artificial triangles.
    pub(super) hull: Vec<u32>,
    pub(super) artificial: Vec<TriangleId>,
}

impl Scratch {
    /// A scratch for many runs, without buffers yet.
    pub(crate) fn kept() -> Scratch {
        Scratch {
            is_kept: true,
            ..Scratch::default()
        }
    }

    /// Frees the buffers that only the initialization needs, unless they are kept.
    pub(super) fn initialized(&mut self) {
        if !self.is_kept {
            self.sort = SortBuffers::default();
        }
    }

    /// An empty front for `vertices` vertices.
    pub(super) fn take_front(&mut self, vertices: usize) -> Front {
        match self.front.take() {
            Some(mut front) => {
                front.begin(vertices);
                front
            }
            None => Front::new(vertices),
        }
    }

    /// Takes back the buffers of a result that nobody needs any more.
    pub(crate) fn recycle(&mut self, result: Triangulation) {
        self.mesh.reuse(result.triangles);
        self.hull = result.hull;
        self.vertices.input = result.vertices;
        self.vertices.duplicates = result.duplicates;
        self.ends = result.chains.into_ends();
    }
}

//! The memory that one run leaves for the next.
//!
//! A run takes its arrays from a [`Scratch`]. If that is kept, the run puts them back at its end, with whatever
//! they hold: the next run clears what it takes. Otherwise the memory is empty at the start, and what only the
//! initialization works with is freed at its end.
//!
//! Cost: nothing for a single run. A run that finds memory of its size neither asks the system for pages nor
//! frees any.
//!
//! Differs from the paper: it does not speak of memory.

use super::delaunay::{ChainVertex, ConvexRun, Polygons};
use super::edges::Edges;
use super::pending_edges::VertexTriangles;
use super::traversal::Traversed;
use super::vertices::{SortBuffers, Vertices};
use crate::front::Front;
use crate::ids::{TriangleId, VertexId};
use crate::mesh::{HalfEdge, Mesh};
use crate::triangulation::Triangulation;
use alloc::vec::Vec;

/// Arrays for the next run.
#[derive(Debug, Default)]
pub(crate) struct Scratch {
    pub(super) is_kept: bool,
    /// Working memory of the sort.
    pub(super) sort: SortBuffers,
    /// The vertices.
    pub(super) vertices: Vertices,
    /// The edges: their list, and their ends as input indices.
    pub(super) edges: Edges,
    pub(super) ends: Vec<[u32; 2]>,
    /// The state between two events, and its working memory.
    pub(super) mesh: Mesh,
    pub(super) front: Option<Front>,
    pub(super) flip_stack: Vec<HalfEdge>,
    pub(super) convex_run: ConvexRun,
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
    /// Memory for many runs, none of it taken yet.
    pub(crate) fn kept() -> Scratch {
        Scratch {
            is_kept: true,
            ..Scratch::default()
        }
    }

    /// The initialization is over.
    pub(super) fn initialized(&mut self) {
        if !self.is_kept {
            self.sort = SortBuffers::default();
        }
    }

    /// The front of so many vertices before the first of them.
    pub(super) fn take_front(&mut self, vertices: usize) -> Front {
        match self.front.take() {
            Some(mut front) => {
                front.begin(vertices);
                front
            }
            None => Front::new(vertices),
        }
    }

    /// Takes back a result that nobody needs any more.
    pub(crate) fn recycle(&mut self, result: Triangulation) {
        self.mesh.reuse(result.triangles);
        self.hull = result.hull;
        self.vertices.input = result.vertices;
        self.vertices.duplicates = result.duplicates;
        self.ends = result.chains.into_ends();
    }
}

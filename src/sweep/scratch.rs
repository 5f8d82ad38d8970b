//! Scratch: the memory that one run leaves for the next.
//!
//! A run clears what it uses of a [`Scratch`], and leaves it there with whatever it holds, also where it ends in an
//! error. If the sizes suffice, the next run neither asks the system for pages nor frees any. The arrays of a result
//! leave the scratch, and come back if the result does ([`Scratch::recycle`]). For a single run the scratch is empty at
//! the start and costs nothing; what only the initialization needs is then freed at its end.

use super::delaunay::{self, ChainVertex};
use super::edges::Edges;
use super::pending_edges::VertexTriangles;
use super::traversal::Traversed;
use super::vertices::{SortBuffers, Vertices};
use crate::front::{Front, HashTable};
use crate::ids::{TriangleId, VertexId};
use crate::mesh::Mesh;
use crate::triangulation::Triangulation;
use alloc::vec::Vec;

/// The memory of a run.
#[derive(Debug, Default)]
pub(crate) struct Scratch {
    pub(super) is_kept: bool,
    pub(super) sort: SortBuffers,
    /// The ends of the edges as input indices.
    pub(super) ends: Vec<[u32; 2]>,
    pub(super) held: Held,
    pub(super) lent: Lent,
}

/// Arrays that the state holds until it ends. Nearly every step reads them, and behind references they would cost 1 to 3 %
/// more instructions.
#[derive(Debug, Default)]
pub(super) struct Held {
    pub(super) vertices: Vertices,
    pub(super) mesh: Mesh,
    /// None before the first run.
    pub(super) front: Option<Front>,
    /// The default search structure of the front.
    pub(super) table: HashTable,
    pub(super) traversed: Traversed,
}

/// Arrays and buffers that the state borrows.
#[derive(Debug, Default)]
pub(super) struct Lent {
    pub(super) edges: Edges,
    pub(super) delaunay: delaunay::Buffers,
    /// Lower ends and input indices of the edges being inserted.
    pub(super) list: Vec<(VertexId, u32)>,
    /// The nodes of the front being filled.
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

    /// Takes back the buffers of a result that nobody needs any more.
    pub(crate) fn recycle(&mut self, result: Triangulation) {
        self.held.mesh.reuse(result.triangles);
        self.lent.hull = result.hull;
        self.held.vertices.input = result.vertices;
        self.held.vertices.duplicates = result.duplicates;
        self.ends = result.chains.into_ends();
    }
}

#[cfg(test)]
mod tests {
    use crate::settings::Settings;
    use crate::sweep::{Scratch, run};
    use crate::watch::Watch;

    /// Of each array that grows with the input, how much it holds without asking for more.
    fn room(scratch: &Scratch) -> [usize; 6] {
        let (held, lent) = (&scratch.held, &scratch.lent);
        [
            scratch.ends.capacity(),
            held.vertices.heap_bytes(),
            held.mesh.heap_bytes(),
            held.front.as_ref().map_or(0, |front| front.heap_bytes()),
            lent.edges.heap_bytes(),
            lent.artificial.capacity(),
        ]
    }

    #[test]
    fn an_error_leaves_memory_and_nothing_else() {
        let settings = Settings::default();
        let square = [[0, 0], [4, 0], [4, 4], [0, 4]];
        let right = [[0, 2], [1, 2]];
        let mut scratch = Scratch::kept();
        let mut runs = |edges: [[usize; 2]; 2]| {
            let run = run(&square, &edges, settings, Watch::new(), &mut scratch);
            let result = run.map(|result| result.canonical_triangles());
            (result, room(&scratch))
        };
        runs(right).0.expect("edges that do not cross");
        let (crossing, out_of_range) = ([[0, 2], [1, 3]], [[0, 2], [1, 4]]);
        for wrong in [crossing, out_of_range] {
            let (error, room) = runs(wrong);
            error.expect_err("wrong edges");
            assert!(room.iter().all(|&room| room > 0), "{room:?}");
            let result = runs(right).0;
            let triangles = result.expect("edges that do not cross");
            assert_eq!(triangles, [[0, 1, 2], [0, 2, 3]]);
        }
    }
}

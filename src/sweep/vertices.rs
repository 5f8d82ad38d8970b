//! The vertices (section 3.3): the distinct points in sweep order.
//!
//! Every distinct point gets its *rank* in that order. All that follows works on ranks, so that points
//! swept one after the other are near each other in memory.
//!
//! Cost: that of the sort ([`super::order`]), and O(n) for n points.
//!
//! Differs from the paper: as the sort does.

use super::located::{Located, doubles};
use super::order::{self, Order, Workspace};
use crate::ids::VertexId;
use crate::scalar::{Scalar, Scale};

/// The distinct points in sweep order.
#[derive(Debug)]
pub(super) struct Vertices {
    /// By rank: doubles for the coordinates, on one [`Scale`]; infinite for what is far outside.
    pub(super) approx: Vec<[f64; 2]>,
    /// By rank: the input index that stands for the vertex.
    pub(super) input: Vec<u32>,
    /// `(point, representative)` of each duplicate, by point.
    pub(super) duplicates: Vec<(u32, u32)>,
    pub(super) scale: Scale,
}

impl Vertices {
    /// Sorts and merges the points with these input indices, which ascend; their number was checked. The memory
    /// of `order` and `workspace` is used again.
    pub(super) fn new<S: Scalar>(
        located: &Located<'_, S>,
        inputs: impl ExactSizeIterator<Item = u32> + Clone,
        order: Order,
        workspace: &mut Workspace,
    ) -> Vertices {
        let (points, scale) = (located.points, located.scale);
        // One of two, so that the sort need not ask for each point where its doubles are.
        let Order {
            approx,
            input,
            duplicates,
        } = match located.stored() {
            [] => order::sort(
                points,
                inputs,
                |i| doubles(&points[i as usize]),
                scale,
                order,
                workspace,
            ),
            stored => order::sort(
                points,
                inputs,
                |i| stored[i as usize],
                scale,
                order,
                workspace,
            ),
        };
        Vertices {
            approx,
            input,
            duplicates,
            scale: located.scale,
        }
    }

    /// Adds vertices that come after all of these in sweep order.
    #[cfg(feature = "parallel")]
    pub(super) fn append(&mut self, mut others: Vertices) {
        self.approx.append(&mut others.approx);
        self.input.append(&mut others.input);
        self.duplicates.append(&mut others.duplicates);
        self.duplicates.sort_unstable();
    }

    /// How many there are, without the artificial ones.
    pub(super) fn len(&self) -> usize {
        self.input.len()
    }

    /// The input index that stands for vertex `v`.
    pub(super) fn input_index(&self, v: VertexId) -> u32 {
        self.input[v.index()]
    }

    /// Sets `ranks` to the ranks of the vertices of so many input points.
    pub(super) fn rank(&self, points: usize, ranks: &mut Vec<u32>) {
        ranks.clear();
        ranks.resize(points, 0);
        for (rank, &input) in (0..).zip(&self.input) {
            ranks[input as usize] = rank;
        }
        for &(duplicate, representative) in &self.duplicates {
            ranks[duplicate as usize] = ranks[representative as usize];
        }
    }

    /// Bytes held.
    pub(super) fn heap_bytes(&self) -> usize {
        self.approx.capacity() * size_of::<[f64; 2]>() + self.input.capacity() * size_of::<u32>()
    }
}

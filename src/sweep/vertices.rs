//! The vertices (section 3.3): the distinct points in sweep order.
//!
//! Every distinct point gets its *rank* in that order. All that follows works on ranks, so that points
//! swept one after the other are near each other in memory.
//!
//! Cost: that of the sort ([`super::order`]), and O(n) for n points.
//!
//! Differs from the paper: as the sort does.

use super::order::{self, Order};
use crate::error::Error;
use crate::ids::VertexId;
use crate::scalar::{Scalar, Scale, frame, is_in_range};

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

/// The points with doubles for their coordinates, all on one [`Scale`].
#[derive(Debug)]
pub(super) struct Located<'a, S> {
    pub(super) points: &'a [[S; 2]],
    /// The doubles. Empty if they are what [`Scalar::approx`] gives.
    stored: Vec<[f64; 2]>,
    scale: Scale,
}

impl<'a, S: Scalar> Located<'a, S> {
    /// Finds doubles and scale of the points.
    pub(super) fn new(points: &'a [[S; 2]]) -> Result<Located<'a, S>, Error> {
        let is_finite = |p: &[S; 2]| p[0].is_finite() && p[1].is_finite();
        // What is in range is finite.
        let is_plain = |p: &[S; 2]| is_in_range(approximate(p));
        // Coordinates that are doubles of moderate size are not stored once more.
        let mut stored: Vec<[f64; 2]> = Vec::new();
        let scale = if S::APPROX_IS_EXACT && points.iter().all(is_plain) {
            Scale::exact(points.len(), |i| approximate(&points[i]))
        } else {
            if let Some(vertex) = points.iter().position(|p| !is_finite(p)) {
                return Err(Error::NonFiniteCoordinate { vertex });
            }
            stored.extend(points.iter().map(approximate));
            frame::fit(points, &mut stored)
        };
        Ok(Located {
            points,
            stored,
            scale,
        })
    }

    /// The doubles of a point, by its input index.
    #[inline(always)]
    pub(super) fn near(&self, input: u32) -> [f64; 2] {
        match self.stored.get(input as usize) {
            Some(near) => *near,
            None => approximate(&self.points[input as usize]),
        }
    }
}

fn approximate<S: Scalar>(point: &[S; 2]) -> [f64; 2] {
    [point[0].approx(), point[1].approx()]
}

impl Vertices {
    /// Sorts and merges the points with these input indices, which ascend; their number was checked.
    pub(super) fn new<S: Scalar>(
        located: &Located<'_, S>,
        inputs: impl ExactSizeIterator<Item = u32> + Clone,
    ) -> Vertices {
        let Order {
            approx,
            input,
            duplicates,
        } = order::sort(
            located.points,
            inputs,
            |input| located.near(input),
            located.scale,
        );
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

    /// For each of `points` input points the rank of its vertex.
    pub(super) fn ranks(&self, points: usize) -> Vec<VertexId> {
        let mut ranks = vec![VertexId::default(); points];
        for (rank, &input) in self.input.iter().enumerate() {
            ranks[input as usize] = VertexId::at(rank);
        }
        for &(duplicate, representative) in &self.duplicates {
            ranks[duplicate as usize] = ranks[representative as usize];
        }
        ranks
    }

    /// Bytes held.
    pub(super) fn memory(&self) -> usize {
        self.approx.capacity() * size_of::<[f64; 2]>() + self.input.capacity() * size_of::<u32>()
    }
}

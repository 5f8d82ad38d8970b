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

impl Vertices {
    /// Sorts and merges the points, whose number was checked.
    pub(super) fn new<S: Scalar>(points: &[[S; 2]]) -> Result<Vertices, Error> {
        let is_finite = |p: &[S; 2]| p[0].is_finite() && p[1].is_finite();
        let approximate = |p: &[S; 2]| [p[0].approx(), p[1].approx()];
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
        let near = |input: u32| match stored.get(input as usize) {
            Some(near) => *near,
            None => approximate(&points[input as usize]),
        };
        let Order {
            approx,
            input,
            duplicates,
        } = order::sort(points, near, scale);
        Ok(Vertices {
            approx,
            input,
            duplicates,
            scale,
        })
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

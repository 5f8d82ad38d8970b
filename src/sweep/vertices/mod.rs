//! The vertices (section 3.3): the distinct points in sweep order.
//!
//! Every distinct point gets its *rank* in that order. All that follows works on ranks, so that points swept one after
//! the other are near each other in memory. Cost: a few passes over the points, and the sort ([`sort`]).
//!
//! [`ApproxPoints`] are the points as doubles on one scale: what the sort and the filter see. Doubles of moderate size
//! that are the coordinates are not stored once more. Where the numbers of another scalar are such doubles, up to one
//! factor ([`Scalar::as_doubles`]), the doubles stand for the numbers from then on, exact stages included.

mod counting;
mod sort;

use crate::error::Error;
use crate::ids::VertexId;
use crate::scalar::{Scalar, Scale, is_in_range, recenter};
#[cfg(feature = "parallel")]
use crate::threads::on_all_cores;
use crate::tuning::{TESTED_AT_ONCE, Tuning};
use alloc::vec::Vec;
pub(super) use sort::SortBuffers;

/// The points with doubles for their coordinates, all on one [`Scale`].
#[derive(Debug)]
pub(super) struct ApproxPoints<'a, S> {
    pub(super) points: &'a [[S; 2]],
    /// The doubles. Empty if they are what [`Scalar::approx`] gives.
    stored: Vec<[f64; 2]>,
    pub(super) scale: Scale,
}

impl<'a, S: Scalar> ApproxPoints<'a, S> {
    pub(super) fn new(points: &'a [[S; 2]]) -> Result<ApproxPoints<'a, S>, Error> {
        ApproxPoints::find(points, || are_plain(points))
    }

    /// Finds doubles and scale on all threads of the current pool, where nothing is stored.
    #[cfg(feature = "parallel")]
    pub(super) fn new_parallel(points: &'a [[S; 2]]) -> Result<ApproxPoints<'a, S>, Error>
    where
        S: Sync,
    {
        let chunks = || points.chunks(64 * TESTED_AT_ONCE).collect();
        ApproxPoints::find(points, || {
            let are_plain = on_all_cores(chunks(), are_plain);
            are_plain.into_iter().all(|are_plain| are_plain)
        })
    }

    /// Finds doubles and scale; `are_plain` says whether [`are_plain`] holds for all points.
    fn find(
        points: &'a [[S; 2]],
        are_plain: impl FnOnce() -> bool,
    ) -> Result<ApproxPoints<'a, S>, Error> {
        let is_finite = |p: &[S; 2]| p[0].is_finite() && p[1].is_finite();
        let mut stored: Vec<[f64; 2]> = Vec::new();
        let scale = if S::APPROX_IS_EXACT && are_plain() {
            Scale::exact(points.len(), |i| doubles(&points[i]))
        } else if !S::APPROX_IS_EXACT
            && let Some(found) = S::as_doubles(points)
            && found.iter().all(|&point| is_in_range(point))
        {
            stored = found;
            Scale::exact(points.len(), |i| stored[i])
        } else {
            if let Some(vertex) = points.iter().position(|p| !is_finite(p)) {
                return Err(Error::NonFiniteCoordinate { vertex });
            }
            stored.extend(points.iter().map(doubles));
            recenter(points, &mut stored)
        };
        Ok(ApproxPoints {
            points,
            stored,
            scale,
        })
    }

    /// The doubles of a point, by its input index.
    #[cfg(feature = "parallel")]
    #[inline(always)]
    pub(super) fn approx(&self, input: u32) -> [f64; 2] {
        match self.stored.get(input as usize) {
            Some(approx) => *approx,
            None => doubles(&self.points[input as usize]),
        }
    }
}

/// Whether the doubles of these points need no factor; then they are finite, too.
fn are_plain<S: Scalar>(points: &[[S; 2]]) -> bool {
    // A few points at once, without branches between them.
    points.chunks(TESTED_AT_ONCE).all(|few| {
        let are_plain = few.iter().map(|point| is_in_range(doubles(point)));
        are_plain.fold(true, |all, is_plain| all & is_plain)
    })
}

/// The doubles that are the coordinates of a point.
#[inline(always)]
pub(super) fn doubles<S: Scalar>(point: &[S; 2]) -> [f64; 2] {
    [point[0].approx(), point[1].approx()]
}

/// The distinct points in sweep order.
#[derive(Debug, Default)]
pub(crate) struct Vertices {
    /// By rank: the approximations, doubles on one [`Scale`]; infinite for what is far outside.
    pub(super) approx: Vec<[f64; 2]>,
    /// By rank: the input index that stands for the vertex.
    pub(super) input: Vec<u32>,
    /// `(point, representative)` of each duplicate, by point.
    pub(super) duplicates: Vec<(u32, u32)>,
    pub(super) scale: Scale,
}

impl Vertices {
    /// Becomes the points `inputs`, ascending and of checked number, sorted and merged. Keeps the arrays.
    pub(super) fn set<S: Scalar>(
        &mut self,
        approx: &ApproxPoints<'_, S>,
        inputs: impl ExactSizeIterator<Item = u32> + Clone,
        buffers: &mut SortBuffers,
        tuning: &Tuning,
    ) {
        let points = approx.points;
        self.scale = approx.scale;
        // Two calls, so that the sort need not ask for each point where its doubles are.
        match &approx.stored[..] {
            [] => sort::sort(
                points,
                inputs,
                |i| doubles(&points[i as usize]),
                self,
                buffers,
                tuning,
            ),
            stored => sort::sort(
                points,
                inputs,
                |i| stored[i as usize],
                self,
                buffers,
                tuning,
            ),
        }
    }

    /// Makes room for `points` points and the two artificial ones.
    #[cfg(feature = "parallel")]
    pub(super) fn reserve(&mut self, points: usize) {
        self.approx.reserve_exact(points + 2);
        self.input.reserve_exact(points);
    }

    /// Appends vertices that come after all of these in sweep order.
    #[cfg(feature = "parallel")]
    pub(super) fn append(&mut self, mut others: Vertices) {
        self.approx.append(&mut others.approx);
        self.input.append(&mut others.input);
        self.duplicates.append(&mut others.duplicates);
        self.duplicates.sort_unstable();
    }

    /// How many vertices there are, without the artificial ones.
    pub(super) fn len(&self) -> usize {
        self.input.len()
    }

    pub(super) fn input_index(&self, v: VertexId) -> u32 {
        self.input[v.index()]
    }

    /// Sets `ranks` to the rank of each of `points` input points.
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

    pub(super) fn heap_bytes(&self) -> usize {
        self.approx.capacity() * size_of::<[f64; 2]>() + self.input.capacity() * size_of::<u32>()
    }
}

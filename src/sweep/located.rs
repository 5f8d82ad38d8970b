//! The points as doubles, all on one scale: what the sort and the filter see of them.
//!
//! Doubles of moderate size that are the coordinates are not stored once more. Where the numbers of another scalar
//! are such doubles, up to one factor ([`Scalar::as_doubles`]), these stand for them in all that follows, exact
//! stages included.
//!
//! Cost: a few passes over the points.
//!
//! Differs from the paper: its coordinates are doubles.

use crate::error::Error;
use crate::scalar::{Scalar, Scale, is_in_range, recenter};

/// The points with doubles for their coordinates, all on one [`Scale`].
#[derive(Debug)]
pub(super) struct Located<'a, S> {
    pub(super) points: &'a [[S; 2]],
    /// The doubles. Empty if they are what [`Scalar::approx`] gives.
    stored: Vec<[f64; 2]>,
    pub(super) scale: Scale,
}

/// How many points are looked at together.
const FEW: usize = 64;

impl<'a, S: Scalar> Located<'a, S> {
    /// Finds doubles and scale of the points.
    pub(super) fn new(points: &'a [[S; 2]]) -> Result<Located<'a, S>, Error> {
        Located::find(points, || are_plain(points))
    }

    /// The same, on all threads of the current pool where nothing is stored.
    #[cfg(feature = "parallel")]
    pub(super) fn new_parallel(points: &'a [[S; 2]]) -> Result<Located<'a, S>, Error>
    where
        S: Sync,
    {
        use rayon::prelude::*;
        Located::find(points, || points.par_chunks(64 * FEW).all(are_plain))
    }

    /// `are_plain` tells whether all points are.
    fn find(
        points: &'a [[S; 2]],
        are_plain: impl FnOnce() -> bool,
    ) -> Result<Located<'a, S>, Error> {
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
        Ok(Located {
            points,
            stored,
            scale,
        })
    }

    /// The doubles of all points, if they are not what [`doubles`] gives.
    pub(super) fn stored(&self) -> &[[f64; 2]] {
        &self.stored
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
    // All of a few, without branches between them.
    points.chunks(FEW).all(|few| {
        let are_plain = few.iter().map(|point| is_in_range(doubles(point)));
        are_plain.fold(true, |all, is_plain| all & is_plain)
    })
}

/// The doubles of a point whose coordinates they are.
#[inline(always)]
pub(super) fn doubles<S: Scalar>(point: &[S; 2]) -> [f64; 2] {
    [point[0].approx(), point[1].approx()]
}

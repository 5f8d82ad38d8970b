//! The predicates for those who call [`Scalar`] directly with a few points: the [`filter`] at the scale of
//! these points, then the exact stages.
//!
//! The sweep and the verifier have one scale for all their points, and call the filter themselves.

use std::cmp::Ordering;

use super::scale::Scale;
use super::{Scalar, filter};

pub(super) fn orient2d<S: Scalar>(points: [&[S; 2]; 3]) -> Ordering {
    let (doubles, scale) = scaled(points);
    let filtered = filter::orient2d(doubles, scale);
    let filtered = filtered.or_else(|| filter::orient2d_approx(doubles, scale));
    filtered.unwrap_or_else(|| {
        let [a, b, c] = points;
        S::orient2d_exact(a, b, c).0
    })
}

pub(super) fn in_circle<S: Scalar>(points: [&[S; 2]; 4]) -> Ordering {
    let (doubles, scale) = scaled(points);
    let filtered = filter::in_circle(doubles, scale);
    let filtered = filtered.or_else(|| filter::in_circle_approx(doubles, scale));
    filtered.unwrap_or_else(|| {
        let [a, b, c, d] = points;
        S::in_circle_exact(a, b, c, d).0
    })
}

fn scaled<S: Scalar, const N: usize>(points: [&[S; 2]; N]) -> ([[f64; 2]; N], Scale) {
    let mut near = points.map(|[x, y]| [x.approx(), y.approx()]);
    let scale = Scale::unify(&mut near, S::APPROX_IS_EXACT);
    (near, scale)
}

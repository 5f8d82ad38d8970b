//! The order of points by x, then y.

use std::cmp::Ordering;

use sweep_cdt::scalar::Scalar;

/// The finite points in order, each with its approximation and its position; of equal ones the first first.
pub(crate) fn sorted<S: Scalar>(points: &[[S; 2]]) -> Vec<([f64; 2], usize)> {
    let finite = points.iter().enumerate().filter(|(_, p)| is_finite(p));
    let mut sorted: Vec<([f64; 2], usize)> = finite
        .map(|(v, point)| (point.each_ref().map(S::approx), v))
        .collect();
    sorted.sort_unstable_by(|(near, v), (other, w)| {
        order((near, &points[*v]), (other, &points[*w])).then(v.cmp(w))
    });
    sorted
}

/// The order of two points, each with its approximation, which decides nearly always.
pub(crate) fn order<S: Scalar>(
    (near, p): (&[f64; 2], &[S; 2]),
    (other, q): (&[f64; 2], &[S; 2]),
) -> Ordering {
    let by = |axis: usize| {
        let near = near[axis].partial_cmp(&other[axis]);
        // Approximations are never NaN.
        let near = near.unwrap_or(Ordering::Equal);
        near.then_with(|| p[axis].compare(&q[axis]))
    };
    by(0).then_with(|| by(1))
}

pub(crate) fn is_finite<S: Scalar>(point: &[S; 2]) -> bool {
    point.iter().all(S::is_finite)
}

//! The same vertices in two lists, by exact coordinates.

use std::cmp::Ordering;

use crate::scalar::Scalar;

/// For each of `points` the lowest position in `among` of an equal point.
///
/// Cost: one sort of `among`, and a binary search for each point.
pub(super) fn places<S: Scalar>(points: &[[S; 2]], among: &[[S; 2]]) -> Vec<Option<usize>> {
    let is_finite = |point: &[S; 2]| point.iter().all(S::is_finite);
    let mut sorted: Vec<usize> = (0..among.len()).filter(|&v| is_finite(&among[v])).collect();
    sorted.sort_by(|&v, &w| order(&among[v], &among[w]));
    let place = |point: &[S; 2]| {
        let at = sorted.partition_point(|&v| order(&among[v], point).is_lt());
        sorted
            .get(at)
            .copied()
            .filter(|&v| order(&among[v], point).is_eq())
    };
    points
        .iter()
        .map(|point| if is_finite(point) { place(point) } else { None })
        .collect()
}

fn order<S: Scalar>(p: &[S; 2], q: &[S; 2]) -> Ordering {
    p[0].compare(&q[0]).then_with(|| p[1].compare(&q[1]))
}

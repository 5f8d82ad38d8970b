//! Where points lie in a triangulation, by exact signs.
//!
//! The points are sorted by x. Each triangle is compared with those between its leftmost and its rightmost corner.
//! A walk from triangle to triangle would look at fewer, but in a triangulation that is constrained it may go
//! round in circles.
//!
//! Cost: O((n + k) log k) for n triangles and k points, and one comparison for each triangle and point that have
//! an x in common: few points, or points that are spread, take little more.

use std::cmp::Ordering;

use crate::Triangulation;
use crate::scalar::Scalar;

/// Where a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// Inside a triangle.
    In(usize),
    /// Inside a side of a triangle.
    OnSide(usize, usize),
    OnVertex(usize),
}

/// The places of points; `None` is outside of the hull.
pub(super) fn locate<S: Scalar>(
    result: &Triangulation,
    points: &[[S; 2]],
    seeds: &[&[S; 2]],
) -> Vec<Option<Place>> {
    let mut order: Vec<usize> = (0..seeds.len()).collect();
    order.sort_by(|&a, &b| seeds[a][0].compare(&seeds[b][0]));
    let mut places = vec![None; seeds.len()];
    for (t, corners) in result.triangles().enumerate() {
        let triangle = corners.map(|v| &points[v]);
        let is_before = |seed: &usize, corner: &[S; 2]| seeds[*seed][0].compare(&corner[0]).is_lt();
        let is_behind = |seed: &usize, corner: &[S; 2]| seeds[*seed][0].compare(&corner[0]).is_gt();
        let from = order.partition_point(|seed| triangle.iter().all(|p| is_before(seed, p)));
        let to = order.partition_point(|seed| !triangle.iter().all(|p| is_behind(seed, p)));
        for &seed in &order[from..to] {
            if places[seed].is_none() {
                places[seed] = place(triangle, seeds[seed]).map(|place| match place {
                    (Some(corner), _) => Place::OnVertex(corners[corner]),
                    (None, Some(side)) => Place::OnSide(t, side),
                    (None, None) => Place::In(t),
                });
            }
        }
    }
    places
}

/// Whether a triangle holds a point, and at which corner or else on which side that is.
fn place<S: Scalar>(
    triangle: [&[S; 2]; 3],
    point: &[S; 2],
) -> Option<(Option<usize>, Option<usize>)> {
    let turn = |i: usize| S::orient2d(triangle[(i + 1) % 3], triangle[(i + 2) % 3], point);
    let turns = [turn(0), turn(1), turn(2)];
    if turns.contains(&Ordering::Less) {
        return None;
    }
    // On two sides it is where they meet, opposite the third one.
    let corner = (0..3).find(|&i| turns[(i + 1) % 3].is_eq() && turns[(i + 2) % 3].is_eq());
    Some((corner, turns.iter().position(|turn| turn.is_eq())))
}

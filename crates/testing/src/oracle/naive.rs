//! Is this a constrained Delaunay triangulation, canonical or not? By definition, as far as that is
//! short: the triangles turn left, are disjoint, fill the hull, have every point for a corner and none
//! within a side; edges are made of sides; sides that are no pieces of edges are Delaunay.
//!
//! Where the verifier of the crate follows the boundary and counts, this compares everything with
//! everything: each two triangles, and the sum of their areas with the hull's.

use std::cmp::Ordering::{Equal, Greater};

use super::numbers::{Number, Point, cross, in_circle, orient, sign, vector};
use crate::with_integers;

/// Whether these triangles, of any points and indices, are a right answer to these points and edges.
pub fn is_right(points: &[[f64; 2]], edges: &[[usize; 2]], triangles: &[[usize; 3]]) -> bool {
    let mut named = edges.iter().flatten().chain(triangles.iter().flatten());
    if !points.iter().flatten().all(|x| x.is_finite()) || named.any(|&v| v >= points.len()) {
        return false;
    }
    with_integers!(points, |exact| is_exactly_right(&exact, edges, triangles))
}

/// Whether triangles are right for points that are given as integers, and indices in range.
pub fn is_exactly_right<N: Number>(
    points: &[Point<N>],
    edges: &[[usize; 2]],
    triangles: &[[usize; 3]],
) -> bool {
    let corners: Vec<Triangle<N>> = triangles.iter().map(|t| t.map(|v| &points[v])).collect();
    let edges: Vec<Side<N>> = edges.iter().map(|e| e.map(|v| &points[v])).collect();
    let mut distinct: Vec<&Point<N>> = points.iter().collect();
    distinct.sort_unstable();
    distinct.dedup();

    corners.iter().all(|&[a, b, c]| orient(a, b, c) == Greater)
        && fill_hull(&distinct, &corners)
        && (corners.is_empty() || {
            let sides: Vec<Side<N>> = corners.iter().copied().flat_map(sides).collect();
            distinct.iter().all(|p| corners.as_flattened().contains(p))
                && sides
                    .iter()
                    .all(|&side| !distinct.iter().any(|v| is_within(side, v)))
                && edges.iter().all(|&edge| is_made(edge, &distinct, &sides))
        })
        && are_delaunay(&corners, &edges)
}

pub(super) type Triangle<'a, N> = [&'a Point<N>; 3];
pub(super) type Side<'a, N> = [&'a Point<N>; 2];

pub(super) fn sides<N>([a, b, c]: Triangle<'_, N>) -> [Side<'_, N>; 3] {
    [[a, b], [b, c], [c, a]]
}

/// Whether `v` lies between the ends.
pub(super) fn is_within<N: Number>([a, b]: Side<'_, N>, v: &Point<N>) -> bool {
    a.min(b) < v && v < a.max(b) && orient(a, b, v) == Equal
}

pub(super) fn is_on<N: Number>(side: Side<'_, N>, v: &Point<N>) -> bool {
    side.contains(&v) || is_within(side, v)
}

/// Whether triangles that turn left have no inner point in common and together the area of the hull.
fn fill_hull<N: Number>(distinct: &[&Point<N>], corners: &[Triangle<'_, N>]) -> bool {
    let mut rest = N::zero();
    for &a in distinct {
        for &b in distinct.iter().filter(|&&b| b != a) {
            let is_beside = |v: &Point<N>| orient(a, b, v) == Greater || is_on([a, b], v);
            if distinct.iter().all(|v| is_beside(v)) {
                rest = rest + cross(a, b);
            }
        }
    }
    for &[a, b, c] in corners {
        rest = rest - cross(&vector(a, b), &vector(a, c));
    }
    let are_disjoint =
        |i: usize, j: usize| separates(corners[i], corners[j]) || separates(corners[j], corners[i]);
    sign(&rest) == Equal && (0..corners.len()).all(|i| (0..i).all(|j| are_disjoint(i, j)))
}

/// Whether a side of the one has the other on its right.
pub(super) fn separates<N: Number>(one: Triangle<'_, N>, other: Triangle<'_, N>) -> bool {
    sides(one)
        .iter()
        .any(|[a, b]| other.iter().all(|v| orient(a, b, v) != Greater))
}

/// Whether each two neighbours among the points on an edge are a side.
pub(super) fn is_made<N: Number>(
    edge: Side<'_, N>,
    distinct: &[&Point<N>],
    sides: &[Side<'_, N>],
) -> bool {
    // On a line the order of the points is that of their coordinates.
    let on: Vec<&Point<N>> = distinct
        .iter()
        .copied()
        .filter(|v| is_on(edge, v))
        .collect();
    on.windows(2)
        .all(|pair| sides.contains(&[pair[0], pair[1]]) || sides.contains(&[pair[1], pair[0]]))
}

/// Whether each side of two triangles is a piece of an edge, or has no circle with the other inside.
pub(super) fn are_delaunay<N: Number>(corners: &[Triangle<'_, N>], edges: &[Side<'_, N>]) -> bool {
    let is_piece = |side: Side<'_, N>| {
        edges
            .iter()
            .any(|&edge| side.iter().all(|end| is_on(edge, end)))
    };
    corners.iter().all(|&t| {
        corners.iter().all(|&u| {
            let [p, q, r] = t;
            let shared = sides(t)
                .into_iter()
                .find(|&[a, b]| sides(u).contains(&[b, a]));
            shared.is_none_or(|side| {
                is_piece(side) || u.iter().all(|v| in_circle(p, q, r, v) != Greater)
            })
        })
    })
}

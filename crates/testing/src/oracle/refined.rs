//! Results with vertices that the input lacks, in the hull or in a part of it, by definition; and how deep faults are, in
//! fractions.
//!
//! There are no numbers of vertices here: triangles are three points each. Everything is compared with everything, as
//! in `naive`. A domain is what a path from outside enters by crossing its chains an odd number of times.

use std::cmp::Ordering::{Equal, Greater};

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::arrangement::Exact;
use super::naive::{Side, Triangle, are_delaunay, is_made, is_on, is_within, separates, sides};
use super::numbers::{Number, Point, cross, in_circle, orient, vector};

/// The domain of which a result must be a triangulation.
pub struct Wanted<'a, N> {
    /// The points of the input.
    pub points: &'a [Point<N>],
    /// The input's edges.
    pub edges: &'a [[usize; 2]],
    /// The closed chains around what the triangles must fill; without any that is the hull.
    pub chains: &'a [Vec<usize>],
}

impl<N: Number> Wanted<'_, N> {
    /// Whether these triangles are right, with whatever vertices they add.
    pub fn is_met_by(&self, triangles: &[[Point<N>; 3]]) -> bool {
        let corners: Vec<Triangle<'_, _>> = triangles.iter().map(|t| t.each_ref()).collect();
        let all: Vec<Side<'_, _>> = corners.iter().copied().flat_map(sides).collect();
        let mut vertices: Vec<&Point<N>> = corners.as_flattened().to_vec();
        vertices.sort_unstable();
        vertices.dedup();
        let outline = self.outline();
        let edges: Vec<Side<'_, _>> = self
            .edges
            .iter()
            .map(|edge| edge.map(|v| &self.points[v]))
            .collect();
        let are_disjoint = |&one: &Triangle<'_, _>, &other: &Triangle<'_, _>| {
            separates(one, other) || separates(other, one)
        };
        let is_filled = || {
            let inside = corners.iter().all(|&t| self.holds(&outline, t));
            let area = |[a, b, c]: Triangle<'_, _>| cross(&vector(a, b), &vector(a, c));
            inside && sum(corners.iter().map(|&t| area(t))) == self.area(&outline)
        };
        let is_needed = |p: &Point<N>| {
            let on = outline.iter().any(|&side| is_on(side, p));
            self.chains.is_empty() || on || is_inside(&outline, p)
        };
        corners.iter().all(|[a, b, c]| orient(a, b, c) == Greater)
            && (0..corners.len()).all(|i| (0..i).all(|j| are_disjoint(&corners[i], &corners[j])))
            && is_filled()
            && (corners.is_empty() && self.chains.is_empty()
                || self
                    .points
                    .iter()
                    .all(|p| !is_needed(p) || vertices.contains(&p)))
            && all
                .iter()
                .all(|&side| !vertices.iter().any(|v| is_within(side, v)))
            && (corners.is_empty() || edges.iter().all(|&edge| is_made(edge, &vertices, &all)))
            && are_delaunay(&corners, &edges)
    }

    /// How many edges have a vertex on them that is none of the input's.
    pub fn split_edges(&self, triangles: &[[Point<N>; 3]]) -> usize {
        let is_split = |edge: &&[usize; 2]| {
            let side = edge.map(|v| &self.points[v]);
            let is_added = |v: &&Point<N>| is_within(side, v) && !self.points.contains(v);
            triangles.as_flattened().iter().any(|v| is_added(&v))
        };
        self.edges.iter().filter(is_split).count()
    }

    /// The attribute that each triangle must have: that of the last seed that can be reached from it without crossing
    /// an edge, 0 without one.
    pub fn attributes(&self, triangles: &[[Point<N>; 3]], seeds: &[(Point<N>, f64)]) -> Vec<f64> {
        let corners: Vec<Triangle<'_, _>> = triangles.iter().map(|t| t.each_ref()).collect();
        let is_edge = |[a, b]: Side<'_, _>| {
            let edges = self.edges.iter();
            let mut edges = edges.map(|edge| edge.map(|v| &self.points[v]));
            edges.any(|edge| is_on(edge, a) && is_on(edge, b))
        };
        let is_open = |i: usize, j: usize| {
            let other = sides(corners[j]);
            let mut shared = sides(corners[i]).into_iter();
            shared.any(|[a, b]| other.contains(&[b, a]) && !is_edge([a, b]))
        };
        let mut faces: Vec<usize> = (0..corners.len()).collect();
        for i in 0..corners.len() {
            for j in (0..corners.len()).filter(|&j| is_open(i, j)) {
                let [one, other] = [faces[i], faces[j]];
                faces.iter_mut().for_each(|face| {
                    if *face == one {
                        *face = other;
                    }
                });
            }
        }
        let mut attributes = vec![0.0; corners.len()];
        for (seed, attribute) in seeds {
            let holds = |t: Triangle<'_, _>| {
                let is_right = |[a, b]: Side<'_, _>| orient(a, b, seed) == std::cmp::Ordering::Less;
                !sides(t).into_iter().any(is_right)
            };
            if let Some(found) = corners.iter().position(|&t| holds(t)) {
                for t in (0..corners.len()).filter(|&t| faces[t] == faces[found]) {
                    attributes[t] = *attribute;
                }
            }
        }
        attributes
    }

    /// The sides of the chains; of the hull those that have no point on their right.
    fn outline(&self) -> Vec<Side<'_, N>> {
        if self.chains.is_empty() {
            let mut hull = Vec::new();
            for a in self.points {
                for b in self.points.iter().filter(|&b| b != a) {
                    let is_beside = |v: &Point<N>| orient(a, b, v) == Greater || is_on([a, b], v);
                    if self.points.iter().all(is_beside) && !hull.contains(&[a, b]) {
                        hull.push([a, b]);
                    }
                }
            }
            return hull;
        }
        let next = |chain: &[usize], i: usize| chain[(i + 1) % chain.len()];
        let sides = self.chains.iter().flat_map(|chain| {
            (0..chain.len()).map(move |i| [chain[i], next(chain, i)].map(|v| &self.points[v]))
        });
        sides.collect()
    }

    /// Whether a triangle that turns left lies within the outline.
    fn holds(&self, outline: &[Side<'_, N>], t: Triangle<'_, N>) -> bool {
        if self.chains.is_empty() {
            let is_beside =
                |v: &Point<N>, [a, b]: &Side<'_, _>| orient(a, b, v) != std::cmp::Ordering::Less;
            return !outline.is_empty()
                && t.iter().all(|v| outline.iter().all(|s| is_beside(v, s)));
        }
        // The centre of the triangle, with everything three times as large.
        let three_times = |p: &Point<N>| [0, 1].map(|i| sum([0; 3].map(|_| p[i].clone())));
        let centre = [0, 1].map(|i| sum(t.iter().map(|v| v[i].clone())));
        let large: Vec<[Point<N>; 2]> = outline.iter().map(|side| side.map(three_times)).collect();
        let large: Vec<Side<'_, N>> = large.iter().map(|side| side.each_ref()).collect();
        !outline.iter().any(|&side| pierces(side, t)) && is_inside(&large, &centre)
    }

    /// Twice the area within the outline. Chains may run any way, but their areas are nested at most once.
    fn area(&self, outline: &[Side<'_, N>]) -> N {
        if self.chains.is_empty() {
            return sum(outline.iter().map(|[a, b]| cross(a, b)));
        }
        let mut area = N::zero();
        for chain in self.chains {
            let point = |i: usize| &self.points[chain[i % chain.len()]];
            let mut own = sum((0..chain.len()).map(|i| cross(point(i), point(i + 1))));
            // A chain within another one is a hole in it.
            let others = self.chains.iter().filter(|&other| other != chain);
            let is_hole = others.into_iter().any(|other| {
                let wanted = Wanted {
                    chains: std::slice::from_ref(other),
                    ..*self
                };
                is_inside(&wanted.outline(), point(0))
            });
            if own.is_negative() != is_hole {
                own = -own;
            }
            area = area + own;
        }
        area
    }
}

fn sum<N: Number>(numbers: impl IntoIterator<Item = N>) -> N {
    numbers.into_iter().fold(N::zero(), |sum, x| sum + x)
}

/// Whether a point on none of the sides has an odd number of them on its right.
fn is_inside<N: Number>(outline: &[Side<'_, N>], p: &Point<N>) -> bool {
    let is_right = |[a, b]: &&Side<'_, N>| {
        let [low, high] = if a[1] < b[1] { [a, b] } else { [b, a] };
        low[1] <= p[1] && p[1] < high[1] && orient(low, high, p) == Greater
    };
    outline.iter().filter(is_right).count() % 2 == 1
}

/// Whether a part of the side lies strictly inside a triangle that turns left.
fn pierces<N: Number>([p, q]: Side<'_, N>, t: Triangle<'_, N>) -> bool {
    // The part of the side over the sides of the triangle, from x / y to x / y of its length, with a positive y.
    let (mut from, mut to) = ((N::zero(), N::one()), (N::one(), N::one()));
    let is_less = |one: &(N, N), other: &(N, N)| {
        one.0.clone() * other.1.clone() < other.0.clone() * one.1.clone()
    };
    for [a, b] in sides(t) {
        // The height over a-b, at p and its change up to q.
        let along = vector(a, b);
        let (at, change) = (cross(&along, &vector(a, p)), cross(&along, &vector(p, q)));
        if change.is_zero() {
            if !at.is_positive() {
                return false;
            }
            continue;
        }
        let is_rising = change.is_positive();
        let place = if is_rising {
            (-at, change)
        } else {
            (at, -change)
        };
        if is_rising && is_less(&from, &place) {
            from = place;
        } else if !is_rising && is_less(&place, &to) {
            to = place;
        }
    }
    is_less(&from, &to)
}

/// How deep `d` lies in the circle of three points, by its centre: (r^2 - |d - o|^2) / r^2.
pub fn depth([a, b, c, d]: [&Exact; 4]) -> BigRational {
    // o is as far from a as from b and c: 2 (b - a) o = b^2 - a^2, and so for c.
    let square = |p: &Exact| &p[0] * &p[0] + &p[1] * &p[1];
    let two = BigRational::from_integer(2.into());
    let row = |p: &Exact| (vector(a, p).map(|x| x * &two), square(p) - square(a));
    let ((u, e), (v, f)) = (row(b), row(c));
    let under = cross(&u, &v);
    let centre = [
        (&e * &v[1] - &f * &u[1]) / &under,
        (&u[0] * &f - &v[0] * &e) / &under,
    ];
    let [radius, distance] = [a, d].map(|p| square(&vector(&centre, p)));
    (&radius - distance) / radius
}

/// The height of `b` over the line from `a` to `c`, in units of their distance, positive where the turn is to the
/// left: by the foot of the height.
pub fn height([a, b, c]: [&Exact; 3]) -> BigRational {
    let (ac, ab) = (vector(a, c), vector(a, b));
    let dot = |u: &Exact, v: &Exact| &u[0] * &v[0] + &u[1] * &v[1];
    let length = dot(&ac, &ac);
    let part = dot(&ab, &ac) / &length;
    let foot = [0, 1].map(|i| &a[i] + &part * &ac[i]);
    // The way from the foot to b is a multiple of a-c turned to the right.
    let [right, up] = [ac[1].clone(), -ac[0].clone()];
    let off = vector(&foot, b);
    if right.is_zero() {
        &off[1] / up
    } else {
        &off[0] / right
    }
}

/// Whether a size is that of the fraction but for a few roundings.
pub fn is_near(size: f64, exact: &BigRational) -> bool {
    let exact = exact.to_f64().unwrap_or(f64::NAN);
    (size - exact).abs() <= (1e-14 * exact.abs()).max(5e-324)
}

/// The sides of triangles, of these points by number, that are no edges or pieces of them and not Delaunay: each
/// once, lower number first, sorted, with the greater of the depths on both sides.
pub fn faulty_sides(
    points: &[Exact],
    edges: &[[usize; 2]],
    triangles: &[[usize; 3]],
) -> Vec<([usize; 2], BigRational)> {
    let mut found = Vec::new();
    let place = |v: usize| &points[v];
    for t in triangles {
        for i in 0..3 {
            let [a, b, c] = [0, 1, 2].map(|k| t[(i + k) % 3]);
            let across = triangles
                .iter()
                .flat_map(|u| (0..3).map(move |k| [0, 1, 2].map(|j| u[(k + j) % 3])));
            let Some([_, _, d]) = across.into_iter().find(|u| [u[0], u[1]] == [b, a]) else {
                continue;
            };
            let is_piece = edges.iter().any(|edge| {
                let side = edge.map(place);
                is_on(side, place(a)) && is_on(side, place(b))
            });
            let corners = [a, b, c, d].map(place);
            let [p, q, r, s] = corners;
            if a < b && !is_piece && in_circle(p, q, r, s) == Greater {
                found.push(([a, b], depth(corners).max(depth([q, p, s, r]))));
            }
        }
    }
    found.sort();
    debug_assert!(
        found
            .iter()
            .all(|(_, depth)| depth.cmp(&BigRational::zero()) != Equal)
    );
    found
}

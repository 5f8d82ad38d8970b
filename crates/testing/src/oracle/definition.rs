//! The answer by its definition, triangles and hull above all.
//!
//! A triangle is one of the constrained Delaunay triangulation if it turns left, holds no other
//! vertex, no piece of an edge crosses its inside, and no vertex that can be seen from its inside lies
//! inside its circumcircle. Ties of cocircular vertices are broken by lowering their lifted points
//! symbolically (`in_lowered_circle`), which makes the triangulation unique.
//!
//! Why this is the triangulation whose sides are all locally Delaunay: over such a triangulation the
//! lifted surface is convex along every line of sight, so a vertex seen from a triangle is not below
//! its plane. And if a triangle has the property but is none of that triangulation, the surface runs
//! below its plane somewhere inside; the corner to blame, of the triangle met there, can be seen from
//! there and lies below the plane, that is inside the circumcircle.

use std::cmp::Ordering::{Equal, Greater, Less};

use super::answer::Answer;
use super::graph::Graph;
use super::numbers::{Number, Point, cross, in_lowered_circle, lowering, sign, vector};
use crate::with_integers;

/// The answer, or all pairs of edges that cross (at least one).
pub type Verdict = Result<Answer, Vec<[usize; 2]>>;

/// The right answer for these points and edges.
pub fn verdict(points: &[[f64; 2]], edges: &[[usize; 2]]) -> Verdict {
    with_integers!(points, |exact| exact_verdict(&exact, edges))
}

/// The verdict on points that are given as integers.
pub fn exact_verdict<N: Number>(points: &[Point<N>], edges: &[[usize; 2]]) -> Verdict {
    let graph = Graph::new(points, edges);
    let crossings = graph.crossings();
    if !crossings.is_empty() {
        return Err(crossings);
    }
    let triangles = graph.triangles();
    let flat = triangles.is_empty();
    Ok(Answer {
        constrained: if flat {
            Vec::new()
        } else {
            graph.pieces.clone()
        },
        hull: if flat { Vec::new() } else { graph.hull() },
        triangles,
        representatives: graph.representatives.clone(),
        chains: graph.chains.clone(),
    })
}

/// Whether two edges of an input cross at a point that is no vertex.
pub fn crosses(points: &[[f64; 2]], edges: &[[usize; 2]], pair: [usize; 2]) -> bool {
    let edges = pair.map(|e| edges[e]);
    with_integers!(points, |exact| {
        !Graph::new(&exact, &edges).crossings().is_empty()
    })
}

impl<N: Number> Graph<'_, N> {
    /// The triangles of the canonical triangulation, each with its lowest vertex first; sorted.
    pub fn triangles(&self) -> Vec<[usize; 3]> {
        let mut triangles = Vec::new();
        for &a in &self.vertices {
            for &b in self.vertices.iter().filter(|&&b| b > a) {
                for &c in self.vertices.iter().filter(|&&c| c > a && c != b) {
                    let triangle = [a, b, c];
                    if self.orient(a, b, c) == Greater
                        && self.is_empty(triangle)
                        && self.is_whole(triangle)
                        && self.is_delaunay(triangle)
                    {
                        triangles.push(triangle);
                    }
                }
            }
        }
        triangles
    }

    fn others(&self, triangle: [usize; 3]) -> impl Iterator<Item = usize> + '_ {
        self.vertices
            .iter()
            .copied()
            .filter(move |v| !triangle.contains(v))
    }

    /// Whether no other vertex lies inside or on the border.
    fn is_empty(&self, triangle: [usize; 3]) -> bool {
        self.others(triangle).all(|v| {
            sides(triangle)
                .iter()
                .any(|&[a, b]| self.orient(a, b, v) == Less)
        })
    }

    /// Whether no piece of an edge crosses the inside: as no vertex is there, it would cross a side.
    fn is_whole(&self, triangle: [usize; 3]) -> bool {
        self.pieces
            .iter()
            .all(|&piece| sides(triangle).iter().all(|&side| !self.cross(side, piece)))
    }

    /// Whether no vertex inside the circumcircle can be seen from inside.
    fn is_delaunay(&self, triangle: [usize; 3]) -> bool {
        let [a, b, c] = triangle.map(|v| &self.points[v]);
        !self.others(triangle).any(|d| {
            in_lowered_circle(a, b, c, &self.points[d]) == Greater && self.sees(d, triangle)
        })
    }

    /// Whether a straight line runs from vertex `d` into the triangle without meeting a piece of an
    /// edge. What it meets changes only where it sweeps over a vertex, so one direction between each
    /// two vertices next to each other in the view is tried.
    fn sees(&self, d: usize, triangle: [usize; 3]) -> bool {
        let corner = |wrong| {
            let is_extreme = |&&v: &&usize| triangle.iter().all(|&w| self.orient(d, v, w) != wrong);
            *triangle
                .iter()
                .find(is_extreme)
                .expect("a triangle seen from outside has two ends")
        };
        let [right, left] = [corner(Less), corner(Greater)];
        let inside =
            |v: &usize| self.orient(d, right, *v) == Greater && self.orient(d, *v, left) == Greater;
        let mut view: Vec<usize> = self.vertices.iter().copied().filter(inside).collect();
        view.extend([right, left]);
        view.sort_by(|&v, &w| self.orient(d, w, v));
        view.windows(2).any(|pair| {
            let [u, v] = [pair[0], pair[1]].map(|v| vector(&self.points[d], &self.points[v]));
            let between = [u[0].clone() + v[0].clone(), u[1].clone() + v[1].clone()];
            sign(&cross(&u, &v)) == Greater && self.is_open(d, &between, triangle)
        })
    }

    /// Whether the ray from `d` in this direction enters the triangle before it meets any piece of an
    /// edge. It passes through no vertex.
    fn is_open(&self, d: usize, direction: &Point<N>, triangle: [usize; 3]) -> bool {
        let meets = |segment: &[usize; 2]| self.distance(d, direction, *segment);
        let is_less = |x: &Ratio<N>, y: &Ratio<N>| {
            x.over.clone() * y.under.clone() < y.over.clone() * x.under.clone()
        };
        let borders: Vec<Ratio<N>> = sides(triangle).iter().filter_map(meets).collect();
        self.pieces
            .iter()
            .filter_map(meets)
            .all(|distance| borders.iter().any(|border| is_less(border, &distance)))
    }

    /// How far along the direction the ray from `d` crosses a segment, if it does.
    fn distance(&self, d: usize, direction: &Point<N>, [a, b]: [usize; 2]) -> Option<Ratio<N>> {
        let [a, b] = [a, b].map(|v| vector(&self.points[d], &self.points[v]));
        let [from, to] = [sign(&cross(direction, &a)), sign(&cross(direction, &b))];
        if from == Equal || to == Equal || from == to {
            return None;
        }
        let along = vector(&a, &b);
        let (over, under) = (cross(&a, &along), cross(direction, &along));
        let (over, under) = if sign(&under) == Less {
            (-over, -under)
        } else {
            (over, under)
        };
        (sign(&over) == Greater).then_some(Ratio { over, under })
    }

    /// The vertices on the border of the convex hull, counter-clockwise from the leftmost, upper one,
    /// if not all lie on a line: the next is the first vertex with no other to its right.
    pub fn hull(&self) -> Vec<usize> {
        let least = |v: &usize, w: &usize| lowering(&self.points[*v], &self.points[*w]);
        let start = *self
            .vertices
            .iter()
            .min_by(|v, w| least(v, w))
            .expect("there are vertices");
        let mut hull = vec![start];
        loop {
            let last = hull[hull.len() - 1];
            let follows = |&next: &usize| {
                next != last
                    && self
                        .others([last, next, next])
                        .all(|v| self.passes(last, next, v))
            };
            let next = self
                .vertices
                .iter()
                .copied()
                .find(follows)
                .expect("a hull is closed");
            if next == start {
                return hull;
            }
            assert!(
                hull.len() < self.vertices.len(),
                "a hull comes back to its start"
            );
            hull.push(next);
        }
    }

    /// Whether `v` lies to the left of the line from `a` to `b`, or on it outside of them.
    fn passes(&self, a: usize, b: usize, v: usize) -> bool {
        let [p, q, r] = [a, b, v].map(|v| &self.points[v]);
        let outside = || {
            let order = lowering(p, q);
            lowering(p, r) != order || lowering(q, r) == order
        };
        match self.orient(a, b, v) {
            Greater => true,
            Less => false,
            Equal => outside(),
        }
    }
}

/// A number above zero as a fraction, both parts above zero.
struct Ratio<N> {
    over: N,
    under: N,
}

fn sides([a, b, c]: [usize; 3]) -> [[usize; 2]; 3] {
    [[b, c], [c, a], [a, b]]
}

//! Where many points lie in a triangulation, by a sweep.
//!
//! A vertical line, tilted a little so that it meets points of equal x from below, sweeps over vertices and points from
//! left to right. The triangles that it cuts are *active*; they stand one above the other. Triangles have *ranks*: one
//! that lies right above another has a higher rank. Ranks exist, since "right above" has no circle among convex shapes
//! that do not overlap (Guibas and Yao 1980). The triangles cover a convex hull, so between two that the line cuts
//! there is no gap, and their order on the line is that of their ranks. A point then lies in the last active triangle
//! whose lower sides are not above it, if anywhere. A tree over the ranks, which holds the lowest active rank of each
//! of its parts, finds this triangle by one sign for each level of the tree.
//!
//! Every comparison is exact: the order of coordinates, and on which side of a side a point lies.
//!
//! Cost: O((n + m) log(n + m)) for n triangles and m points, whatever they are.

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

use crate::scalar::{Scalar, orient2d};
use crate::triangulation::Triangulation;
use crate::triangulation::locate::Location;
use crate::triangulation::with_points::WithPoints;

/// Puts the places of those queries that stand in `order` into `places`.
pub(super) fn locate<S: Scalar>(
    view: &WithPoints<'_, S>,
    queries: &[[S; 2]],
    mut order: Vec<usize>,
    places: &mut [Location],
) {
    let (points, result) = (view.points, view.result);
    order.sort_unstable_by(|&a, &b| compare(&queries[a], &queries[b]));
    let mut vertices: Vec<usize> = result.triangles().flatten().collect();
    vertices.sort_unstable();
    vertices.dedup();
    vertices.sort_unstable_by(|&a, &b| compare(&points[a], &points[b]));

    let mut strips = Strips::new(view, &vertices);
    let mut swept = 0;
    for at in order {
        let query = &queries[at];
        while let Some(&v) = vertices.get(swept)
            && compare(&points[v], query).is_lt()
        {
            strips.pass(swept);
            swept += 1;
        }
        let vertex = vertices.get(swept);
        let vertex = vertex.filter(|&&v| compare(&points[v], query).is_eq());
        places[at] = match vertex {
            Some(&v) => Location::Vertex(v),
            None => strips.place(query),
        };
    }
}

/// The order in which the tilted line meets points.
fn compare<S: Scalar>(a: &[S; 2], b: &[S; 2]) -> Ordering {
    a[0].compare(&b[0]).then_with(|| a[1].compare(&b[1]))
}

/// The triangles, in the order of their ranks, and which of them the line cuts.
struct Strips<'a, S> {
    view: &'a WithPoints<'a, S>,
    /// The number of each vertex in the order of the sweep.
    number: Vec<usize>,
    /// The triangles by rank.
    ranked: Vec<usize>,
    /// For each vertex in the order of the sweep the ranks of the triangles that begin there, and that end there.
    begin: Lists,
    end: Lists,
    /// The lowest active rank of each part, in a binary tree: the root is 1, below i are 2 i and 2 i + 1, and the leaf of
    /// a rank is `leaves` further on.
    lowest: Vec<usize>,
    leaves: usize,
}

/// The mark of a part where nothing is active.
const NOTHING: usize = usize::MAX;

impl<'a, S: Scalar> Strips<'a, S> {
    fn new(view: &'a WithPoints<'a, S>, vertices: &[usize]) -> Strips<'a, S> {
        let result = view.result;
        let mut number = vec![0; view.points.len()];
        for (at, &v) in vertices.iter().enumerate() {
            number[v] = at;
        }
        let ranked = ranked(result, &number);
        let numbers = |&t: &usize| result.triangle(t).map(|v| number[v]);
        let list = |end: fn([usize; 3]) -> usize| {
            Lists::new(vertices.len(), ranked.iter().map(|t| end(numbers(t))))
        };
        let begin = list(|[a, b, c]| a.min(b).min(c));
        let end = list(|[a, b, c]| a.max(b).max(c));
        let leaves = ranked.len().next_power_of_two();
        Strips {
            view,
            number,
            begin,
            end,
            lowest: vec![NOTHING; 2 * leaves],
            leaves,
            ranked,
        }
    }

    /// Moves the line beyond the vertex of this number.
    fn pass(&mut self, vertex: usize) {
        for at in self.end.range(vertex) {
            self.set(self.end.items[at], NOTHING);
        }
        for at in self.begin.range(vertex) {
            let rank = self.begin.items[at];
            self.set(rank, rank);
        }
    }

    fn set(&mut self, rank: usize, value: usize) {
        let mut at = self.leaves + rank;
        self.lowest[at] = value;
        while at > 1 {
            at /= 2;
            self.lowest[at] = self.lowest[2 * at].min(self.lowest[2 * at + 1]);
        }
    }

    /// The place of a point on the line, which is no vertex.
    fn place(&self, query: &[S; 2]) -> Location {
        // Whether the lower sides of the lowest active triangle of a part are not above the point.
        let fits = |part: usize| {
            let rank = self.lowest[part];
            rank != NOTHING && !self.is_below(query, self.ranked[rank])
        };
        let mut part = 1;
        if !fits(part) {
            return Location::Outside;
        }
        while part < self.leaves {
            part = 2 * part + usize::from(fits(2 * part + 1));
        }
        let t = self.ranked[part - self.leaves];
        let turns = [0, 1, 2].map(|side| self.turn(query, t, side));
        if turns.contains(&Ordering::Less) {
            return Location::Outside;
        }
        self.view.at(t, turns)
    }

    /// Whether a point on the line is below a triangle that the line cuts: below the lower side that the line cuts.
    fn is_below(&self, query: &[S; 2], t: usize) -> bool {
        let corners = self.view.result.triangle(t);
        let is_lower = |side: &usize| {
            let [from, to] = ends(corners, *side).map(|v| self.number[v]);
            from < to
        };
        let is_cut = |side: &usize| {
            let ends = ends(corners, *side).map(|v| &self.view.points[v]);
            compare(ends[0], query).is_lt() && compare(query, ends[1]).is_lt()
        };
        let mut sides = (0..3).filter(is_lower).filter(is_cut);
        sides.any(|side| self.turn(query, t, side).is_lt())
    }

    /// The turn from a side of a triangle to a point: to the left where the triangle is.
    fn turn(&self, query: &[S; 2], t: usize, side: usize) -> Ordering {
        let [from, to] = ends(self.view.result.triangle(t), side);
        orient2d(&self.view.points[from], &self.view.points[to], query)
    }
}

/// The ends of the side opposite a corner, with the triangle on the left.
fn ends(corners: [usize; 3], side: usize) -> [usize; 2] {
    [corners[(side + 1) % 3], corners[(side + 2) % 3]]
}

/// The triangles, each after all that lie right below it (Kahn 1962). `number` is the order of the sweep: a side that
/// runs with it has its triangle above, one that runs against it has its triangle below.
fn ranked(result: &Triangulation, number: &[usize]) -> Vec<usize> {
    let lower = |t: usize| {
        let corners = result.triangle(t);
        [0, 1, 2].map(|side| {
            let [from, to] = ends(corners, side).map(|v| number[v]);
            from < to
        })
    };
    let waits = |t: usize| {
        let is_lower = lower(t);
        let sides = (0..3).filter(|&side| is_lower[side] && result.neighbor(t, side).is_some());
        sides.count()
    };
    let mut waiting: Vec<usize> = (0..result.len()).map(waits).collect();
    let mut ready: Vec<usize> = (0..result.len()).filter(|&t| waiting[t] == 0).collect();
    let mut ranked = Vec::with_capacity(result.len());
    while let Some(t) = ready.pop() {
        ranked.push(t);
        let is_lower = lower(t);
        for side in (0..3).filter(|&side| !is_lower[side]) {
            if let Some(above) = result.neighbor(t, side) {
                waiting[above] -= 1;
                if waiting[above] == 0 {
                    ready.push(above);
                }
            }
        }
    }
    ranked
}

/// Positions of items by a key: one list after the other.
struct Lists {
    items: Vec<usize>,
    /// Where the list of each key ends.
    ends: Vec<usize>,
}

impl Lists {
    fn new(count: usize, keys: impl Iterator<Item = usize> + Clone) -> Lists {
        let mut sizes = vec![0; count];
        keys.clone().for_each(|key| sizes[key] += 1);
        let mut ends: Vec<usize> = sizes
            .iter()
            .scan(0, |begin, size| {
                *begin += size;
                Some(*begin - size)
            })
            .collect();
        let mut items = vec![0; sizes.iter().sum()];
        for (item, key) in keys.enumerate() {
            items[ends[key]] = item;
            ends[key] += 1;
        }
        Lists { items, ends }
    }

    /// The places of the list of a key.
    fn range(&self, key: usize) -> core::ops::Range<usize> {
        let begin = key.checked_sub(1).map_or(0, |before| self.ends[before]);
        begin..self.ends[key]
    }
}

//! The pairs of edges that cross: by their boxes, and where too many boxes meet in vain, by a triangulation.
//!
//! Boxes of edges that cross meet ([`super::boxes`]). Short edges, and edges far apart, have few boxes that meet without
//! a crossing. Long edges side by side, such as a hatch, have many. After [`PATIENCE`] such pairs for each edge the boxes
//! are given up. A sweep line tells whether the edges meet at all ([`super::disjoint`]). If they do, they are separated
//! ([`separate`]): most lines of a hatch cross nothing, and go into one triangulation. It tells what the rest crosses
//! among them. Crossings within the rest are looked for by boxes again.
//!
//! Why it is right: a pair that crosses is in one of two sets. Either a triangulation meets it, or both of its edges are
//! of the rest. Four exact signs decide each pair: the ends of each edge lie on different sides of the other one. Then
//! the edges have one point in common, inside both. The pair is listed unless a vertex equals the point: a vertex at
//! the values nearest to it, which is compared with the point in fractions.
//!
//! Cost: O((n + k) log n) for n edges with k pairs of boxes that meet, where these are at most [`PATIENCE`] for each edge
//! and crossing; O(n log n) where edges meet in their ends alone. Otherwise that of the separation. Where this takes less
//! than an eighth of the edges away, each of the others crosses some edge, and all boxes are compared.

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::boxes::{Bounds, Boxes};
use super::disjoint::are_disjoint;
use super::error::SplitError;
use super::exact::Exact;
use super::vertices::Vertices;
use super::{Crossing, LIMIT};
use crate::scalar::{Scalar, filtered_orient2d};
use crate::sweep::{Separated, separate};

/// How many boxes may meet in vain for each edge and each crossing. Small inputs are tested as if they were large.
const PATIENCE: usize = if cfg!(any(test, fuzzing)) { 1 } else { 16 };

/// A crossing, with the values nearest to its point.
type Found<S> = (Crossing<S>, [S; 2]);

/// Finds the crossings of edges whose ends exist, among points that are finite.
pub(super) fn find<S: Exact>(
    points: &[[S; 2]],
    vertices: &Vertices<S>,
    edges: &[[usize; 2]],
) -> Result<Vec<Found<S>>, SplitError> {
    let mut search = Find {
        points,
        vertices,
        edges,
        found: Vec::new(),
    };
    let mut open: Vec<usize> = (0..edges.len()).collect();
    let mut patience = PATIENCE;
    while !search.by_boxes(&open, patience)? && !search.are_disjoint(&open) {
        let rest = search.by_triangulation(&open)?;
        if rest.len() > open.len() - open.len() / 8 {
            patience = usize::MAX;
        }
        open = rest;
    }
    let mut found = search.found;
    found.sort_unstable_by_key(|(crossing, _)| crossing.edges);
    Ok(found)
}

struct Find<'a, S> {
    points: &'a [[S; 2]],
    vertices: &'a Vertices<S>,
    edges: &'a [[usize; 2]],
    found: Vec<Found<S>>,
}

/// Why the comparison of boxes ends early.
enum Stop {
    /// Too many boxes meet in vain.
    InVain,
    Error(SplitError),
}

impl<S: Exact> Find<'_, S> {
    /// Adds the crossings of the edges with these positions among each other. Adds none, and returns `false`, if more
    /// boxes meet in vain than `patience` for each edge and crossing.
    fn by_boxes(&mut self, open: &[usize], patience: usize) -> Result<bool, SplitError> {
        let bounds = open.iter().map(|&edge| {
            let ends = self.edges[edge];
            Bounds::of(ends.map(|v| &self.points[v]))
        });
        let boxes = Boxes::new(bounds);
        let before = self.found.len();
        let mut left = patience.saturating_mul(open.len());
        let result = boxes.pairs(|pair| {
            let has_crossed = self
                .add(pair.map(|place| open[place]))
                .map_err(Stop::Error)?;
            left = if has_crossed {
                left.saturating_add(patience)
            } else {
                left.checked_sub(1).ok_or(Stop::InVain)?
            };
            Ok(())
        });
        match result {
            Ok(()) => Ok(true),
            Err(Stop::InVain) => {
                self.found.truncate(before);
                Ok(false)
            }
            Err(Stop::Error(error)) => Err(error),
        }
    }

    /// Whether the edges with these positions have nothing in common but ends.
    fn are_disjoint(&self, open: &[usize]) -> bool {
        are_disjoint(
            open.iter()
                .map(|&edge| self.edges[edge].map(|v| &self.points[v])),
        )
    }

    /// Adds the crossings of the edges with these positions among each other, but for some of the edges returned.
    fn by_triangulation(&mut self, open: &[usize]) -> Result<Vec<usize>, SplitError> {
        let mut ends: Vec<usize> = open.iter().flat_map(|&edge| self.edges[edge]).collect();
        ends.sort_unstable();
        ends.dedup();
        let points: Vec<[S; 2]> = ends.iter().map(|&v| self.points[v].clone()).collect();
        let place = |v: usize| ends.partition_point(|&end| end < v);
        let edges: Vec<[usize; 2]> = open
            .iter()
            .map(|&edge| self.edges[edge].map(place))
            .collect();
        let Some(Separated { rest, pairs }) = separate(&points, &edges, 2 * LIMIT)? else {
            return Err(SplitError::TooManyCrossings { limit: LIMIT });
        };
        // The crossings of two edges of the rest are looked for again.
        let mut is_rest = alloc::vec![false; open.len()];
        for &edge in &rest {
            is_rest[edge as usize] = true;
        }
        for pair in pairs {
            if !pair.iter().all(|&edge| is_rest[edge as usize]) {
                self.add(pair.map(|edge| open[edge as usize]))?;
            }
        }
        Ok(rest.into_iter().map(|edge| open[edge as usize]).collect())
    }

    /// Adds a pair if it crosses; returns whether it does. A pair comes once.
    fn add(&mut self, pair: [usize; 2]) -> Result<bool, SplitError> {
        let ends = pair.map(|edge| self.edges[edge].map(|v| &self.points[v]));
        if !cross(ends) {
            return Ok(false);
        }
        let crossing = Crossing::new(pair, ends);
        let nearest = crossing.nearest();
        if self.vertices.has(&nearest) && self.vertices.has_exactly(&crossing.point()) {
            return Ok(false);
        }
        if self.found.len() == LIMIT {
            return Err(SplitError::TooManyCrossings { limit: LIMIT });
        }
        self.found.push((crossing, nearest));
        Ok(true)
    }
}

/// Whether two edges have a point in common that is inside both, and no other.
fn cross<S: Scalar>([[a, b], [c, d]]: [[&[S; 2]; 2]; 2]) -> bool {
    let are_apart =
        |one: Ordering, other: Ordering| one != Ordering::Equal && one == other.reverse();
    let turn = filtered_orient2d;
    are_apart(turn(a, b, c), turn(a, b, d)) && are_apart(turn(c, d, a), turn(c, d, b))
}

#[cfg(test)]
mod tests {
    use super::super::crossings;
    use super::{LIMIT, cross};
    use crate::crossings::SplitError;

    type Graph = (Vec<[f64; 2]>, Vec<[usize; 2]>);

    /// Numbers from a small generator, the same at each call.
    fn numbers() -> impl FnMut(usize) -> usize {
        let mut state = 12345_u32;
        move |n| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as usize % n
        }
    }

    /// A hatch, whose boxes all meet, with some edges across it.
    fn hatch(lines: usize, others: usize, below: &mut impl FnMut(usize) -> usize) -> Graph {
        let (mut points, mut edges) = (Vec::new(), Vec::new());
        for i in 0..lines {
            let x = i as f64;
            points.extend([[x, 0.0], [x + lines as f64, lines as f64]]);
            edges.push([2 * i, 2 * i + 1]);
        }
        for _ in 0..others {
            edges.push([below(points.len()), below(points.len())]);
        }
        (points, edges)
    }

    /// Points on few places, with edges between them: they overlap, pass through vertices and cross there.
    fn on_few_places(below: &mut impl FnMut(usize) -> usize) -> Graph {
        let points = 4 + below(30);
        let places = 2 + below(9);
        let list = (0..points)
            .map(|_| [below(places) as f64, below(places) as f64])
            .collect();
        let edges = (0..2 + below(14)).map(|_| [below(points), below(points)]);
        (list, edges.collect())
    }

    /// Every pair, tried in whole numbers; a crossing at a vertex does not count.
    fn expected((points, edges): &Graph) -> Vec<[usize; 2]> {
        let at = |edge: usize| edges[edge].map(|v| &points[v]);
        let at_vertex = |e: usize, f: usize| {
            let turn = |edge: usize, [x, y]: [f64; 2]| {
                let [[ax, ay], [bx, by]] = at(edge).map(|p| *p);
                (bx - ax) * (y - ay) - (by - ay) * (x - ax)
            };
            points
                .iter()
                .any(|&point| turn(e, point) == 0.0 && turn(f, point) == 0.0)
        };
        let mut pairs = Vec::new();
        for f in 0..edges.len() {
            for e in 0..f {
                if cross([at(e), at(f)]) && !at_vertex(e, f) {
                    pairs.push([e, f]);
                }
            }
        }
        pairs.sort_unstable();
        pairs
    }

    #[test]
    fn every_pair_is_found_once() {
        let below = &mut numbers();
        let (mut some, mut too_many) = (0, 0);
        for round in 0..3000 {
            let graph = if round % 3 == 0 {
                let (lines, others) = (2 + below(90), below(12));
                hatch(lines, others, below)
            } else {
                on_few_places(below)
            };
            let expected = expected(&graph);
            match crossings(&graph.0, &graph.1) {
                Ok(found) => {
                    let found: Vec<_> = found.iter().map(|crossing| crossing.edges).collect();
                    assert_eq!(found, expected, "{graph:?}");
                    some += usize::from(!found.is_empty());
                }
                Err(error) => {
                    assert_eq!(error, SplitError::TooManyCrossings { limit: LIMIT });
                    assert!(expected.len() > LIMIT, "{graph:?}");
                    too_many += 1;
                }
            }
        }
        assert!(
            some > 1000 && too_many > 10,
            "{some} with crossings, {too_many} with too many"
        );
    }
}

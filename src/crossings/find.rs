//! The pairs of edges that cross: by their boxes, and where too many boxes meet in vain, by a triangulation.
//!
//! Boxes of edges that cross meet ([`super::boxes`]). Short edges, and edges far apart, have few boxes that meet without
//! a crossing. Long edges side by side, such as a hatch, have many. After as many such pairs for each edge and crossing as
//! the *patience* allows ([`Effort`]) the boxes are given up. If none of them crossed, a sweep line tells whether the
//! edges meet at all ([`super::disjoint`]). If they do, they are separated ([`separate`]): most lines of a hatch cross
//! nothing, and go into one triangulation. It tells what the rest crosses among them. Crossings within the rest are
//! looked for again. The crossings that the boxes had found in vain are a debt: the boxes are not tried again before
//! triangulations have found as many. A vertex at which two edges were seen to meet is a vertex of later triangulations:
//! all edges that pass it are separated at once.
//!
//! Why it is right: a pair that crosses is in one of two sets. Either a triangulation meets it, or both of its edges are
//! of the rest. Four exact signs decide each pair: the ends of each edge lie on different sides of the other one. Then
//! the edges have one point in common, inside both. The pair is listed unless a vertex equals the point: a vertex at
//! the values nearest to it, which lies on both edges.
//!
//! Cost: O(n log n) for n edges, and each pair of boxes that meets, where these are at most as many as the patience
//! allows. O(n log n) where edges meet in their ends alone. Otherwise that of the separations. An edge of the rest
//! crosses one that is not, as a rule, so all separations together get no more edges than there are edges and crossings;
//! and the debt bounds what boxes do in vain by what is found.

use alloc::vec::Vec;
use core::cmp::Ordering;

use super::Crossing;
use super::bounds::Bounds;
use super::boxes;
use super::disjoint::are_disjoint;
use super::effort::Effort;
use super::error::SplitError;
use super::exact::Exact;
use super::vertices::Vertices;
use crate::scalar::{Scalar, filtered_orient2d};
use crate::sweep::{Separated, separate};

/// A crossing, with the values nearest to its point.
type Found<S> = (Crossing<S>, [S; 2]);

/// Finds the crossings of edges whose ends exist, among points that are finite.
pub(super) fn find<S: Exact>(
    points: &[[S; 2]],
    vertices: &Vertices<S>,
    edges: &[[usize; 2]],
    effort: &mut Effort,
) -> Result<Vec<Found<S>>, SplitError> {
    let mut search = Find {
        points,
        vertices,
        edges,
        found: Vec::new(),
        passed: Vec::new(),
        effort,
    };
    let mut open: Vec<usize> = (0..edges.len()).collect();
    let mut patience = search.effort.patience;
    let mut debt = 0;
    loop {
        if debt == 0 {
            debt = match search.by_boxes(&open, patience)? {
                Some(in_vain) => in_vain,
                None => break,
            };
            if debt == 0 && search.are_disjoint(&open) {
                break;
            }
        }
        let before = search.found.len();
        let rest = search.by_triangulation(&open)?;
        debt = debt.saturating_sub(search.found.len() - before);
        if rest.len() == open.len() {
            // Only with a scalar that is not exact.
            (patience, debt) = (usize::MAX, 0);
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
    /// Vertices inside two edges or more, as far as they were met.
    passed: Vec<usize>,
    effort: &'a mut Effort,
}

/// Why the comparison of boxes ends early.
enum Stop {
    /// Too many boxes meet in vain.
    InVain,
    Error(SplitError),
}

impl<S: Exact> Find<'_, S> {
    /// Adds the crossings of the edges with these positions among each other. Adds none, and returns how many it found
    /// in vain, if more boxes meet without a crossing than `patience` for each edge and crossing.
    fn by_boxes(&mut self, open: &[usize], patience: usize) -> Result<Option<usize>, SplitError> {
        let bounds = open.iter().map(|&edge| Bounds::of(self.ends(edge)));
        let bounds: Vec<Bounds> = bounds.collect();
        let before = self.found.len();
        let mut left = patience.saturating_mul(open.len());
        // The search counts its own work, so that `self` is free for `add`.
        let mut work = Effort::default();
        let result = boxes::pairs(&bounds, &mut work, |pair| {
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
        self.effort.visited += work.visited;
        match result {
            Ok(()) => Ok(None),
            Err(Stop::InVain) => {
                let in_vain = self.found.len() - before;
                self.found.truncate(before);
                Ok(Some(in_vain))
            }
            Err(Stop::Error(error)) => Err(error),
        }
    }

    fn ends(&self, edge: usize) -> [&[S; 2]; 2] {
        self.edges[edge].map(|v| &self.points[v])
    }

    /// Whether the edges with these positions have nothing in common but ends.
    fn are_disjoint(&mut self, open: &[usize]) -> bool {
        self.effort.swept += open.len() as u64;
        are_disjoint(open.iter().map(|&edge| self.ends(edge)))
    }

    /// Adds the crossings of the edges with these positions among each other, but for some of the edges returned.
    fn by_triangulation(&mut self, open: &[usize]) -> Result<Vec<usize>, SplitError> {
        let limit = self.effort.limit;
        let separated = match self.separated(open)? {
            None => {
                // So many pairs may meet at vertices, which a triangulation of all points knows.
                self.passed = (0..self.points.len()).collect();
                self.separated(open)?
            }
            separated => separated,
        };
        let Separated { rest, pairs } = separated.ok_or(SplitError::TooManyCrossings { limit })?;
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

    /// Separates the edges with these positions; `None` if that takes too many pairs.
    fn separated(&mut self, open: &[usize]) -> Result<Option<Separated>, SplitError> {
        self.effort.separated += open.len() as u64;
        self.passed.sort_unstable();
        self.passed.dedup();
        let mut inputs: Vec<usize> = open.iter().flat_map(|&edge| self.edges[edge]).collect();
        inputs.extend(&self.passed);
        inputs.sort_unstable();
        inputs.dedup();
        let points: Vec<[S; 2]> = inputs.iter().map(|&v| self.points[v].clone()).collect();
        let place = |v: usize| inputs.partition_point(|&input| input < v);
        let edges: Vec<[usize; 2]> = open
            .iter()
            .map(|&edge| self.edges[edge].map(place))
            .collect();
        Ok(separate(&points, &edges, 2 * self.effort.limit)?)
    }

    /// Adds a pair if it crosses; returns whether it does. A pair comes once.
    fn add(&mut self, pair: [usize; 2]) -> Result<bool, SplitError> {
        let ends = pair.map(|edge| self.ends(edge));
        if !cross(ends) {
            return Ok(false);
        }
        // Lines that cross have one point in common.
        let is_on_both = |&v: &usize| {
            let on = |[a, b]: [&[S; 2]; 2]| filtered_orient2d(a, b, &self.points[v]).is_eq();
            ends.into_iter().all(on)
        };
        // Where many edges pass one vertex, the point is not computed for each pair.
        if self.passed.last().is_some_and(is_on_both) {
            return Ok(false);
        }
        let crossing = Crossing::new(pair, ends);
        let nearest = crossing.nearest();
        if let Some(v) = self.vertices.at(&nearest).filter(is_on_both) {
            self.passed.push(v);
            return Ok(false);
        }
        let limit = self.effort.limit;
        if self.found.len() == limit {
            return Err(SplitError::TooManyCrossings { limit });
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
    use super::super::crossings_with;
    use super::{Effort, cross};
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

    /// Edges that meet at vertices inside them: lines through the points of a grid, or through some centres.
    fn through_vertices(below: &mut impl FnMut(usize) -> usize) -> Graph {
        let (mut points, mut edges) = (Vec::new(), Vec::new());
        let mut edge = |points: &[[f64; 2]]| edges.push([points.len() - 2, points.len() - 1]);
        if below(2) == 0 {
            let [columns, rows] = [2 + below(15), 2 + below(15)];
            let grid = (0..columns * rows).map(|i| [1 + i % columns, 1 + i / columns]);
            points.extend(grid.map(|place| place.map(|x| x as f64)));
            for x in 1..=columns {
                points.extend([[x as f64, 0.0], [x as f64, rows as f64 + 1.0]]);
                edge(&points);
            }
            for y in 1..=rows {
                points.extend([[0.0, y as f64], [columns as f64 + 1.0, y as f64]]);
                edge(&points);
            }
        } else {
            for _ in 0..1 + below(3) {
                let [x, y] = [below(20) as f64, below(20) as f64];
                points.push([x, y]);
                for _ in 0..1 + below(20) {
                    let [dx, dy] = [below(99) as f64 - 49.0, 1.0 + below(50) as f64];
                    points.extend([[x - dx, y - dy], [x + dx, y + dy]]);
                    edge(&points);
                }
            }
        }
        (points, edges)
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

    /// So few crossings may be listed here.
    const LIMIT: usize = 100;

    #[test]
    fn every_pair_is_found_once() {
        let below = &mut numbers();
        let (mut some, mut too_many) = (0, 0);
        for round in 0..3000 {
            let graph = match round % 6 {
                0 | 3 => {
                    let (lines, others) = (2 + below(90), below(12));
                    hatch(lines, others, below)
                }
                1 | 4 => through_vertices(below),
                _ => on_few_places(below),
            };
            let expected = expected(&graph);
            // Small inputs are searched as if they were large.
            let effort = &mut Effort {
                patience: round % 2,
                limit: LIMIT,
                ..Effort::default()
            };
            match crossings_with(&graph.0, &graph.1, effort) {
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

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
use crate::scalar::{Scalar, orient2d};
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

    /// Adds the crossings of the edges with these positions among each other. Crossings between two of the edges returned
    /// are still to be found.
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
            let on = |[a, b]: [&[S; 2]; 2]| orient2d(a, b, &self.points[v]).is_eq();
            ends.into_iter().all(on)
        };
        // Where many edges pass one vertex, the point is not computed for each pair.
        if self.passed.last().is_some_and(is_on_both) {
            return Ok(false);
        }
        let crossing = Crossing::new(pair, ends);
        let nearest = crossing.point_rounded();
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
    let turn = orient2d;
    are_apart(turn(a, b, c), turn(a, b, d)) && are_apart(turn(c, d, a), turn(c, d, b))
}

//! Equal points: the first stands for all, as in a [`crate::Triangulation`]. Cost: O(n log n) comparisons for n points.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::exact::Exact;
use crate::error::Error;

/// A point as a key, with its approximation, which is compared first: it is monotone.
#[derive(Clone, Debug)]
struct Place<S> {
    near: [f64; 2],
    point: [S; 2],
}

impl<S: Exact> Place<S> {
    fn new(point: [S; 2]) -> Place<S> {
        let near = point.each_ref().map(S::approx);
        Place { near, point }
    }
}

impl<S: Exact> Ord for Place<S> {
    fn cmp(&self, other: &Self) -> Ordering {
        let by = |i: usize| {
            let near = self.near[i].partial_cmp(&other.near[i]);
            let near = near.expect("approximations are numbers");
            near.then_with(|| self.point[i].compare(&other.point[i]))
        };
        by(0).then_with(|| by(1))
    }
}

impl<S: Exact> PartialOrd for Place<S> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<S: Exact> PartialEq for Place<S> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl<S: Exact> Eq for Place<S> {}

/// The distinct points, each with its first index.
#[derive(Debug)]
pub(super) struct Vertices<S> {
    at: BTreeMap<Place<S>, usize>,
    points: usize,
}

impl<S: Exact> Vertices<S> {
    /// Finds the distinct points, which must be finite.
    pub(super) fn new(points: &[[S; 2]]) -> Result<Vertices<S>, Error> {
        let is_finite = |point: &[S; 2]| point.iter().all(S::is_finite);
        if let Some(vertex) = points.iter().position(|point| !is_finite(point)) {
            return Err(Error::NonFiniteCoordinate { vertex });
        }
        // Of equal keys the last one stays.
        let numbered = points.iter().enumerate().rev();
        Ok(Vertices {
            at: numbered
                .map(|(v, point)| (Place::new(point.clone()), v))
                .collect(),
            points: points.len(),
        })
    }

    pub(super) fn check(&self, edges: &[[usize; 2]]) -> Result<(), Error> {
        for (edge, ends) in edges.iter().enumerate() {
            if let Some(&vertex) = ends.iter().find(|&&vertex| vertex >= self.points) {
                return Err(Error::EdgeOutOfRange { edge, vertex });
            }
        }
        Ok(())
    }

    /// The first of each set of equal points.
    pub(super) fn all(&self) -> Vec<usize> {
        self.at.values().copied().collect()
    }

    /// The first point that equals `place`.
    pub(super) fn at(&self, place: &[S; 2]) -> Option<usize> {
        self.at.get(&Place::new(place.clone())).copied()
    }

    /// The first point that equals `point`; it is added to `points` if there is none.
    pub(super) fn number(&mut self, point: [S; 2], points: &mut Vec<[S; 2]>) -> usize {
        *self
            .at
            .entry(Place::new(point))
            .or_insert_with_key(|place| {
                points.push(place.point.clone());
                points.len() - 1
            })
    }
}

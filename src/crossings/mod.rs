//! All pairs of edges that cross, and edges split where they cross.
//!
//! A triangulation takes no edges that cross at a point that is no vertex (the paper says nothing of them), and
//! [`Error::CrossingEdges`](crate::Error::CrossingEdges) names one such pair. [`crossings`] lists all pairs, each with
//! its exact point, and [`split`] makes vertices of these points. Edges that touch or cross at a vertex, pass through
//! vertices, overlap or have no length are no errors, and are not listed.
//!
//! Cost: O((n + k) log n) for n edges, k pairs of which have upright boxes that meet, if these are at most 16 for each
//! edge and crossing. If there are more, as in a hatch, a sweep line tells whether edges meet at all. If so, they go
//! into a triangulation, but for a *rest* that would cross others there. The rest is searched again. Each crossing takes
//! half a microsecond more, and 80 bytes if it is one of doubles. Its point in fractions takes some 20 microseconds, and
//! is computed when it is asked for.

// The pairs are found in `find`, edges split in `split`; the other files are for both, but `boxes` and `disjoint` for
// `find`, and `cells` and `nearby` for `split` alone.

mod bounds;
mod boxes;
mod cells;
mod disjoint;
mod effort;
mod enclosure;
mod error;
mod exact;
mod find;
mod nearby;
mod split;
mod vertices;

use alloc::vec::Vec;

use num_rational::BigRational;
use num_traits::ToPrimitive;

use exact::{enclosed_meeting, meeting};
use find::find;
use vertices::Vertices;

#[doc(hidden)]
pub use effort::Effort;
pub use enclosure::Enclosure;
pub use error::SplitError;
pub use exact::Exact;
#[doc(hidden)]
pub use split::split_with;
pub use split::{Split, split};

/// Two edges that cross, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Crossing<S> {
    /// The positions of the two edges in the list of edges, lower one first.
    pub edges: [usize; 2],
    /// The ends of each of the two.
    pub ends: [[[S; 2]; 2]; 2],
}

impl<S: Exact> Crossing<S> {
    fn new(edges: [usize; 2], ends: [[&[S; 2]; 2]; 2]) -> Crossing<S> {
        let mut both = [0, 1].map(|i| (edges[i], ends[i].map(Clone::clone)));
        both.sort_unstable_by_key(|&(edge, _)| edge);
        Crossing {
            edges: both.each_ref().map(|&(edge, _)| edge),
            ends: both.map(|(_, ends)| ends),
        }
    }

    /// The exact point inside both edges.
    pub fn point(&self) -> [BigRational; 2] {
        meeting(self.borrowed())
    }

    /// The values of the scalar that are nearest to the coordinates of the point.
    pub fn nearest(&self) -> [S; 2] {
        self.rounded(S::nearest_of, S::nearest)
    }

    /// The doubles nearest to the coordinates of the point; infinite where these are too large.
    pub fn near(&self) -> [f64; 2] {
        let near = |x: &BigRational| x.to_f64().expect("a fraction has a double near it");
        self.rounded(Enclosure::nearest, near)
    }

    /// The point rounded: where it can be, as it is enclosed, else in fractions.
    fn rounded<T>(
        &self,
        enclosed: impl Fn(&Enclosure) -> Option<T>,
        exact: impl Fn(&BigRational) -> T,
    ) -> [T; 2] {
        let quickly = || {
            let [x, y] = enclosed_meeting(self.borrowed())?;
            Some([enclosed(&x)?, enclosed(&y)?])
        };
        quickly().unwrap_or_else(|| self.point().each_ref().map(exact))
    }

    fn borrowed(&self) -> [[&[S; 2]; 2]; 2] {
        self.ends.each_ref().map(|ends| ends.each_ref())
    }
}

/// All pairs of `edges` that cross at a point that is none of `points`, sorted.
///
/// An input has none if and only if [`triangulate`](crate::triangulate) does not refuse it with
/// [`Error::CrossingEdges`](crate::Error::CrossingEdges). An edge that is given twice has its crossings twice.
///
/// # Errors
/// [`SplitError`]: a coordinate is not finite, an edge has an end that is no point, or over 4,194,304 pairs cross.
///
/// ```
/// let points = [[0.0, 0.0], [3.0, 1.0], [0.0, 1.0], [3.0, 0.0], [9.0, 9.0]];
/// let found = sweep_cdt::crossings::crossings(&points, &[[0, 1], [1, 4], [2, 3]])?;
/// assert_eq!(found.len(), 1);
/// assert_eq!(found[0].edges, [0, 2]);
/// assert_eq!(found[0].point().map(|x| x.to_string()), ["3/2", "1/2"]);
/// assert_eq!(found[0].nearest(), [1.5, 0.5]);
/// # Ok::<(), sweep_cdt::crossings::SplitError>(())
/// ```
pub fn crossings<S: Exact>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
) -> Result<Vec<Crossing<S>>, SplitError> {
    crossings_with(points, edges, &mut Effort::default())
}

/// As [`crossings`], with bounds of its own and a count of its work: for tests.
#[doc(hidden)]
pub fn crossings_with<S: Exact>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    effort: &mut Effort,
) -> Result<Vec<Crossing<S>>, SplitError> {
    let vertices = Vertices::new(points)?;
    vertices.check(edges)?;
    let found = find(points, &vertices, edges, effort)?;
    Ok(found.into_iter().map(|(crossing, _)| crossing).collect())
}

#[cfg(test)]
mod tests {
    use super::{Effort, SplitError, crossings_with};

    #[test]
    fn more_crossings_than_can_be_held_are_an_error() {
        // A grid of `rows` rows and ten columns.
        let grid = |rows: u32| {
            let row = |i| [[-1.0, f64::from(i)], [10.0, f64::from(i)]];
            let column = |i| [[f64::from(i), -1.0], [f64::from(i), f64::from(rows)]];
            let ends: Vec<_> = (0..rows)
                .map(row)
                .chain((0..10).map(column))
                .flatten()
                .collect();
            let edges: Vec<_> = (0..ends.len()).step_by(2).map(|v| [v, v + 1]).collect();
            let effort = &mut Effort {
                limit: 100,
                ..Effort::default()
            };
            crossings_with(&ends, &edges, effort).map(|found| found.len())
        };
        assert_eq!(grid(10), Ok(100));
        assert_eq!(grid(11), Err(SplitError::TooManyCrossings { limit: 100 }));
    }
}

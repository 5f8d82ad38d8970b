//! All pairs of edges that cross, and edges split where they cross.
//!
//! A triangulation takes no edges that cross at a point that is no vertex (the paper says nothing of them), and
//! [`Error::CrossingEdges`](crate::Error::CrossingEdges) names one such pair. [`crossings`] lists all pairs, each with
//! its exact point, and [`split`] makes vertices of these points. Edges that touch or cross at a vertex, pass through
//! vertices, overlap or have no length are no errors, and are not listed.
//!
//! Cost: O((n + k) log n) for n edges, k pairs of which have upright boxes that meet, if these are at most eight for each
//! edge and crossing. If there are more, as in a hatch, a sweep line tells whether edges meet at all. If they do,
//! they go into a triangulation, but for a *rest*: edges that would cross others there. The search begins anew with the
//! rest. The point of a crossing is computed in fractions when it is asked for.

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

use exact::{enclosed_meeting, meeting};
use find::find;
use vertices::Vertices;

#[doc(hidden)]
pub use effort::Effort;
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

    /// The point in the scalar: the values nearest to its coordinates.
    pub fn point_rounded(&self) -> [S; 2] {
        let quickly = || {
            let [x, y] = self.point_enclosed()?;
            Some([S::nearest_of_double(x)?, S::nearest_of_double(y)?])
        };
        quickly().unwrap_or_else(|| self.point().each_ref().map(S::nearest))
    }

    /// The point in doubles: those nearest to its coordinates; infinite where these are too large.
    pub fn point_f64(&self) -> [f64; 2] {
        let exactly = || self.point().each_ref().map(f64::nearest);
        self.point_enclosed().unwrap_or_else(exactly)
    }

    /// [`point_f64`](Crossing::point_f64) without fractions, if enclosures tell.
    fn point_enclosed(&self) -> Option<[f64; 2]> {
        let [x, y] = enclosed_meeting(self.borrowed())?;
        Some([x.nearest()?, y.nearest()?])
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
/// assert_eq!(found[0].point_rounded(), [1.5, 0.5]);
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

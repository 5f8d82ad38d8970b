//! A triangulation with its points. A [`Triangulation`] holds indices alone. [`Triangulation::with_points`] borrows the
//! points once, and the view locates, verifies, and finds the interior of seeds.

use crate::scalar::Scalar;
use crate::triangulation::Triangulation;
use crate::verify::{Report, Violations, verify};
use alloc::vec::Vec;

/// A triangulation with the points that were triangulated; [`Triangulation::with_points`] makes it.
///
/// ```
/// use sweep_cdt::Location;
///
/// let points = [[0, 0], [4, 0], [4, 3], [0, 3], [2, 1]];
/// let edges = [[0, 2]];
/// let result = sweep_cdt::triangulate(&points, &edges)?;
/// let view = result.with_points(&points);
/// assert_eq!(view.locate(&[2, 1]), Location::Vertex(4));
/// assert!(view.verify(&edges)?.is_canonical());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct WithPoints<'a, S> {
    pub(crate) result: &'a Triangulation,
    pub(crate) points: &'a [[S; 2]],
}

// By hand, since a derived implementation would ask for scalars that can be copied.
impl<S> Clone for WithPoints<'_, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S> Copy for WithPoints<'_, S> {}

impl Triangulation {
    /// The triangulation with `points`: those that were triangulated, and others behind them, if there are any.
    ///
    /// # Panics
    /// If there are fewer points than were triangulated.
    pub fn with_points<'a, S: Scalar>(&'a self, points: &'a [[S; 2]]) -> WithPoints<'a, S> {
        assert!(
            points.len() >= self.vertices.len() + self.duplicates.len(),
            "these are not the points of the triangulation"
        );
        WithPoints {
            result: self,
            points,
        }
    }
}

impl<S: Scalar> WithPoints<'_, S> {
    /// Checks the triangulation with the exact verifier, which shares only the signs of [`crate::scalar`] (filter and
    /// exact predicates) with the sweep. `edges` are those triangulated; [`mod@crate::verify`] says what is proved.
    ///
    /// # Errors
    /// [`Violations`]: what is wrong, up to a limit. There are none for the input that this is the result of.
    pub fn verify(&self, edges: &[[usize; 2]]) -> Result<Report, Violations> {
        let triangles: Vec<[usize; 3]> = self.result.triangles().collect();
        verify(self.points, edges, &triangles)
    }
}

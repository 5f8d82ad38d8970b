//! Triangulators with one of two sets of thresholds, so that small inputs take the paths of large ones as well.
//!
//! A hash of the points and edges chooses between [`Tuning::REAL`], which ships, and [`Tuning::SMALL`]. So an input has
//! the same set each time, and moved or reordered it may have the other: the results must be equal all the same.

use std::hash::{DefaultHasher, Hash, Hasher};

use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Error, Triangulation, Triangulator, Tuning};

/// Whether an input is handled as if it were large.
pub fn is_small<S: Scalar>(points: &[[S; 2]], edges: &[[usize; 2]]) -> bool {
    // The keys of this hasher are fixed.
    let mut hasher = DefaultHasher::new();
    for coordinate in points.iter().flatten() {
        coordinate.approx().to_bits().hash(&mut hasher);
    }
    edges.hash(&mut hasher);
    hasher.finish() & 1 == 1
}

/// The thresholds for an input.
pub fn tuning<S: Scalar>(points: &[[S; 2]], edges: &[[usize; 2]]) -> &'static Tuning {
    if is_small(points, edges) {
        &Tuning::SMALL
    } else {
        &Tuning::REAL
    }
}

/// A triangulator with the thresholds for an input.
pub fn triangulator<S: Scalar>(points: &[[S; 2]], edges: &[[usize; 2]]) -> Triangulator {
    Triangulator::new().tuning(tuning(points, edges))
}

/// Triangulates with the thresholds for the input.
///
/// # Errors
/// As [`Triangulator::triangulate`].
pub fn triangulate<S: Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
) -> Result<Triangulation, Error> {
    triangulator(points, edges).triangulate(points, edges)
}

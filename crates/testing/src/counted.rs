//! A run with its statistics, in one call.

use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Error, Stats, Triangulation, Triangulator, Watch};

/// A result and the statistics of the run.
#[derive(Clone, Debug)]
pub struct Counted {
    /// The result.
    pub triangulation: Triangulation,
    /// The statistics.
    pub stats: Stats,
}

/// Triangulates with statistics, and otherwise watched as given.
///
/// # Errors
/// As [`Triangulator::run`].
pub fn watched<S: Scalar>(
    triangulator: &Triangulator,
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    watch: Watch<'_>,
) -> Result<Counted, Error> {
    let mut stats = Stats::default();
    let triangulation = triangulator.run(points, edges, watch.stats(&mut stats))?;
    Ok(Counted {
        triangulation,
        stats,
    })
}

/// Triangulates with statistics.
///
/// # Errors
/// As [`Triangulator::triangulate`].
pub fn counted<S: Scalar>(
    triangulator: &Triangulator,
    points: &[[S; 2]],
    edges: &[[usize; 2]],
) -> Result<Counted, Error> {
    watched(triangulator, points, edges, Watch::new())
}

//! A run with its statistics, in one call.

use sweep_cdt::front::FrontSearch;
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

/// Triangulates with statistics and this search structure.
///
/// # Errors
/// As [`Triangulator::run`].
pub fn counted_with<S: Scalar>(
    triangulator: &Triangulator,
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    front: &mut dyn FrontSearch,
) -> Result<Counted, Error> {
    let mut stats = Stats::default();
    let watch = Watch::new().front(front).stats(&mut stats);
    let triangulation = triangulator.run(points, edges, watch)?;
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
    let mut stats = Stats::default();
    let triangulation = triangulator.run(points, edges, Watch::new().stats(&mut stats))?;
    Ok(Counted {
        triangulation,
        stats,
    })
}

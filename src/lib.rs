//! placeholder
mod error;
mod front;
mod heuristics;
mod input;
mod mesh;
mod order;
mod predicates;
mod probe;
pub mod scalar;
mod stats;
mod sweep;
mod triangulation;
mod triangulator;

pub use error::Error;
pub use front::{Domain, Front, FrontNode, FrontSearch, HashTable, Linear, SkipList};
pub use heuristics::{Fill, Heuristics};
pub use scalar::{Scalar, Unbounded};
pub use stats::{Counters, Stats};
pub use triangulation::Triangulation;
pub use triangulator::Triangulator;

/// The constrained Delaunay triangulation of `points` with `edges`.
///
/// # Errors
/// See [`Error`].
pub fn triangulate<S: Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
) -> Result<Triangulation, Error> {
    Triangulator::new().triangulate(points, edges)
}

#![doc = include_str!("crate.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![cfg_attr(not(any(test, feature = "std")), no_std)]

extern crate alloc;

mod bucket;
pub mod crossings;
mod error;
pub mod front;
mod ids;
mod input;
pub mod interior;
#[doc(hidden)]
pub mod memory;
mod mesh;
mod observe;
mod pslg;
mod random;
pub mod scalar;
mod session;
mod settings;
mod sweep;
#[doc(hidden)]
pub mod threads;
pub mod trace;
mod triangulation;
mod triangulator;
mod tuning;
pub mod verify;
mod watch;

pub use error::Error;
pub use input::triangulate_from;
pub use observe::stats::{ByCause, Counters, Stats};
pub use pslg::{Pslg, Region};
pub use session::Session;
#[doc(hidden)]
pub use settings::Ties;
pub use settings::{Algorithm, Corners, Heuristics};
pub use triangulation::Triangulation;
pub use triangulation::canonical::CanonicalGroups;
pub use triangulation::locate::Location;
pub use triangulation::stars::{Corner, VertexStars};
pub use triangulation::with_points::WithPoints;
pub use triangulator::Triangulator;
#[doc(hidden)]
pub use tuning::Tuning;
#[cfg(feature = "parallel")]
pub use watch::Bands;
pub use watch::Watch;

/// The constrained Delaunay triangulation of `points` with `edges`, by the sweep line of Domiter and Žalik (2008).
///
/// `points` are `[x, y]` in any [`Scalar`](scalar::Scalar); `edges` are pairs of positions in `points`. They may come
/// in any order, with duplicates. Edges may share ends, overlap, pass through points or have no length. Fewer than
/// three distinct points, or points all on one line, give no triangles. [`Triangulator`] has settings and statistics.
///
/// # Errors
/// [`Error`] names the offender: a coordinate that is not finite, an edge with an end that is no point, two edges that
/// cross, or what is too many: points, edges, or vertices on edges. It is an error too if memory does not suffice.
///
/// ```
/// let points = [[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [0.0, 2.0]];
/// let result = sweep_cdt::triangulate(&points, &[[1, 3]])?;
/// assert_eq!(result.canonical_triangles(), [[0, 1, 3], [1, 2, 3]]);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
pub fn triangulate<S: scalar::Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
) -> Result<Triangulation, Error> {
    Triangulator::new().triangulate(points, edges)
}

/// The example of the README, as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

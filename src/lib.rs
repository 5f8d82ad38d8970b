#![doc = include_str!("crate.md")]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![cfg_attr(not(any(test, feature = "std")), no_std)]

extern crate alloc;

use alloc::vec::Vec;

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
pub use triangulation::locate::Location;
pub use triangulation::stars::VertexStars;
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

/// The triangles inside of polygons by a [`FillRule`](interior::FillRule), in canonical order.
///
/// [`Triangulation::interior`] finds the same triangles in the whole triangulation. If the edges are rings that
/// neither touch nor cross, only the inside is triangulated here, which takes less time. By winding number this also asks that
/// rings in one another run in opposite directions, as outlines and holes do. All other input is triangulated as a whole.
/// [`Session::triangulate_inside`] does it for many polygons in the same memory.
///
/// # Errors
/// [`InteriorError`](interior::InteriorError), if the edges are no closed rings, or cannot be triangulated.
///
/// ```
/// use sweep_cdt::{interior::FillRule, triangulate_inside};
///
/// // A square with a square hole.
/// let points = [[0, 0], [9, 0], [9, 9], [0, 9], [3, 3], [6, 3], [6, 6], [3, 6]];
/// let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
/// let triangles = triangulate_inside(&points, &edges, FillRule::EvenOdd)?;
/// assert_eq!(triangles[..2], [[0, 1, 5], [0, 4, 3]]);
/// assert_eq!(triangles.len(), 8);
/// # Ok::<(), sweep_cdt::interior::InteriorError>(())
/// ```
pub fn triangulate_inside<S: scalar::Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    rule: interior::FillRule,
) -> Result<Vec<[usize; 3]>, interior::InteriorError> {
    let mut session = Triangulator::new().session();
    session.triangulate_inside(points, edges, rule)?;
    Ok(session.into_inside())
}

/// The example of the README, as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

//! Points and edges in the forms that other programs have them in: tuples, types of one's own, numbers of 32 bits.
//!
//! [`triangulate`](crate::triangulate) and all methods borrow `[[S; 2]]` and `[[usize; 2]]`, and copy nothing. Here
//! everything that becomes an array of two is copied to these.

use crate::error::Error;
use crate::scalar::Scalar;
use crate::triangulation::Triangulation;
use crate::triangulator::Triangulator;

/// In place of edges where there are none: an empty list would not tell of what.
pub const NO_EDGES: [[usize; 2]; 0] = [];

/// The same as [`triangulate`](crate::triangulate) for points and edges in other forms.
///
/// A point is anything that becomes `[S; 2]`: an array, a tuple, a type of your own. An edge is anything that becomes
/// two numbers, of any type that becomes `usize` or fails to.
///
/// # Errors
/// See [`Error`]. An end of an edge that is no `usize`, such as -1, counts as the largest one, which is no point.
///
/// ```
/// use sweep_cdt::input::{NO_EDGES, triangulate_from};
///
/// let tuples = vec![(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (0.0, 2.0)];
/// let edges: [(u32, u32); 1] = [(1, 3)];
/// let result = triangulate_from(tuples.iter().copied(), edges)?;
/// assert_eq!(result.canonical_triangles(), [[0, 1, 3], [1, 2, 3]]);
///
/// struct Place {
///     east: i64,
///     north: i64,
/// }
///
/// impl From<Place> for [i64; 2] {
///     fn from(place: Place) -> [i64; 2] {
///         [place.east, place.north]
///     }
/// }
///
/// let places = [(0, 0), (2, 0), (1, 5)].map(|(east, north)| Place { east, north });
/// assert_eq!(triangulate_from(places, NO_EDGES)?.len(), 1);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
pub fn triangulate_from<S: Scalar, V: TryInto<usize>>(
    points: impl IntoIterator<Item: Into<[S; 2]>>,
    edges: impl IntoIterator<Item: Into<[V; 2]>>,
) -> Result<Triangulation, Error> {
    Triangulator::new().triangulate(&self::points(points), &self::edges(edges))
}

/// Points as all methods take them.
///
/// ```
/// use sweep_cdt::{Triangulator, input};
///
/// let points = input::points([(0, 0), (2, 0), (1, 5)]);
/// let edges = input::edges([[0_u32, 1]]);
/// let run = Triangulator::new().triangulate_with_stats(&points, &edges)?;
/// assert!(run.triangulation.verify(&points, &edges).is_ok());
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
pub fn points<S>(points: impl IntoIterator<Item: Into<[S; 2]>>) -> Vec<[S; 2]> {
    points.into_iter().map(Into::into).collect()
}

/// Edges as all methods take them. What is no `usize` becomes the largest one.
pub fn edges<V: TryInto<usize>>(edges: impl IntoIterator<Item: Into<[V; 2]>>) -> Vec<[usize; 2]> {
    let number = |v: V| v.try_into().unwrap_or(usize::MAX);
    let edges = edges.into_iter();
    edges.map(|edge| edge.into().map(number)).collect()
}

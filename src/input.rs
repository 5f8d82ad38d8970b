//! Points and edges in other forms: tuples, types of one's own, numbers of 32 bits.
//!
//! [`triangulate`](crate::triangulate) and all methods borrow `[[S; 2]]` and `[[usize; 2]]`, and copy nothing.
//! [`triangulate_from`] copies all that becomes such an array.

use crate::error::Error;
use crate::scalar::Scalar;
use crate::triangulation::Triangulation;
use crate::triangulator::Triangulator;
use alloc::vec::Vec;

/// [`triangulate`](crate::triangulate) for points and edges in other forms: tuples, own types, 32-bit numbers.
///
/// A point is anything that becomes `[S; 2]`: an array, a tuple, a type of your own. An edge is anything that becomes
/// two numbers, of any type that becomes `usize` or fails to.
///
/// # Errors
/// See [`Error`]. An end of an edge that is no `usize`, such as -1, counts as the largest one, which is no point.
///
/// ```
/// use sweep_cdt::triangulate_from;
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
/// assert_eq!(triangulate_from(places, [[0; 2]; 0])?.len(), 1);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
pub fn triangulate_from<S: Scalar, V: TryInto<usize>>(
    points: impl IntoIterator<Item: Into<[S; 2]>>,
    edges: impl IntoIterator<Item: Into<[V; 2]>>,
) -> Result<Triangulation, Error> {
    let points: Vec<[S; 2]> = points.into_iter().map(Into::into).collect();
    let number = |v: V| v.try_into().unwrap_or(usize::MAX);
    let edges: Vec<[usize; 2]> = edges
        .into_iter()
        .map(|edge| edge.into().map(number))
        .collect();
    Triangulator::new().triangulate(&points, &edges)
}

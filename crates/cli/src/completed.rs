//! The triangles of a result that fills a domain, completed to a triangulation of the hull.
//!
//! Certificates are of the hull. Declaring sides of a constrained Delaunay triangulation edges changes nothing in it. So the
//! input is triangulated with all sides of the result as edges: inside these are the triangles of the result, and outside
//! those of the crate, by the rule for ties. The border of the domain lies on edges of the input, or on the hull: without
//! the sides as edges, all stays constrained Delaunay.
//!
//! Cost: that of a triangulation, and a sort of the triangles.

use sweep_cdt::scalar::Scalar;
use sweep_cdt::triangulate;
use sweep_cdt_formats::Coordinate;

use crate::shared::arithmetic::Given;
use crate::shared::failure::Failure;

/// All triangles, and for each whether it is of the result. The result must be right.
pub(crate) fn completed<S: Coordinate, T: Scalar + Sync>(
    given: &Given<'_, S, T>,
    triangles: &[[usize; 3]],
) -> Result<(Vec<[usize; 3]>, Vec<bool>), Failure> {
    let of_triangle = |&[a, b, c]: &[usize; 3]| [[a, b], [b, c], [c, a]];
    let sides = triangles.iter().flat_map(of_triangle);
    let mut sides: Vec<[usize; 2]> = sides.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    sides.sort_unstable();
    sides.dedup();
    let mut edges = given.file.graph.edges.clone();
    edges.append(&mut sides);
    let hull = triangulate(given.points, &edges).map_err(|error| given.refused(error))?;
    // Of equal points the triangles of the hull have one.
    let mut same: Vec<usize> = (0..given.points.len()).collect();
    for [copy, first] in hull.duplicates() {
        same[copy] = first;
    }
    let key = |triangle: &[usize; 3]| {
        let mut corners = triangle.map(|v| same[v]);
        corners.sort_unstable();
        corners
    };
    let mut own: Vec<[usize; 3]> = triangles.iter().map(key).collect();
    own.sort_unstable();
    let all: Vec<[usize; 3]> = hull.triangles().collect();
    let is_own = all
        .iter()
        .map(|triangle| own.binary_search(&key(triangle)).is_ok());
    let is_own = is_own.collect();
    Ok((all, is_own))
}

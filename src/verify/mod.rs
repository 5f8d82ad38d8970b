//! The verifier: is this a constrained Delaunay triangulation?
//!
//! The verifier reads points, edges and triangles as bare arrays, made by any program, and decides all by exact signs.
//! With the sweep it shares the predicates of [`scalar`](crate::scalar), and nothing else. The checks, in order:
//!
//! | | check |
//! |---|---|
//! | 1 | all coordinates are finite and all indices in range |
//! | 2 | every triangle turns left, strictly |
//! | 3 | every half-edge (a side of a triangle in its direction) occurs once |
//! | 4 | the sides without a triangle on their right form one closed chain, which never turns right nor back and goes round once |
//! | 5 | every distinct point is a corner |
//! | 6 | the number of triangles is Euler's, 2 n - 2 - h for n points, h of them on the boundary |
//! | 7 | every input edge is a chain of sides |
//! | 8 | every other side between two triangles is *locally Delaunay*: the corner opposite to it in one triangle is not strictly inside the circumcircle of the other |
//! | 9 | if the caller gives the attributes of regions: each triangle has that of the region it lies in |
//!
//! Why that proves it: docs/proofs/verify.md. Checks 1 to 6 prove that the triangles tile the hull or the declared domain,
//! 7 that the edges are there, and 8 that the triangulation is constrained Delaunay (Lee and Lin 1986; Chew 1989).
//! A triangle that fails check 1 or 2 is left out of the later ones: a wrong side of it shows only when it turns left.
//! Cost: O(n log n) on every input; usually linear but for one sort of the points. 64 bytes a triangle.

mod bent;
mod boundary;
mod chunks;
mod declared;
mod delaunay;
mod depth;
mod edges;
mod input;
mod regions;
mod report;
mod runs;
mod scanline;
mod sides;
mod soup;
mod turns;
mod verifier;
mod violation;

pub use depth::{Depth, Depths};
pub use report::{Level, Report, Violations};
pub use verifier::Verifier;
pub use violation::{Offenders, Violation};

use crate::scalar::Scalar;

/// Verifies that `triangles` is a constrained Delaunay triangulation of `points` with `edges`.
///
/// Triangles are counter-clockwise triples of indices; clockwise ones need [`Verifier::accept_clockwise`]. If a program says
/// nothing of the direction, turn each triangle to the left before, by [`orient2d`](crate::scalar::orient2d). Indices of
/// 32 bits are widened before: `triangle.map(|v| v as usize)`. Equal points count as one, and triangles and edges may
/// name any of them. Points on one line have no triangles, and their edges are not checked. The level asked for is
/// [`Level::Delaunay`], so of four points on a circle either diagonal is right. [`Verifier`] has options, and can use all
/// cores.
///
/// A program that decides by rounded numbers, as Qhull does, may leave a side wrong where four points are nearly on one
/// circle; [`Violations::depth`] tells that from a wrong triangulation. Such a program may also drop points that are
/// nearly equal to others: each is a [`Violation::UnusedPoint`], which has no depth.
///
/// # Errors
/// [`Violations`], if `triangles` is no such triangulation, or if the input is out of range or not finite. At most 100
/// violations are listed ([`Verifier::limit`]); all are counted.
///
/// ```
/// use sweep_cdt::verify::verify;
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [5.0, 3.0], [0.0, 3.0]];
/// let report = verify(&points, &[], &[[0, 1, 3], [1, 2, 3]])?;
/// assert_eq!((report.boundary_sides, report.free_sides), (4, 1));
///
/// let wrong = verify(&points, &[], &[[0, 1, 2], [0, 2, 3]]).unwrap_err();
/// assert_eq!(wrong.list[0].to_string(), "side 0-2 of triangles 1 and 0 is not Delaunay: \
///     the circle of one holds vertex 3 or 1 of the other");
///
/// // With the edge 0-2 given, it is right.
/// assert!(verify(&points, &[[0, 2]], &[[0, 1, 2], [0, 2, 3]]).is_ok());
/// # Ok::<(), sweep_cdt::verify::Violations>(())
/// ```
pub fn verify<S: Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    triangles: &[[usize; 3]],
) -> Result<Report, Violations> {
    Verifier::new().verify(points, edges, triangles)
}

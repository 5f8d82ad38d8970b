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
//! # Why that proves it
//! *The triangles cover the convex hull once.* Take a point q that is on no side. The triangles turn left (2), so the
//! number of triangles around q is the sum of the winding numbers of their borders around q. A side with triangles on
//! both sides is passed in both directions (3), which cancels. What is left is the winding number of the boundary. By
//! (4) the boundary is a convex polygon, passed once: 1 inside, 0 outside. So the triangles cover the polygon once. The
//! polygon is the hull of their corners, hence of all points (5).
//!
//! *A domain that the caller declares* takes the place of the hull. (4) then asks that the boundary is the declared
//! one, whichever way its chains run, and (5) that the declared sides do not cross and go round each place once or not
//! at all. So the triangles cover the domain once, and points outside it need no corner.
//!
//! *Points may be added* to those of the input, if the caller allows it. The corners at which the hull of all points
//! turns must be the input's (4), so it is the hull of the input's points. Sides of a declared domain may have added
//! points on them. All other checks take added points like others. Added points beside edges and sides, as rounding
//! leaves them, are violations with a depth; `bent.rs` has the proof that the triangles are right but for it.
//!
//! *The triangles meet side to side.* Suppose a vertex v lies inside a side of a triangle. The triangles at that side
//! already cover all of the polygon near v, so those with the corner v cover a part of it twice. (Points that are equal
//! count as one.) Euler's formula (6) then follows; it is checked as a second opinion, by nothing but counting.
//!
//! *The triangulation is constrained Delaunay:* if a point p inside a triangle t sees a vertex v (no constrained edge
//! crosses the segment p-v), then v is not inside the circumcircle of t. This is the theorem of Lee and Lin
//! (Generalized Delaunay triangulation for planar graphs, Discrete & Computational Geometry 1, 1986, 201-217) and Chew
//! (Constrained Delaunay triangulations, Algorithmica 4, 1989, 97-108). Its proof: choose p so that the segment passes
//! through no other vertex. It passes through triangles t = t0, t1, ..., tk, the last with corner v, and by (7) crosses
//! only free sides. Let P(i, x) be the power of x to the circumcircle of ti, negative inside. P(i, x) - P(i + 1, x) is
//! linear in x, zero on the side between ti and ti+1, and by (8) not negative at the corner of ti+1 opposite to that
//! side. So it is not negative at v, which lies on the same side of it as that corner. Hence P(0, v) >= P(k, v) = 0.
//!
//! *The triangulation is the canonical one* if, besides, of four vertices on one circle the diagonal ends at the
//! leftmost one (of two, the upper one). Lift the points to the paraboloid, then lower them a little, the leftmost one
//! most of all: no ties are left, the diagonals chosen are locally Delaunay, and the same proof makes it unique.
//!
//! *Levels.* Checks 1 to 6 prove that the triangles tile the hull or the domain; with check 7 they are a constrained
//! triangulation; with check 8 a constrained Delaunay one. [`Level`] says what is asked for: a lower level leaves out
//! the violations of those above. All checks are made, and the report names the highest level reached. But a triangle
//! that fails check 1 or 2 is left out of the later checks: a wrong side of it shows only when it turns left.
//!
//! *How wrong.* A side that is not Delaunay, a turn that is not convex and an edge with added points beside it have a
//! [`Depth`], exact in its sign and right in size, which tells rounding from a wrong triangulation. It measures what is wrong, and proves nothing right.
//!
//! Cost: O(n log n) on every input, since sides, straight chains and points in a declared domain are found by sorting
//! and searching; usually linear but for one sort of the points. 64 bytes a triangle.
//!
//! # Results of other programs
//! Corners are `usize`. The `simplices` of `scipy.spatial.Delaunay` are `i32`:
//! `simplices.iter().map(|t| t.map(|v| v as usize))` converts them, and makes of -1 an index out of range. Clockwise
//! triangles need [`Verifier::accept_clockwise`]. Where some turn left and others right, as `simplices` do, turn each
//! to the left before:
//!
//! ```
//! use std::cmp::Ordering;
//! use sweep_cdt::scalar::filtered_orient2d;
//! use sweep_cdt::verify::verify;
//!
//! let points = [[0.0, 0.0], [4.0, 0.0], [5.0, 3.0], [0.0, 3.0]];
//! let simplices = [[0_i32, 1, 3], [1, 3, 2]];
//! let turned = simplices.iter().map(|t| {
//!     let [a, b, c] = t.map(|v| v as usize);
//!     match filtered_orient2d(&points[a], &points[b], &points[c]) {
//!         Ordering::Less => [a, c, b],
//!         _ => [a, b, c],
//!     }
//! });
//! let triangles: Vec<[usize; 3]> = turned.collect();
//! assert!(verify(&points, &[], &triangles).is_ok());
//! ```
//!
//! A program that decides by rounded numbers, as Qhull does, may leave a side wrong where four points are nearly on one
//! circle: [`Violations::depth`] tells that from a wrong triangulation. (It is about 1e-16 to 1e-12 for what rounding
//! leaves, and usually far more for a diagonal of the wrong four points.) Such a program may also drop points that are
//! nearly equal to others. Each is a [`Violation::UnusedPoint`], which has no depth: without these points, and with the
//! corners numbered anew, the level of the rest shows.

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
pub use regions::Regions;
pub use report::{Level, Report, Violations};
pub use verifier::Verifier;
pub use violation::{Offenders, Violation};

use crate::scalar::Scalar;

/// Verifies that `triangles` is a constrained Delaunay triangulation of `points` with `edges`.
///
/// The proof is in the documentation of this module. Triangles are counter-clockwise triples of indices; clockwise ones
/// need [`Verifier::accept_clockwise`]. Equal points count as one, and triangles and edges may name any of them. Points
/// on one line have no triangles, and their edges are not checked. The level asked for is [`Level::Delaunay`], so of
/// four points on a circle either diagonal is right. [`Verifier`] has options, and can use all cores.
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

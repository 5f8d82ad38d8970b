//! Is this a constrained Delaunay triangulation? The verifier reads points, edges and triangles as bare
//! arrays, from whatever program, decides everything by exact signs, and shares nothing with the sweep.
//!
//! Checks, in this order:
//! 1. all coordinates are finite and all indices in range;
//! 2. every triangle turns left, strictly;
//! 3. every side of a triangle, as a directed edge, occurs once;
//! 4. the sides without a triangle across them form one closed chain that never turns right nor back
//!    and goes round once;
//! 5. every distinct point is a corner;
//! 6. the number of triangles is Euler's, 2 n - 2 - h for n points, h of them on the boundary;
//! 7. every input edge is a chain of sides;
//! 8. no other inner side has the vertex opposite to it on one side strictly inside the circumcircle of
//!    the triangle on the other side (it is *locally Delaunay*).
//!
//! # Why that proves it
//!
//! *The triangles tile the convex hull.* The triangles turn left, so the number of them around a point
//! q in none of their sides is the sum of the winding numbers of their borders around q. Sides with a
//! triangle across them are run through in both directions (3) and cancel; what is left is the winding
//! number of the boundary, which by (4) is a convex polygon run through once: 1 inside, 0 outside. So
//! the triangles cover the polygon once. It is the hull of their corners, hence of all points (5). They
//! meet side to side: a vertex v inside a side of a triangle has all its neighbourhood within the
//! polygon covered by the triangles at that side, so that v's own triangles would cover a part of it
//! twice; and points that are equal count as one. Euler's formula (6) then follows; it is checked as a
//! second opinion, by nothing but counting.
//!
//! *It is constrained Delaunay:* no vertex v that a point p inside triangle t sees (no constrained edge
//! crosses the segment p-v) lies inside the circumcircle of t. This is the theorem of Lee and Lin
//! (Generalized Delaunay triangulation for planar graphs, Discrete & Computational Geometry 1, 1986,
//! 201-217) and Chew (Constrained Delaunay triangulations, Algorithmica 4, 1989, 97-108), here with its
//! proof. Choose p so that the segment passes through no other vertex. It runs through triangles
//! t = t0, t1, ..., tk, the last with corner v, and by (7) crosses only free sides. Let P(i, x) be the
//! power of the point x to the circumcircle of ti, negative inside. P(i, x) - P(i + 1, x) is linear in
//! x, zero on the side between ti and ti+1, and by (8) not negative at the corner of ti+1 opposite to
//! it; so it is not negative at v, which lies on that corner's side. Hence P(0, v) >= P(k, v) = 0.
//!
//! *It is the canonical one* if, besides, of four vertices on one circle the side has the leftmost (of
//! two, the upper one) for an end: that is local Delaunayhood for points lifted to the paraboloid and
//! then lowered a little, the leftmost most of all, where no ties are left and the same proof makes the
//! triangulation unique.
//!
//! Cost: linear but for one sort, about 0.4 s for a million points on one core; 60 bytes a triangle.

mod boundary;
mod edges;
mod findings;
mod input;
mod local;
mod offenders;
mod points;
mod report;
mod sides;
mod signs;

use std::cmp::Ordering;

use crate::scalar::Scalar;
use findings::Findings;
use input::{Input, Mesh};
use local::{Pass, Run};
pub use offenders::Offenders;
pub use report::{Report, Violation, Violations};
use sides::{NONE, Sides};
use signs::Tally;

/// Whether `triangles` is a constrained Delaunay triangulation of `points` with `edges`; the proof is in
/// the documentation of this module.
///
/// Triangles are counter-clockwise triples of indices. Equal points count as one, and triangles and
/// edges may name any of them. Points that lie on one line have no triangles, and their edges are not
/// looked for. [`Verifier`] has options, and can use all cores.
///
/// # Errors
/// [`Violations`], if it is none, or if the input is out of range or not finite.
///
/// ```
/// let points = [[0.0, 0.0], [4.0, 0.0], [5.0, 3.0], [0.0, 3.0]];
/// let report = sweep_cdt::verify::verify(&points, &[], &[[0, 1, 3], [1, 2, 3]])?;
/// assert_eq!((report.boundary_sides, report.free_sides), (4, 1));
///
/// let wrong = sweep_cdt::verify::verify(&points, &[], &[[0, 1, 2], [0, 2, 3]]).unwrap_err();
/// assert_eq!(wrong.list[0].to_string(), "side 0-2 of triangles 1 and 0 is not Delaunay: \
///     the circle of one holds vertex 3 or 1 of the other");
///
/// // With the edge 0-2 given, it is right.
/// assert!(sweep_cdt::verify::verify(&points, &[[0, 2]], &[[0, 1, 2], [0, 2, 3]]).is_ok());
/// # Ok::<(), sweep_cdt::verify::Violations>(())
/// ```
pub fn verify<S: Scalar>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    triangles: &[[usize; 3]],
) -> Result<Report, Violations> {
    Verifier::new().verify(points, edges, triangles)
}

/// The verifier with options.
///
/// ```
/// use sweep_cdt::verify::Verifier;
///
/// let points = [[0.0, 0.0], [3.0, 0.0], [0.0, 3.0], [1.0, 1.0]];
/// let clockwise = [[0, 3, 1], [1, 3, 2], [2, 3, 0]];
/// let verifier = Verifier::new().accept_clockwise(true);
/// assert!(verifier.verify_parallel(&points, &[], &clockwise)?.clockwise);
/// # Ok::<(), sweep_cdt::verify::Violations>(())
/// ```
#[derive(Clone, Copy)]
pub struct Verifier<'a> {
    clockwise: bool,
    boundary: Option<&'a [Vec<usize>]>,
    limit: usize,
    progress: Option<&'a (dyn Fn(usize, usize) + Sync)>,
}

impl std::fmt::Debug for Verifier<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Verifier")
            .field("clockwise", &self.clockwise)
            .field("boundary", &self.boundary)
            .field("limit", &self.limit)
            .finish_non_exhaustive()
    }
}

impl Default for Verifier<'_> {
    fn default() -> Self {
        Verifier::new()
    }
}

impl<'a> Verifier<'a> {
    /// Counter-clockwise triangles, the hull as the boundary, 100 violations listed.
    pub fn new() -> Verifier<'a> {
        Verifier {
            clockwise: false,
            boundary: None,
            limit: 100,
            progress: None,
        }
    }

    /// Whether triangles may be clockwise instead, all of them.
    pub fn accept_clockwise(self, clockwise: bool) -> Self {
        Verifier { clockwise, ..self }
    }

    /// Says that not the hull is triangulated but the domain that these closed chains of vertices
    /// bound: outer ones counter-clockwise, those of holes clockwise, each without its first vertex at
    /// the end.
    ///
    /// The boundary must then have exactly their sides. The triangles cover each point as often as the
    /// chains go round it; that this is once in the domain and never outside is for the caller to say.
    /// Points outside the domain may be unused (each unused point is compared with all sides of the
    /// chains), Euler's formula is not checked, and edges must lie in the domain.
    pub fn boundary(self, chains: &'a [Vec<usize>]) -> Self {
        Verifier {
            boundary: Some(chains),
            ..self
        }
    }

    /// How many violations are listed; all are counted.
    pub fn limit(self, limit: usize) -> Self {
        Verifier { limit, ..self }
    }

    /// Is called now and then, from any thread, with how much is done and how much there is in all.
    pub fn progress(self, progress: &'a (dyn Fn(usize, usize) + Sync)) -> Self {
        Verifier {
            progress: Some(progress),
            ..self
        }
    }

    /// Verifies on one thread.
    ///
    /// # Errors
    /// [`Violations`], if `triangles` is no constrained Delaunay triangulation of `points` with `edges`.
    pub fn verify<S: Scalar>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        triangles: &[[usize; 3]],
    ) -> Result<Report, Violations> {
        self.run(points, edges, triangles, local::serial)
    }

    /// Verifies on all threads of the current rayon pool. The answer is the same.
    ///
    /// # Errors
    /// [`Violations`], if `triangles` is no constrained Delaunay triangulation of `points` with `edges`.
    #[cfg(feature = "parallel")]
    pub fn verify_parallel<S: Scalar + Sync>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        triangles: &[[usize; 3]],
    ) -> Result<Report, Violations> {
        self.run(points, edges, triangles, local::parallel)
    }

    fn run<S: Scalar>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        triangles: &[[usize; 3]],
        run: Run<S>,
    ) -> Result<Report, Violations> {
        let mut findings = Findings::new(self.limit);
        let mut report = Report {
            points: points.len(),
            edges: edges.len(),
            triangles: triangles.len(),
            ..Report::default()
        };
        let largest = points.len().max(triangles.len().saturating_mul(3));
        if largest > sides::LIMIT {
            findings.add(Violation::TooLarge {
                given: largest,
                limit: sides::LIMIT,
            });
        } else {
            self.check(points, edges, triangles, run, &mut findings, &mut report);
        }
        if findings.found == 0 {
            Ok(report)
        } else {
            let Findings { list, found, .. } = findings;
            Err(Violations {
                list,
                found,
                report: Box::new(report),
            })
        }
    }

    fn check<S: Scalar>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        triangles: &[[usize; 3]],
        run: Run<S>,
        findings: &mut Findings,
        report: &mut Report,
    ) {
        let mut tally = Tally::default();
        let input = input::read(
            points,
            edges,
            triangles,
            self.boundary.unwrap_or(&[]),
            findings,
        );
        let Input {
            mut mesh,
            edges,
            declared,
            used,
        } = input;
        report.distinct_points = mesh.signs.vertex.len();
        report.clockwise = self.clockwise && mesh.turn_if_clockwise(&mut tally);

        for part in run(&mesh, Pass::Turns, self) {
            for (t, turn) in part.bad {
                // What is left out here is not blamed again below.
                mesh.triangles[t as usize] = [NONE; 3];
                let triangle = t as usize;
                findings.add(match turn {
                    Ordering::Equal => Violation::FlatTriangle { triangle },
                    _ => Violation::ReversedTriangle { triangle },
                });
            }
            tally += part.tally;
        }

        let mut sides = Sides::new(&mesh, findings);
        report.boundary_sides = sides.boundary.len();
        // A faulty triangle leaves a hole: not another fault.
        let sound = findings.found == 0;
        if self.boundary.is_some() {
            if sound {
                boundary::check_declared(&mesh, &sides.boundary, &declared, findings);
            }
        } else if triangles.is_empty() {
            mesh.check_collinear(&mut tally, findings);
        } else if sound {
            boundary::check_hull(&mesh, &sides.boundary, &mut tally, findings);
        }

        for v in used..mesh.count() {
            let needed = match self.boundary {
                Some(_) => boundary::is_inside(&mesh, &declared, v, &mut tally),
                None => !triangles.is_empty(),
            };
            if needed {
                findings.add(Violation::UnusedPoint {
                    vertex: mesh.signs.name(v),
                });
            }
        }
        if findings.found == 0 && self.boundary.is_none() && !triangles.is_empty() {
            let expected = 2 * report.distinct_points - 2 - report.boundary_sides;
            if triangles.len() != expected {
                findings.add(Violation::WrongCount {
                    triangles: triangles.len(),
                    expected,
                });
            }
        }
        if !triangles.is_empty() {
            report.constrained_sides =
                edges::check(&mesh, &mut sides, &edges, &mut tally, findings);
        }

        for part in run(&mesh, Pass::Sides(&sides.twin), self) {
            report.free_sides += part.free;
            report.cocircular_sides += part.cocircular;
            report.uncanonical_sides += part.uncanonical;
            findings.append(part.findings);
            tally += part.tally;
        }
        (report.filtered, report.exact) = (tally.filtered, tally.exact);
    }

    /// Tells how many triangles of both passes are done.
    fn report_progress<S>(&self, mesh: &Mesh<'_, S>, pass: Pass<'_>, done: usize) {
        if let Some(progress) = self.progress {
            let count = mesh.triangles.len();
            let before = if matches!(pass, Pass::Turns) {
                0
            } else {
                count
            };
            progress(before + done.min(count), 2 * count);
        }
    }
}

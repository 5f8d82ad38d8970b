//! The verifier with its options, and its checks in their order.

use alloc::vec::Vec;
use core::fmt;

#[cfg(feature = "parallel")]
use super::chunks::Parallel;
use super::chunks::{Progress, Schedule, Serial};
use super::depth::MEASURED;
use super::input::{self, Ranked};
use super::regions::{self, Regions};
use super::report::{Level, Record, Report, Violations};
use super::runs::Run;
use super::{boundary, delaunay, edges, sides, turns};
use crate::scalar::Scalar;

/// The verifier with options.
///
/// ```
/// use sweep_cdt::verify::Verifier;
///
/// let points = [[0.0, 0.0], [3.0, 0.0], [0.0, 3.0], [1.0, 1.0]];
/// let clockwise = [[0, 3, 1], [1, 3, 2], [2, 3, 0]];
/// let verifier = Verifier::new().accept_clockwise(true);
/// assert!(verifier.verify(&points, &[], &clockwise)?.clockwise);
/// # Ok::<(), sweep_cdt::verify::Violations>(())
/// ```
#[derive(Clone, Copy)]
pub struct Verifier<'a> {
    clockwise: bool,
    boundary: Option<&'a [Vec<usize>]>,
    level: Level,
    added_from: Option<usize>,
    regions: Option<Regions<'a>>,
    limit: usize,
    measured: usize,
    progress: Option<&'a (dyn Fn(usize, usize) + Sync)>,
}

impl fmt::Debug for Verifier<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Verifier")
            .field("clockwise", &self.clockwise)
            .field("boundary", &self.boundary)
            .field("level", &self.level)
            .field("added_from", &self.added_from)
            .field("regions", &self.regions)
            .field("limit", &self.limit)
            .field("measured", &self.measured)
            .finish_non_exhaustive()
    }
}

impl Default for Verifier<'_> {
    fn default() -> Self {
        Verifier::new()
    }
}

impl<'a> Verifier<'a> {
    /// A verifier of counter-clockwise triangles that fill the hull, to [`Level::Delaunay`], listing 100 violations.
    #[must_use]
    pub fn new() -> Verifier<'a> {
        Verifier {
            clockwise: false,
            boundary: None,
            level: Level::Delaunay,
            added_from: None,
            regions: None,
            limit: 100,
            measured: MEASURED,
            progress: None,
        }
    }

    /// Whether all triangles may be clockwise. If the triangles run both ways, the smaller group is wrong; of two groups of
    /// one size, the group without the first triangle.
    #[must_use]
    pub fn accept_clockwise(self, clockwise: bool) -> Self {
        Verifier { clockwise, ..self }
    }

    /// Declares the domain that the triangles must fill, in place of the convex hull, by the closed chains of vertices
    /// that bound it, each without its first vertex at the end. Chains may run either way: the domain is what a path
    /// from outside enters by crossing an odd number of their sides.
    ///
    /// The boundary must then have exactly the sides of the chains, each once, and sides must not cross. (They may meet
    /// in vertices.) Points outside the domain may be unused, Euler's formula is not checked, and edges must lie in the
    /// domain. Cost: O((n + m) log m) for n points and m sides.
    #[must_use]
    pub fn boundary(self, chains: &'a [Vec<usize>]) -> Self {
        Verifier {
            boundary: Some(chains),
            ..self
        }
    }

    /// Allows points that the input lacks (*Steiner points*), as programs add them that make good triangles: all from
    /// this index on. Added points that equal a point of the input stand for it.
    ///
    /// Added points need not be corners. Corners must lie in the hull of the points before this index, or in the
    /// declared domain. Points on edges and declared sides may split them; points beside them, as rounding leaves them,
    /// are violations with a [depth](super::Depth). Triangles must be Delaunay with added points in view too. [`Report`] has the number of added points, and of edges that they split.
    ///
    /// ```
    /// use sweep_cdt::verify::Verifier;
    ///
    /// // The centre of a square is added, on its diagonal.
    /// let points = [[0, 0], [2, 0], [2, 2], [0, 2], [1, 1]];
    /// let triangles = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
    /// let report = Verifier::new().added_from(4).verify(&points, &[[0, 2]], &triangles)?;
    /// assert_eq!((report.points, report.added_points, report.split_edges), (4, 1, 1));
    /// # Ok::<(), sweep_cdt::verify::Violations>(())
    /// ```
    #[must_use]
    pub fn added_from(self, added_from: usize) -> Self {
        Verifier {
            added_from: Some(added_from),
            ..self
        }
    }

    /// Verifies the attributes of triangles: each triangle must have the attribute of the region that it lies in.
    /// `attributes` has one for each triangle, `seeds` for each region the triangle in which its seed lies and its
    /// attribute; of several in a face the last counts, as for Triangle. This check is part of [`Level::Constrained`],
    /// and is made where the triangles reach it otherwise.
    ///
    /// ```
    /// use sweep_cdt::verify::Verifier;
    ///
    /// // A square is cut in two. The triangle at the right has the attribute 7, the other none.
    /// let points = [[0, 0], [2, 0], [2, 2], [0, 2]];
    /// let triangles = [[0, 1, 2], [0, 2, 3]];
    /// let verifier = Verifier::new().regions(&[7.0, 0.0], &[(0, 7.0)]);
    /// assert!(verifier.verify(&points, &[[0, 2]], &triangles).is_ok());
    /// // Without the edge both lie in one face.
    /// assert!(verifier.verify(&points, &[], &triangles).is_err());
    /// ```
    #[must_use]
    pub fn regions(self, attributes: &'a [f64], seeds: &'a [(usize, f64)]) -> Self {
        Verifier {
            regions: Some((attributes, seeds)),
            ..self
        }
    }

    /// The level that the triangles must reach. Violations of higher levels are neither listed nor counted.
    #[must_use]
    pub fn level(self, level: Level) -> Self {
        Verifier { level, ..self }
    }

    /// How many violations are listed at most; all are counted.
    #[must_use]
    pub fn limit(self, limit: usize) -> Self {
        Verifier { limit, ..self }
    }

    /// Whether every [depth](super::Depth) is measured, however many violations there are. By default the
    /// verifier measures the first 1000 wrong sides in each 16384 triangles, and wrong turns if there are at most 1000.
    #[must_use]
    pub fn all_depths(self, all: bool) -> Self {
        let measured = if all { usize::MAX } else { MEASURED };
        Verifier { measured, ..self }
    }

    /// Calls `progress(done, total)` at intervals, from any thread.
    #[must_use]
    pub fn progress(self, progress: &'a (dyn Fn(usize, usize) + Sync)) -> Self {
        Verifier {
            progress: Some(progress),
            ..self
        }
    }

    /// Verifies on one thread.
    ///
    /// # Errors
    /// [`Violations`], if `triangles` does not reach the level asked for, by default [`Level::Delaunay`].
    pub fn verify<S: Scalar>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        triangles: &[[usize; 3]],
    ) -> Result<Report, Violations> {
        self.check::<S, Serial>(points, edges, triangles)
    }

    /// Verifies on all threads of the current rayon pool, or on one where none can be started, with the same answer.
    ///
    /// # Errors
    /// [`Violations`], if `triangles` does not reach the level asked for, by default [`Level::Delaunay`].
    #[cfg(feature = "parallel")]
    #[cfg_attr(docsrs, doc(cfg(feature = "parallel")))]
    pub fn verify_parallel<S: Scalar + Sync>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        triangles: &[[usize; 3]],
    ) -> Result<Report, Violations> {
        self.check::<S, Parallel>(points, edges, triangles)
    }

    /// The checks, in the order of the table of the parent module.
    fn check<S: Scalar, C: Schedule<S>>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        triangles: &[[usize; 3]],
    ) -> Result<Report, Violations> {
        let mut record = Record::new(self.limit, self.measured, self.level);
        let progress = Progress::new(self.progress, triangles.len());

        let ranked = input::read(
            points,
            edges,
            triangles,
            self.boundary,
            self.added_from.unwrap_or(usize::MAX),
            &mut record,
        );
        let Some(ranked) = ranked else {
            return record.answer();
        };
        let Ranked {
            mut soup,
            edges,
            mut domain,
            used,
        } = ranked;
        turns::check::<S, C>(&mut soup, self.clockwise, &progress, &mut record);
        let mut sides = sides::check(&soup, &mut record);
        if let Some(domain) = &mut domain {
            domain.orient(&soup, &sides.boundary);
        }
        let domain = domain.as_ref();
        let runs = boundary::check(&soup, &sides, domain, &mut record);
        let is_bent = runs.iter().any(Run::is_bent);
        let bent_sides = is_bent.then_some(&*sides.boundary);
        boundary::check_points(&soup, used, domain, bent_sides, &mut record);
        boundary::check_count(used, domain, &mut record);
        edges::check(&soup, &mut sides, &edges, &runs, &mut record);
        delaunay::check::<S, C>(&soup, &sides, &progress, &mut record);
        if let Some(regions) = self.regions {
            regions::check(&soup, &sides, regions, &mut record);
        }
        record.answer()
    }
}

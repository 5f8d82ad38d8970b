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
use super::{boundary, delaunay, edges, sides, turns};
use crate::scalar::Measure;

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
    /// Counter-clockwise triangles, the hull as the boundary, [`Level::Delaunay`], 100 violations listed.
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

    /// Whether the triangles may be clockwise, all of them.
    #[must_use]
    pub fn accept_clockwise(self, clockwise: bool) -> Self {
        Verifier { clockwise, ..self }
    }

    /// Declares the domain that the triangles must fill, in place of the convex hull, by the closed chains
    /// of vertices that bound it, each without its first vertex at the end. They may run either way: the domain
    /// is what a path from outside enters by crossing an odd number of their sides.
    ///
    /// The boundary must then have exactly their sides, each once, and sides must not cross. (They may meet in
    /// vertices.) Points outside the domain may be unused, Euler's formula is not checked, and
    /// edges must lie in the domain. That takes O((n + m) log m) time for n points and m sides.
    #[must_use]
    pub fn boundary(self, chains: &'a [Vec<usize>]) -> Self {
        Verifier {
            boundary: Some(chains),
            ..self
        }
    }

    /// Allows points that the input lacks (*Steiner points*), as programs add them that make good triangles: all from
    /// this index on. Those that equal a point of the input stand for it.
    ///
    /// Added points need not be corners. Corners must lie in the hull of the points before this index, or in the
    /// declared domain. Edges and declared sides may be split by points exactly on them, and triangles must be
    /// Delaunay with added points in view too. [`Report`] has the number of these points, and of edges that they split.
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

    /// Attributes of triangles, each of which must be that of the region that the triangle lies in. They are verified
    /// where the triangles reach [`Level::Constrained`], and are a part of it.
    ///
    /// ```
    /// use sweep_cdt::verify::{Regions, Verifier};
    ///
    /// // A square is cut in two. The triangle at the right has the attribute 7, the other none.
    /// let points = [[0, 0], [2, 0], [2, 2], [0, 2]];
    /// let triangles = [[0, 1, 2], [0, 2, 3]];
    /// let regions = Regions { attributes: &[7.0, 0.0], seeds: &[(0, 7.0)] };
    /// assert!(Verifier::new().regions(regions).verify(&points, &[[0, 2]], &triangles).is_ok());
    /// // Without the edge both lie in one face.
    /// assert!(Verifier::new().regions(regions).verify(&points, &[], &triangles).is_err());
    /// ```
    #[must_use]
    pub fn regions(self, regions: Regions<'a>) -> Self {
        Verifier {
            regions: Some(regions),
            ..self
        }
    }

    /// What the triangles must reach. Violations of higher levels are neither listed nor counted.
    #[must_use]
    pub fn level(self, level: Level) -> Self {
        Verifier { level, ..self }
    }

    /// How many violations are listed at most; all are counted.
    #[must_use]
    pub fn limit(self, limit: usize) -> Self {
        Verifier { limit, ..self }
    }

    /// Whether every [depth](super::Depth) is measured, however many violations there are. By default that are the
    /// first 1000 in each 16384 triangles, and of the boundary, if it has no more.
    #[must_use]
    pub fn all_depths(self, all: bool) -> Self {
        let measured = if all { usize::MAX } else { MEASURED };
        Verifier { measured, ..self }
    }

    /// Called as `progress(done, total)`, at intervals, from any thread.
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
    /// [`Violations`], if `triangles` does not reach the level asked for: by default, if it is not a constrained
    /// Delaunay triangulation of `points` with `edges`.
    pub fn verify<S: Measure>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        triangles: &[[usize; 3]],
    ) -> Result<Report, Violations> {
        self.check::<S, Serial>(points, edges, triangles)
    }

    /// Verifies on all threads of the current rayon pool, or on one where no threads can be started. The
    /// answer is the same.
    ///
    /// # Errors
    /// [`Violations`], if `triangles` does not reach the level asked for: by default, if it is not a constrained
    /// Delaunay triangulation of `points` with `edges`.
    #[cfg(feature = "parallel")]
    #[cfg_attr(docsrs, doc(cfg(feature = "parallel")))]
    pub fn verify_parallel<S: Measure + Sync>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        triangles: &[[usize; 3]],
    ) -> Result<Report, Violations> {
        self.check::<S, Parallel>(points, edges, triangles)
    }

    /// The checks, numbered as in the documentation of the module.
    fn check<S: Measure, C: Schedule<S>>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        triangles: &[[usize; 3]],
    ) -> Result<Report, Violations> {
        let mut record = Record::new(self.limit, self.measured, self.level);
        let progress = Progress::new(self.progress, triangles.len());

        // 1. Coordinates and indices.
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
        // 2. Every triangle turns left.
        if self.clockwise {
            turns::reverse_if_clockwise(&mut soup, &mut record);
        }
        turns::check::<S, C>(&mut soup, &progress, &mut record);
        // 3. Every directed side occurs once.
        let mut sides = sides::check(&soup, &mut record);
        // 4. The boundary is convex and goes round once, or it is the declared one.
        if let Some(domain) = &mut domain {
            domain.orient(&soup, &sides.boundary);
        }
        let domain = domain.as_ref();
        boundary::check(&soup, &sides, domain, &mut record);
        // 5. Every point is a corner.
        boundary::check_points(&soup, used, domain, &mut record);
        // 6. The number of triangles is Euler's.
        boundary::check_count(used, domain, &mut record);
        // 7. Every edge is a chain of sides, which are then fixed.
        edges::check(&soup, &mut sides, &edges, &mut record);
        // 8. Every free side is locally Delaunay.
        delaunay::check::<S, C>(&soup, &sides, &progress, &mut record);
        // 9. Every triangle has the attribute of its region.
        if let Some(regions) = self.regions {
            regions::check(&soup, &sides, regions, &mut record);
        }
        record.answer()
    }
}

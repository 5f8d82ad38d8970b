//! Many inputs, one after the other, in the same memory.

use alloc::vec::Vec;
use core::fmt;

use crate::error::Error;
use crate::interior::{FillRule, InteriorError};
use crate::scalar::Scalar;
use crate::settings::{Algorithm, Settings, Ties};
use crate::sweep::{self, PolygonScratch, Scratch};
use crate::triangulation::Triangulation;
use crate::watch::Watch;

/// Triangulates one input after the other, and keeps its memory from each to the next.
///
/// [`Triangulator::session`](crate::Triangulator::session) makes a session; its results are those of
/// [`Triangulator::triangulate`](crate::Triangulator::triangulate). Once the memory is as large as the inputs need, a
/// call allocates next to nothing. That saves a sixth of the instructions for a polygon of ten points, and a fifth of
/// the time for a million points, whose pages the system need not clear again. A session keeps what the largest input
/// needed, about 100 bytes a point, until it is dropped. It is `Send`: make one for each thread, with `rayon` by
/// `inputs.par_iter().map_init(|| Triangulator::new().session(), |session, input| ...)`.
///
/// ```
/// let mut session = sweep_cdt::Triangulator::new().session();
/// let mut triangles = 0;
/// for corners in 3..10 {
///     let polygon: Vec<_> = (0..corners).map(|i| [i, i * i]).collect();
///     let boundary: Vec<_> = (0..corners as usize).map(|i| [i, (i + 1) % polygon.len()]).collect();
///     triangles += session.triangulate(&polygon, &boundary)?.len();
/// }
/// assert_eq!(triangles, 1 + 2 + 3 + 4 + 5 + 6 + 7);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
pub struct Session {
    settings: Settings,
    scratch: Scratch,
    result: Option<Triangulation>,
    polygon: PolygonScratch,
}

impl Session {
    pub(crate) fn new(settings: Settings) -> Self {
        Session {
            settings,
            scratch: Scratch::kept(),
            result: None,
            polygon: PolygonScratch::default(),
        }
    }

    /// The constrained Delaunay triangulation of `points` with `edges`. The next call overwrites it; clone it to keep.
    ///
    /// # Errors
    /// See [`Error`]. The session keeps its memory then, too.
    pub fn triangulate<S: Scalar>(
        &mut self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
    ) -> Result<&Triangulation, Error> {
        self.run(points, edges, Watch::new())
    }

    /// [`triangulate`](Session::triangulate), watched as [`Triangulator::run`](crate::Triangulator::run) is.
    ///
    /// # Errors
    /// See [`Error`].
    pub fn run<S: Scalar>(
        &mut self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        watch: Watch<'_>,
    ) -> Result<&Triangulation, Error> {
        if let Some(result) = self.result.take() {
            self.scratch.recycle(result);
        }
        let result = sweep::run(points, edges, self.settings, watch, &mut self.scratch)?;
        Ok(self.result.insert(result))
    }

    /// The rule for vertices on one circle in later calls. For the windows of streams, in the package `sweep-cdt-stream`.
    #[doc(hidden)]
    pub fn set_ties(&mut self, ties: Ties) {
        self.settings.ties = ties;
    }

    /// [`triangulate_inside`](crate::triangulate_inside) in the memory of the session. The next call overwrites the
    /// triangles. [`Algorithm::Auto`] alone triangulates nothing but the inside.
    ///
    /// # Errors
    /// [`InteriorError`]. [`InteriorError::Refused`] holds the error of [`triangulate`](Session::triangulate).
    pub fn triangulate_inside<S: Scalar>(
        &mut self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        rule: FillRule,
    ) -> Result<&[[usize; 3]], InteriorError> {
        if let Some(result) = self.result.take() {
            self.scratch.recycle(result);
        }
        let directed = match rule {
            _ if self.settings.algorithm != Algorithm::Auto => None,
            FillRule::EvenOdd => Some(false),
            FillRule::NonZero => Some(true),
            _ => None,
        };
        let (scratch, polygon) = (&mut self.scratch, &mut self.polygon);
        let is_done = directed.is_some_and(|directed| {
            sweep::triangulate_rings(points, edges, directed, scratch, polygon)
        });
        if !is_done {
            let result = self.triangulate(points, edges)?;
            let list = result.interior(rule)?.canonical_triangles();
            self.polygon.triangles = list;
        }
        Ok(&self.polygon.triangles)
    }

    pub(crate) fn into_inside(self) -> Vec<[usize; 3]> {
        self.polygon.triangles
    }
}

impl fmt::Debug for Session {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Session")
            .field("settings", &self.settings)
            .finish_non_exhaustive()
    }
}

//! Refinement to bounds on angles, areas and sides: points are added until no triangle inside breaks a bound.
//!
//! The method is Delaunay refinement (Ruppert 1995) with lenses (Chew 1993), off-centers (Üngör 2004), and shells around sharp
//! corners of the input (Ruppert 1995; Miller, Pav and Walkington 2003). Points come in **rounds**: first the parts of
//! edges that are encroached are split, then triangles that break a bound get a new vertex each, as long as no two of
//! their regions share a triangle. Small angles come before large areas, those of short sides first (as in Shewchuk's
//! Triangle), then the largest. So a round does what single insertions would do, in one batch of edits.
//!
//! ```text
//!        r                     The new vertex x of the triangle p q r lies on the bisector of its shortest side, at
//!       /  '-.                 the centre of its circle, or nearer, where x sees p q at the angle asked for. If an edge
//!      /   x  '-.              lies in between, or sees x at more than 180 degrees less twice that angle, the part of
//!     p----------q             the edge is split instead. Vertices of ours in the circle over it go first.
//! ```
//!
//! **Why it is right.** All triangles come from edits, so a fresh run on the points and parts makes the same ones. A split
//! point of doubles is rounded, and bends its edge: it is taken only if it lies in a triangle at the part, or outside
//! beside it, so that no vertex changes sides. Each part knows what is inside on its two sides, and new triangles learn it
//! from there. Exact signs decide the bounds; the places of new points need not be exact. Ruppert and Miller, Pav and
//! Walkington prove that such a refinement ends up to some 20 degrees; in practice it ends up to 33, and
//! [`most_points`](Refinement::most_points) ends it always.
//!
//! **Cost.** A round costs its edits, and a sort of the triangles that wait.

mod candidate;
mod labels;
mod parts;
mod refined;
mod rounds;
mod work;

use std::fmt;

use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::Interior;

use crate::bounds::{Bounds, BoundsError, Broken};
use crate::error::EditError;
use work::Work;

/// How a triangulation is refined.
///
/// ```
/// use sweep_cdt_edit::{Bounds, Refinement};
///
/// let points = [[0.0, 0.0], [9.0, 0.0], [9.0, 1.0], [0.0, 6.0]];
/// let edges = [[0, 1], [1, 2], [2, 3], [3, 0]];
/// let result = sweep_cdt::triangulate(&points, &edges)?;
/// let inside = result.interior(sweep_cdt::interior::FillRule::EvenOdd)?;
///
/// let bounds = Bounds { least_angle: Some(28.0), greatest_area: Some(2.0), ..Bounds::default() };
/// let mesh = Refinement::new(bounds).run(&points, &edges, &inside)?;
/// assert!(mesh.left.is_empty() && mesh.points.starts_with(&points));
/// assert!(bounds.violations(&mesh.points, &mesh.triangles)?.is_empty());
/// // The parts of the second edge, from its first end to its second.
/// let second = mesh.edges.iter().zip(&mesh.edge_of).filter(|(_, edge)| **edge == Some(1));
/// assert_eq!(second.clone().next().expect("a part").0[0], 1);
/// assert_eq!(second.last().expect("a part").0[1], 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
pub struct Refinement<'a> {
    bounds: Bounds,
    region_areas: &'a [f64],
    area_at: Option<&'a dyn Fn([f64; 2]) -> f64>,
    most_points: Option<usize>,
    keeps_boundary: bool,
    progress: Option<&'a dyn Fn(usize, usize)>,
}

impl fmt::Debug for Refinement<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Refinement")
            .field("bounds", &self.bounds)
            .finish_non_exhaustive()
    }
}

impl<'a> Refinement<'a> {
    /// Refines until these bounds hold.
    pub fn new(bounds: Bounds) -> Refinement<'a> {
        Refinement {
            bounds,
            region_areas: &[],
            area_at: None,
            most_points: None,
            keeps_boundary: false,
            progress: None,
        }
    }

    /// The greatest area for triangles of each region, by its number in the interior.
    #[must_use]
    pub fn region_areas(mut self, areas: &'a [f64]) -> Self {
        self.region_areas = areas;
        self
    }

    /// The greatest area for a triangle with this centroid. Where it is not above 0, no area is too great.
    #[must_use]
    pub fn area_at(mut self, area: &'a dyn Fn([f64; 2]) -> f64) -> Self {
        self.area_at = Some(area);
        self
    }

    /// Ends with so many points, those of the input among them. Triangles that break bounds then are listed.
    #[must_use]
    pub fn most_points(mut self, most: usize) -> Self {
        self.most_points = Some(most);
        self
    }

    /// Keeps the sides between inside and outside whole.
    #[must_use]
    pub fn keep_boundary(mut self) -> Self {
        self.keeps_boundary = true;
        self
    }

    /// Calls `progress` after each round, with the number of points, and of triangles that wait.
    #[must_use]
    pub fn progress(mut self, progress: &'a dyn Fn(usize, usize)) -> Self {
        self.progress = Some(progress);
        self
    }

    /// Refines what is inside: `inside` is an interior of the triangulation of these points and edges.
    ///
    /// # Errors
    /// [`RefineError`], before anything is done.
    pub fn run<S: Exact>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        inside: &Interior<'_>,
    ) -> Result<Refined<S>, RefineError> {
        self.bounds.check()?;
        if !self.region_areas.iter().all(|&area| area > 0.0) {
            return Err(BoundsError::Size.into());
        }
        let least = self.bounds.least_angle.unwrap_or(0.0);
        if least > SURE_ANGLE && self.most_points.is_none() {
            return Err(RefineError::Endless);
        }
        Work::new(self, points, edges, inside)?.run()
    }
}

/// Above this angle, in degrees, nothing says that refinement ends.
const SURE_ANGLE: f64 = 34.0;

/// A mesh that was refined.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Refined<S> {
    /// The points of the input, and then those that were added.
    pub points: Vec<[S; 2]>,
    /// The parts of the edges of the input, edge after edge, each from its first end to its second. Then the sides of
    /// the hull that bound the inside and are no edges. [`sweep_cdt::triangulate`] makes this mesh of these points and edges.
    pub edges: Vec<[usize; 2]>,
    /// For each part the edge of the input.
    pub edge_of: Vec<Option<usize>>,
    /// The triangles inside, each from its lowest vertex, sorted.
    pub triangles: Vec<[usize; 3]>,
    /// For each triangle its region in the interior.
    pub regions: Vec<Option<usize>>,
    /// The triangles that break a bound still, by position.
    pub left: Vec<Left>,
}

/// A triangle that breaks a bound, and why it stayed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub struct Left {
    /// The position of the triangle in [`Refined::triangles`].
    pub triangle: usize,
    /// The bound that it breaks.
    pub bound: Broken,
    /// Why it stayed.
    pub reason: Reason,
}

/// Why a triangle that breaks a bound stayed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Reason {
    /// The triangle lies in or at a sharp corner of the input.
    InputAngle,
    /// The side that would have to be split bounds the inside, and is kept.
    Boundary,
    /// The numbers have no point in between.
    Rounding,
    /// There are as many points as were allowed.
    Limit,
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Reason::InputAngle => "a sharp corner of the input",
            Reason::Boundary => "the boundary is kept",
            Reason::Rounding => "no number lies in between",
            Reason::Limit => "the limit of points",
        })
    }
}

/// Why a refinement is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RefineError {
    /// The bounds are none.
    Bounds(BoundsError),
    /// The least angle is above 34 degrees, and there is no limit of points: it need not end.
    Endless,
    /// The interior is not one of the triangulation of these points and edges.
    OtherInput,
    /// An edit was refused.
    Edit(EditError),
}

impl fmt::Display for RefineError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RefineError::Bounds(error) => error.fmt(f),
            RefineError::Endless => {
                f.write_str("a least angle above 34 degrees may need points without end: give a limit of points")
            }
            RefineError::OtherInput => f.write_str("the interior is not one of these points and edges"),
            RefineError::Edit(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for RefineError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            RefineError::Bounds(error) => Some(error),
            RefineError::Edit(error) => Some(error),
            _ => None,
        }
    }
}

impl From<BoundsError> for RefineError {
    fn from(error: BoundsError) -> RefineError {
        RefineError::Bounds(error)
    }
}

impl From<EditError> for RefineError {
    fn from(error: EditError) -> RefineError {
        RefineError::Edit(error)
    }
}

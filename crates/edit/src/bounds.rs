//! Bounds on the triangles of a mesh, and which triangles break them, by exact signs.
//!
//! An angle at corner `c` of a triangle `a`, `b`, `c` is less than a bound of at most 60 degrees where
//! `(a - c) . (b - c)` is positive and its square greater than `|a - c|² |b - c|² C`; `C` is the double nearest to the
//! squared cosine of the bound, and counts as what it is. Areas and sides are compared as twice the area and as squares.
//! So every test is the sign of a polynomial of degree four at most, which fractions decide.
//!
//! **Cost.** [`crate::measure`] compares.

use std::fmt;

use sweep_cdt::crossings::Exact;

use crate::measure::{compare_area, compare_side, has_angle_below, squared_cosine};

/// Bounds on the triangles of a mesh. A bound that is `None` holds always.
///
/// ```
/// use sweep_cdt_edit::{Bounds, Broken};
///
/// let bounds = Bounds { least_angle: Some(30.0), greatest_side: Some(2.0), ..Bounds::default() };
/// let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.5], [2.0, 3.0]];
/// let triangles = [[0, 1, 2], [0, 2, 3]];
/// assert_eq!(bounds.violations(&points, &triangles)?, [(1, Broken::Angle)]);
/// # Ok::<(), sweep_cdt_edit::BoundsError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Bounds {
    /// The least angle in degrees, from 0 to 60. The double nearest to its squared cosine is compared exactly.
    pub least_angle: Option<f64>,
    /// The greatest area of a triangle.
    pub greatest_area: Option<f64>,
    /// The greatest length of a side.
    pub greatest_side: Option<f64>,
}

/// The bound that a triangle breaks; of several the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Broken {
    /// An angle is less than the least.
    Angle,
    /// The area is greater than the greatest.
    Area,
    /// A side is longer than the longest.
    Side,
}

/// Why bounds are not compared with triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BoundsError {
    /// The least angle is not from 0 to 60 degrees, without 60.
    Angle,
    /// A greatest area or side is not above 0.
    Size,
    /// A triangle names a point that does not exist.
    NoPoint {
        /// The triangle, by position.
        triangle: usize,
        /// The number of the point.
        point: usize,
    },
    /// A coordinate of a triangle's corner is NaN or infinite.
    NonFiniteCoordinate {
        /// The number of the point.
        point: usize,
    },
}

impl fmt::Display for BoundsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BoundsError::Angle => {
                f.write_str("the least angle must be at least 0 and below 60 degrees")
            }
            BoundsError::Size => f.write_str("the greatest area and side must be above 0"),
            BoundsError::NoPoint { triangle, point } => {
                write!(
                    f,
                    "triangle {triangle} names point {point}, which does not exist"
                )
            }
            BoundsError::NonFiniteCoordinate { point } => {
                write!(f, "a coordinate of point {point} is not finite")
            }
        }
    }
}

impl std::error::Error for BoundsError {}

impl Bounds {
    /// Refuses bounds that no mesh can be compared with.
    pub(crate) fn check(&self) -> Result<(), BoundsError> {
        let sizes = [self.greatest_area, self.greatest_side];
        if !self
            .least_angle
            .is_none_or(|angle| (0.0..60.0).contains(&angle))
        {
            return Err(BoundsError::Angle);
        }
        let are_above = sizes.into_iter().flatten().all(|size| size > 0.0);
        are_above.then_some(()).ok_or(BoundsError::Size)
    }

    /// The first bound that a triangle of finite corners breaks.
    pub(crate) fn broken<S: Exact>(&self, corners: [&[S; 2]; 3]) -> Option<Broken> {
        if self
            .least_angle
            .is_some_and(|least| has_angle_below(corners, squared_cosine(least)))
        {
            return Some(Broken::Angle);
        }
        if self
            .greatest_area
            .is_some_and(|most| compare_area(corners, most).is_gt())
        {
            return Some(Broken::Area);
        }
        let sides = [0, 1, 2].map(|k| [corners[k], corners[(k + 1) % 3]]);
        let is_long = |most: f64| sides.iter().any(|&side| compare_side(side, most).is_gt());
        self.greatest_side
            .is_some_and(is_long)
            .then_some(Broken::Side)
    }

    /// The triangles that break a bound, with the first one that each breaks. Any program may have made them, in any
    /// direction.
    ///
    /// # Errors
    /// [`BoundsError`].
    pub fn violations<S: Exact>(
        &self,
        points: &[[S; 2]],
        triangles: &[[usize; 3]],
    ) -> Result<Vec<(usize, Broken)>, BoundsError> {
        self.check()?;
        let mut found = Vec::new();
        for (triangle, &corners) in triangles.iter().enumerate() {
            for point in corners {
                let place = points
                    .get(point)
                    .ok_or(BoundsError::NoPoint { triangle, point })?;
                if !place.iter().all(S::is_finite) {
                    return Err(BoundsError::NonFiniteCoordinate { point });
                }
            }
            let broken = self.broken(corners.map(|v| &points[v]));
            found.extend(broken.map(|broken| (triangle, broken)));
        }
        Ok(found)
    }
}

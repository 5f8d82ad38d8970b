//! Bounds on the triangles of a mesh, and which triangles break them, by exact signs.
//!
//! An angle at corner `c` of a triangle `a`, `b`, `c` is less than a bound of at most 60 degrees where
//! `(a - c) . (b - c)` is positive and its square greater than `|a - c|² |b - c|² C`; `C` is the double nearest to the
//! squared cosine of the bound, and counts as what it is. Areas and sides are compared as twice the area and as squares.
//! So every test is the sign of a polynomial of degree four at most, which fractions decide.
//!
//! **Cost.** Doubles decide where their rounding cannot matter: each polynomial is a sum of products of differences, all
//! of which are right to `u = 2^-53`. An angle's two sides have 9 and 10 such factors, so that 32 `u` times the larger
//! bound on them is more than the error of their difference, if nothing underflows. Fractions decide the rest.

use std::cmp::Ordering;
use std::fmt;

use num_rational::BigRational;
use sweep_cdt::crossings::Exact;

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
        let turned = |k: usize| [0, 1, 2].map(|i| corners[(k + i) % 3]);
        if let Some(least) = self.least_angle
            && let cosine = squared_cosine(least)
            && (0..3).any(|k| has_less_than(turned(k), cosine))
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

/// The double nearest to the squared cosine of an angle in degrees.
pub(crate) fn squared_cosine(degrees: f64) -> f64 {
    // (1 + cos 2x) / 2 is exact at 0, 30, 45 and 60 degrees but for the cosine.
    f64::midpoint(1.0, (2.0 * degrees).to_radians().cos())
}

/// The point as doubles, if it is one.
pub(crate) fn doubles<S: Exact>(point: &[S; 2]) -> Option<[f64; 2]> {
    let double = |x: &S| {
        S::nearest_of_double(x.approx())
            .filter(|y| y.compare(x).is_eq())
            .map(|_| x.approx())
    };
    Some([double(&point[0])?, double(&point[1])?])
}

/// From `c` to `a` and to `b`: the scalar product, the sum of the sizes of its terms, and both squared lengths.
fn spread([a, b, c]: [[f64; 2]; 3]) -> [f64; 4] {
    let ([px, py], [qx, qy]) = ([a[0] - c[0], a[1] - c[1]], [b[0] - c[0], b[1] - c[1]]);
    let (x, y) = (px * qx, py * qy);
    [
        x + y,
        x.abs() + y.abs(),
        px * px + py * py,
        qx * qx + qy * qy,
    ]
}

/// So small that 32 u times the bound is more than all errors, and so large that nothing underflows.
const ERROR: f64 = 32.0 * (f64::EPSILON / 2.0);
const NORMAL: std::ops::Range<f64> = 1e-140..1e140;

fn fractions<S: Exact, const N: usize>(points: [&[S; 2]; N]) -> [[BigRational; 2]; N] {
    points.map(|[x, y]| [x.to_fraction(), y.to_fraction()])
}

fn exact_spread([a, b, c]: [[BigRational; 2]; 3]) -> [BigRational; 3] {
    let to = |p: &[BigRational; 2]| [&p[0] - &c[0], &p[1] - &c[1]];
    let (p, q) = (to(&a), to(&b));
    let product = |p: &[BigRational; 2], q: &[BigRational; 2]| &p[0] * &q[0] + &p[1] * &q[1];
    [product(&p, &q), product(&p, &p), product(&q, &q)]
}

fn fraction(x: f64) -> BigRational {
    BigRational::from_float(x).expect("bounds are finite where they are compared")
}

/// The sign of the scalar product from `c` to `a` and `b`: `Less`, if the angle at `c` is obtuse.
pub(crate) fn scalar_product<S: Exact>([a, b, c]: [&[S; 2]; 3]) -> Ordering {
    if let (Some(p), Some(q), Some(r)) = (doubles(a), doubles(b), doubles(c)) {
        let [sum, sizes, ..] = spread([p, q, r]);
        if sum.abs() > ERROR * sizes && NORMAL.contains(&sizes) {
            return sum.total_cmp(&0.0);
        }
    }
    let [sum, ..] = exact_spread(fractions([a, b, c]));
    sum.cmp(&BigRational::from_integer(0.into()))
}

/// The order of the squared cosine of the angle at `c`, and a squared cosine.
pub(crate) fn compare_angle<S: Exact>([a, b, c]: [&[S; 2]; 3], cosine: f64) -> Ordering {
    if let (Some(p), Some(q), Some(r)) = (doubles(a), doubles(b), doubles(c)) {
        let [sum, _, pp, qq] = spread([p, q, r]);
        let (left, both) = (sum * sum, pp * qq);
        let difference = left - cosine * both;
        if difference.abs() > ERROR * both && NORMAL.contains(&pp) && NORMAL.contains(&qq) {
            return difference.total_cmp(&0.0);
        }
    }
    let [sum, pp, qq] = exact_spread(fractions([a, b, c]));
    (&sum * &sum).cmp(&(pp * qq * fraction(cosine)))
}

/// Whether the angle at the last corner is less than the one with this squared cosine.
fn has_less_than<S: Exact>(corners: [&[S; 2]; 3], cosine: f64) -> bool {
    compare_angle(corners, cosine).is_gt() && scalar_product(corners).is_gt()
}

/// The order of the area of a triangle and another one.
fn compare_area<S: Exact>([a, b, c]: [&[S; 2]; 3], most: f64) -> Ordering {
    if most.is_infinite() {
        return Ordering::Less;
    }
    if let (Some(p), Some(q), Some(r)) = (doubles(a), doubles(b), doubles(c)) {
        let (x, y) = ((p[0] - r[0]) * (q[1] - r[1]), (p[1] - r[1]) * (q[0] - r[0]));
        let (area, sizes) = ((x - y).abs(), x.abs() + y.abs() + 2.0 * most);
        let difference = area - 2.0 * most;
        if difference.abs() > ERROR * sizes && NORMAL.contains(&sizes) {
            return difference.total_cmp(&0.0);
        }
    }
    let [a, b, c] = fractions([a, b, c]);
    let area = (&a[0] - &c[0]) * (&b[1] - &c[1]) - (&a[1] - &c[1]) * (&b[0] - &c[0]);
    let area = if area < BigRational::from_integer(0.into()) {
        -area
    } else {
        area
    };
    area.cmp(&(fraction(most) * fraction(2.0)))
}

/// The order of the length of a side and another one.
pub(crate) fn compare_side<S: Exact>([a, b]: [&[S; 2]; 2], most: f64) -> Ordering {
    if most.is_infinite() {
        return Ordering::Less;
    }
    if let (Some(p), Some(q)) = (doubles(a), doubles(b)) {
        let [_, _, square, _] = spread([p, p, q]);
        let difference = square - most * most;
        let sizes = square + most * most;
        if difference.abs() > ERROR * sizes && NORMAL.contains(&sizes) {
            return difference.total_cmp(&0.0);
        }
    }
    let [_, square, _] = exact_spread(fractions([a, a, b]));
    square.cmp(&(fraction(most) * fraction(most)))
}

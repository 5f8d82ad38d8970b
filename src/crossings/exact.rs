//! Coordinates as fractions, and back; the point where two lines meet.
//!
//! Why it is right: every finite double is a fraction whose denominator is a power of two. The point where two lines
//! meet is computed in whole numbers, over one denominator for all four points, and reduced at the end. A fraction is
//! rounded to the nearest double, and of two that are equally near to the one whose last bit is zero (`num-rational`),
//! subnormal ones included. So rounding is monotone, and a fraction that is a double stays as it is. Of doubles the
//! place and the distance are enclosed first ([`super::enclosure`]); fractions are made where that decides nothing.
//! Cost: some hundred operations on doubles for a place or a distance that is enclosed, a hundred times as long in
//! fractions; more where exponents differ much.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::enclosure::Enclosure;
use crate::scalar::{Scalar, integers, orient2d};

/// A coordinate to which the point where edges cross can be rounded: `f64`, or `BigRational`, which has the point itself.
/// Convert others to one of the two; an integer, say, has no value for a half.
///
/// ```
/// use num_rational::BigRational;
/// use sweep_cdt::crossings::Exact;
///
/// let third = BigRational::new(1.into(), 3.into());
/// assert_eq!(f64::nearest(&third), 1.0 / 3.0);
/// assert_ne!(f64::nearest(&third).to_fraction(), third);
/// assert_eq!(1.0.around(), [1.0 - f64::EPSILON / 2.0, 1.0 + f64::EPSILON]);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot hold the points where edges cross",
    note = "convert the coordinates to `f64`, or exactly to `num_rational::BigRational`"
)]
pub trait Exact: Scalar + Clone {
    /// The value of a finite coordinate.
    fn to_fraction(&self) -> BigRational;

    /// The value of this type nearest to a fraction that lies between two of them. It must not fall where the fraction
    /// grows, and must equal the fraction if that is a value of this type.
    fn nearest(fraction: &BigRational) -> Self;

    /// The nearest values below and above; the value itself where there is none, or if every fraction is a value.
    fn around(&self) -> [Self; 2];

    /// What [`nearest`](Exact::nearest) returns for every number of which this is the nearest double, if that is one
    /// value and the type can tell. It saves time.
    fn nearest_of_double(_: f64) -> Option<Self> {
        None
    }
}

impl Exact for f64 {
    fn to_fraction(&self) -> BigRational {
        BigRational::from_float(*self).expect("a finite number")
    }

    fn nearest(fraction: &BigRational) -> f64 {
        fraction.to_f64().expect("a fraction has a double near it")
    }

    fn around(&self) -> [f64; 2] {
        [self.next_down(), self.next_up()].map(|x| x.clamp(f64::MIN, f64::MAX))
    }

    fn nearest_of_double(double: f64) -> Option<f64> {
        Some(double)
    }
}

impl Exact for BigRational {
    fn to_fraction(&self) -> BigRational {
        self.clone()
    }

    fn nearest(fraction: &BigRational) -> BigRational {
        fraction.clone()
    }

    fn around(&self) -> [BigRational; 2] {
        [self.clone(), self.clone()]
    }
}

/// The distance to the next value away from zero: a unit in the last place. Zero, if every fraction is a value.
pub(super) fn spacing<S: Exact>(value: &S) -> BigRational {
    let [below, above] = value.around().map(|x| x.to_fraction());
    let value = value.to_fraction();
    (above - &value).max(value - below)
}

/// The point where the line through the first two points meets the line through the others, not parallel to it.
pub(super) fn meeting<S: Exact>([[a, b], [c, d]]: [[&[S; 2]; 2]; 2]) -> [BigRational; 2] {
    let points = [a, b, c, d].map(|point| point.each_ref().map(S::to_fraction));
    let ([a, b, c, d], unit) = integers(points.each_ref());
    let [along, across] = [vector(&a, &b), vector(&c, &d)];
    // The part of the way from a to b is `over / under`.
    let (over, under) = (cross(&vector(&a, &c), &across), cross(&along, &across));
    let denominator = &under * unit;
    [0, 1].map(|i| {
        let numerator = &a[i] * &under + &along[i] * &over;
        BigRational::new(numerator, denominator.clone())
    })
}

/// The value of a coordinate in doubles; `None` where only a fraction tells it.
pub(super) fn enclosure<S: Scalar>(number: &S) -> Option<Enclosure> {
    Enclosure::new(number.approx()).filter(|_| S::APPROX_IS_EXACT)
}

/// A point or a vector, enclosed.
pub(super) type Vector = [Enclosure; 2];

fn enclosed<S: Exact>(point: &[S; 2]) -> Option<Vector> {
    Some([enclosure(&point[0])?, enclosure(&point[1])?])
}

fn from_to(a: Vector, b: Vector) -> Vector {
    [0, 1].map(|i| b[i].minus(a[i]))
}

fn enclosed_cross(u: Vector, v: Vector) -> Enclosure {
    u[0].times(v[1]).minus(u[1].times(v[0]))
}

/// The point where two lines meet, as [`meeting`] says, if doubles can tell.
pub(super) fn enclosed_meeting<S: Exact>([[a, b], [c, d]]: [[&[S; 2]; 2]; 2]) -> Option<Vector> {
    let (a, b) = (enclosed(a)?, enclosed(b)?);
    let (c, d) = (enclosed(c)?, enclosed(d)?);
    let (along, across) = (from_to(a, b), from_to(c, d));
    let part = enclosed_cross(from_to(a, c), across).over(enclosed_cross(along, across))?;
    Some([0, 1].map(|i| along[i].times(part).plus(a[i])))
}

/// The distance of a point from the line through two others, which differ: the least d so that a point of the line
/// differs by at most d units from the point in each coordinate, where `units` are the lengths along x and y that count
/// as 1. Zero if these are zero. With w from a point of the line to the point, and v along the line, the distance is
/// `|v × w| / (|v.x| u.y + |v.y| u.x)`, along the axis or the diagonal that is shortest in units.
pub(super) fn distance<S: Exact>(
    point: &[S; 2],
    [a, b]: [&[S; 2]; 2],
    units: &[BigRational; 2],
) -> BigRational {
    let [p, a, b] = [point, a, b].map(|point| point.each_ref().map(S::to_fraction));
    let size = |x: BigRational| if x < BigRational::zero() { -x } else { x };
    let minus = |p: &[BigRational; 2]| [0, 1].map(|i| &p[i] - &a[i]);
    let (along, to) = (minus(&b), minus(&p));
    let over = size(&along[0] * &to[1] - &along[1] * &to[0]);
    let [x, y] = along.map(size);
    let under = x * &units[1] + y * &units[0];
    if under.is_zero() { under } else { over / under }
}

/// A bound on the [`distance`], if doubles can tell.
pub(super) fn distance_at_most<S: Exact>(
    point: &[S; 2],
    [a, b]: [&[S; 2]; 2],
    units: &[Enclosure; 2],
) -> Option<f64> {
    if orient2d(a, b, point).is_eq() {
        return Some(0.0);
    }
    let from = enclosed(a)?;
    let (along, to) = (from_to(from, enclosed(b)?), from_to(from, enclosed(point)?));
    let over = enclosed_cross(along, to).size();
    let [x, y] = along.map(Enclosure::size);
    let under = x.times(units[1]).plus(y.times(units[0]));
    Some(over.over(under)?.most())
}

fn vector(a: &[BigInt; 2], b: &[BigInt; 2]) -> [BigInt; 2] {
    [0, 1].map(|i| &b[i] - &a[i])
}

fn cross(u: &[BigInt; 2], v: &[BigInt; 2]) -> BigInt {
    &u[0] * &v[1] - &u[1] * &v[0]
}

//! Coordinates as fractions, and back; and where two lines meet.
//!
//! Why it is right: every finite double is a fraction whose denominator is a power of two. The point where two
//! lines meet is computed in whole numbers, over one denominator for all four points, and made a fraction in lowest
//! terms at the end. Rounding is to the nearest double, and of two that are equally near to the one whose last bit
//! is zero (`num-rational`), subnormal ones included. So it is monotone, and a fraction that is a double stays as
//! it is.
//!
//! Cost: some microseconds for a point; more where exponents differ much.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use crate::scalar::{Scalar, integers};

/// A coordinate whose value is a fraction.
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
pub trait Exact: Scalar + Clone {
    /// The value; asked for finite ones only.
    fn to_fraction(&self) -> BigRational;

    /// The value of this type that is nearest to a fraction between two values of this type.
    ///
    /// It must not fall where the fraction grows, and must be the fraction if that is a value of this type.
    fn nearest(fraction: &BigRational) -> Self;

    /// The nearest values below and above; twice the value itself, if every fraction is a value. Where there is none
    /// above or below, the value itself stands for it.
    fn around(&self) -> [Self; 2];
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

/// How far values of this size are apart, away from zero: a unit in the last place. Zero, if every fraction is a value.
pub(super) fn spacing<S: Exact>(value: &S) -> BigRational {
    let [below, above] = value.around().map(|x| x.to_fraction());
    let value = value.to_fraction();
    (above - &value).max(value - below)
}

/// The point where the line through the first two points meets that through the others. They are not parallel.
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

/// How far a point is from the line through two others, which differ: along the axis or the diagonal that is shortest
/// where `units` are the lengths along x and y that count as 1. Zero if these are zero.
///
/// That is the least d so that a point of the line differs by at most d units from the point in each coordinate. With w
/// from a point of the line to the point, and v along the line, it is |v × w| / (|v.x| u.y + |v.y| u.x).
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

fn vector(a: &[BigInt; 2], b: &[BigInt; 2]) -> [BigInt; 2] {
    [0, 1].map(|i| &b[i] - &a[i])
}

fn cross(u: &[BigInt; 2], v: &[BigInt; 2]) -> BigInt {
    &u[0] * &v[1] - &u[1] * &v[0]
}

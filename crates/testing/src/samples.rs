//! Doubles in other scalars, and a scalar that has nothing but the trait.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{FromPrimitive, ToPrimitive};
use sweep_cdt::scalar::Scalar;

use crate::oracle::common_denominator;

/// Points in another scalar, if it can hold all of their coordinates.
pub fn convert<S: Sample>(points: &[[f64; 2]]) -> Option<Vec<[S; 2]>> {
    points
        .iter()
        .map(|&[x, y]| Some([S::of(x)?, S::of(y)?]))
        .collect()
}

/// A scalar that can be made of a double.
pub trait Sample: Scalar + Sync {
    /// Exactly this number, if the type can hold it.
    fn of(x: f64) -> Option<Self>;
}

fn integer<T: FromPrimitive>(x: f64) -> Option<T> {
    if x.fract() == 0.0 {
        T::from_f64(x)
    } else {
        None
    }
}

impl Sample for f64 {
    fn of(x: f64) -> Option<f64> {
        Some(x)
    }
}

impl Sample for f32 {
    fn of(x: f64) -> Option<f32> {
        x.to_f32().filter(|&y| f64::from(y).total_cmp(&x).is_eq())
    }
}

impl Sample for i32 {
    fn of(x: f64) -> Option<i32> {
        integer(x)
    }
}

impl Sample for i64 {
    fn of(x: f64) -> Option<i64> {
        integer(x)
    }
}

impl Sample for i128 {
    fn of(x: f64) -> Option<i128> {
        integer(x)
    }
}

impl Sample for Ratio<i64> {
    fn of(x: f64) -> Option<Ratio<i64>> {
        let exact = BigRational::from_float(x)?;
        Some(Ratio::new(exact.numer().to_i64()?, exact.denom().to_i64()?))
    }
}

impl Sample for BigInt {
    fn of(x: f64) -> Option<BigInt> {
        integer(x)
    }
}

impl Sample for BigRational {
    fn of(x: f64) -> Option<BigRational> {
        BigRational::from_float(x)
    }
}

/// A scalar that has nothing but the trait: not even `Clone` or `Debug`.
pub struct Archetype(BigRational);

/// Points over their common denominator, in whole numbers: one positive factor changes no turn and no circle, and fractions
/// would be reduced after each step.
fn whole<const N: usize>(points: [&[Archetype; 2]; N]) -> [[BigInt; 2]; N] {
    let common = common_denominator(points.iter().flat_map(|p| p.iter()).map(|x| &x.0));
    points.map(|p| p.each_ref().map(|x| x.0.numer() * (&common / x.0.denom())))
}

impl Scalar for Archetype {
    fn approx(&self) -> f64 {
        self.0.to_f64().expect("every rational is near a double")
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.0.cmp(&other.0)
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
        let [a, b, c] = whole([a, b, c]);
        let left = (&b[0] - &a[0]) * (&c[1] - &a[1]);
        left.cmp(&((&b[1] - &a[1]) * (&c[0] - &a[0])))
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
        let [a, b, c, d] = whole([a, b, c, d]);
        let [[ax, ay], [bx, by], [cx, cy]] = [a, b, c].map(|p| [0, 1].map(|i| &p[i] - &d[i]));
        let lift = |x: &BigInt, y: &BigInt| x * x + y * y;
        let det = lift(&ax, &ay) * (&bx * &cy - &by * &cx)
            + lift(&bx, &by) * (&cx * &ay - &cy * &ax)
            + lift(&cx, &cy) * (&ax * &by - &ay * &bx);
        det.cmp(&BigInt::ZERO)
    }
}

impl Sample for Archetype {
    fn of(x: f64) -> Option<Archetype> {
        BigRational::from_float(x).map(Archetype)
    }
}

//! Doubles in other scalars, and a scalar that has nothing but the trait.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{FromPrimitive, ToPrimitive};
use sweep_cdt::scalar::{Measure, Scalar, Stage};

/// Points in another scalar, if it can hold all of their coordinates.
pub fn convert<S: Sample>(points: &[[f64; 2]]) -> Option<Vec<[S; 2]>> {
    points
        .iter()
        .map(|&[x, y]| Some([S::of(x)?, S::of(y)?]))
        .collect()
}

/// A scalar that can be made of a double.
pub trait Sample: Measure + Sync {
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

impl Archetype {
    fn minus(&self, other: &Archetype) -> BigRational {
        &self.0 - &other.0
    }
}

impl Scalar for Archetype {
    fn approx(&self) -> f64 {
        self.0.to_f64().expect("every rational is near a double")
    }

    fn compare(&self, other: &Self) -> Ordering {
        self.0.cmp(&other.0)
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
        let left = b[0].minus(&a[0]) * c[1].minus(&a[1]);
        let sign = left.cmp(&(b[1].minus(&a[1]) * c[0].minus(&a[0])));
        (sign, Stage::Own)
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> (Ordering, Stage) {
        let [[ax, ay], [bx, by], [cx, cy]] = [a, b, c].map(|p| [0, 1].map(|i| p[i].minus(&d[i])));
        let lift = |x: &BigRational, y: &BigRational| x * x + y * y;
        let det = lift(&ax, &ay) * (&bx * &cy - &by * &cx)
            + lift(&bx, &by) * (&cx * &ay - &cy * &ax)
            + lift(&cx, &cy) * (&ax * &by - &ay * &bx);
        let sign = det.cmp(&BigRational::from_integer(BigInt::ZERO));
        (sign, Stage::Own)
    }
}

impl Measure for Archetype {}

impl Sample for Archetype {
    fn of(x: f64) -> Option<Archetype> {
        BigRational::from_float(x).map(Archetype)
    }
}

//! References to numbers: `&f64`, `&BigRational` and so on are scalars, so that points may borrow their coordinates.
//! One macro implements them for each type of the crate. One implementation for all `&S` is not possible beside that
//! for all [`Unbounded`](super::Unbounded) types: another crate might make a reference one of these.
//! Cost: a copy of the points for each sign that the filter leaves open, and one of all numbers in `as_doubles`.

use alloc::vec::Vec;
use core::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};

use super::Scalar;
use super::forward::forward;

/// Makes `&T` a scalar for types that can be cloned.
macro_rules! references {
    ($($type:ty),+) => { $(
        impl Scalar for &$type {
            const APPROX_IS_EXACT: bool = <$type>::APPROX_IS_EXACT;

            fn is_finite(&self) -> bool {
                Scalar::is_finite(*self)
            }

            fn approx(&self) -> f64 {
                Scalar::approx(*self)
            }

            fn as_doubles(points: &[[Self; 2]]) -> Option<Vec<[f64; 2]>> {
                let copies = points.iter().map(|point| point.map(<$type>::clone));
                Scalar::as_doubles(&copies.collect::<Vec<[$type; 2]>>())
            }

            fn difference(&self, other: &Self) -> Option<(f64, i64)> {
                Scalar::difference(*self, *other)
            }

            fn compare(&self, other: &Self) -> Ordering {
                Scalar::compare(*self, *other)
            }

            forward!(predicates: $type, |&number: &Self| <$type>::clone(number));

            forward!(sizes: $type, |&number: &Self| <$type>::clone(number));

}

    )+ };
}

references!(f64, f32, i32, i64, i128, BigInt, BigRational, Ratio<i64>);
#[cfg(feature = "rug")]
references!(rug::Integer, rug::Rational);

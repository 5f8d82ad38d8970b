//! References to numbers: `&f64`, `&BigRational` and so on are scalars, so that points may borrow their coordinates.
//!
//! One macro writes the implementation for each type, and for types of other crates. A single one for all `&S` is not
//! possible beside that for all [`Unbounded`](super::Unbounded) types: another crate might say that of a reference.
//!
//! Cost: a copy of the points for each sign that the filter leaves open, and one of all numbers in
//! [`as_doubles`](super::Scalar::as_doubles).

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};

/// Makes `&T` a [`Scalar`](crate::scalar::Scalar) where `T` is one and can be cloned, for types of your own.
///
/// It already is one for all scalars of this crate.
///
/// ```
/// use std::cmp::Ordering;
/// use sweep_cdt::scalar::Scalar;
///
/// /// A number of 256ths.
/// #[derive(Clone)]
/// struct Fixed(i64);
/// # impl Scalar for Fixed {
/// #     fn approx(&self) -> f64 { self.0 as f64 / 256.0 }
/// #     fn compare(&self, other: &Self) -> Ordering { self.0.cmp(&other.0) }
/// #     fn orient2d([a, b]: &[Self; 2], [c, d]: &[Self; 2], [e, f]: &[Self; 2]) -> Ordering {
/// #         Scalar::orient2d(&[a.0, b.0], &[c.0, d.0], &[e.0, f.0])
/// #     }
/// #     fn in_circle([a, b]: &[Self; 2], [c, d]: &[Self; 2], [e, f]: &[Self; 2], [g, h]: &[Self; 2]) -> Ordering {
/// #         Scalar::in_circle(&[a.0, b.0], &[c.0, d.0], &[e.0, f.0], &[g.0, h.0])
/// #     }
/// # }
/// // impl Scalar for Fixed { ... }
/// sweep_cdt::scalar_by_reference!(Fixed);
///
/// let numbers = [0, 256, 512].map(Fixed);
/// let points = [[0, 0], [2, 0], [1, 1]].map(|point| point.map(|i: usize| &numbers[i]));
/// assert_eq!(sweep_cdt::triangulate(&points, &[])?.len(), 1);
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[macro_export]
macro_rules! scalar_by_reference {
    ($($type:ty),+ $(,)?) => { $(
        impl $crate::scalar::Scalar for &$type {
            const APPROX_IS_EXACT: bool = <$type as $crate::scalar::Scalar>::APPROX_IS_EXACT;

            fn is_finite(&self) -> bool {
                $crate::scalar::Scalar::is_finite(*self)
            }

            fn approx(&self) -> f64 {
                $crate::scalar::Scalar::approx(*self)
            }

            fn as_doubles(points: &[[Self; 2]]) -> Option<Vec<[f64; 2]>> {
                let copies: Vec<[$type; 2]> =
                    points.iter().map(|point| point.map(<$type>::clone)).collect();
                $crate::scalar::Scalar::as_doubles(&copies)
            }

            fn difference(&self, other: &Self) -> Option<(f64, i64)> {
                $crate::scalar::Scalar::difference(*self, *other)
            }

            fn compare(&self, other: &Self) -> ::std::cmp::Ordering {
                $crate::scalar::Scalar::compare(*self, *other)
            }

            fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> ::std::cmp::Ordering {
                let [a, b, c] = [a, b, c].map(|point| point.map(<$type>::clone));
                <$type as $crate::scalar::Scalar>::orient2d(&a, &b, &c)
            }

            fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> ::std::cmp::Ordering {
                let [a, b, c, d] = [a, b, c, d].map(|point| point.map(<$type>::clone));
                <$type as $crate::scalar::Scalar>::in_circle(&a, &b, &c, &d)
            }

            fn depth(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Option<f64> {
                let [a, b, c, d] = [a, b, c, d].map(|point| point.map(<$type>::clone));
                <$type as $crate::scalar::Scalar>::depth(&a, &b, &c, &d)
            }

            fn height(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Option<f64> {
                let [a, b, c] = [a, b, c].map(|point| point.map(<$type>::clone));
                <$type as $crate::scalar::Scalar>::height(&a, &b, &c)
            }

            fn orient2d_exact(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (::std::cmp::Ordering, $crate::scalar::Stage) {
                let [a, b, c] = [a, b, c].map(|point| point.map(<$type>::clone));
                <$type as $crate::scalar::Scalar>::orient2d_exact(&a, &b, &c)
            }

            fn in_circle_exact(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> (::std::cmp::Ordering, $crate::scalar::Stage) {
                let [a, b, c, d] = [a, b, c, d].map(|point| point.map(<$type>::clone));
                <$type as $crate::scalar::Scalar>::in_circle_exact(&a, &b, &c, &d)
            }
        }
    )+ };
}

crate::scalar_by_reference!(f64, f32, i32, i64, i128, BigInt, BigRational, Ratio<i64>);
#[cfg(feature = "rug")]
crate::scalar_by_reference!(rug::Integer, rug::Rational);

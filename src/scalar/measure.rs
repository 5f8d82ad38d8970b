//! Sizes behind the signs, for which only the verifier's report asks: [`Measure`], and its two polynomials. Both are
//! relative to the size of what the points span, so that rounding looks the same at all sizes (some units of 1e-16):
//!
//! ```text
//! depth of d in the circle of a, b, c:     (r^2 - |d - o|^2) / r^2 = 4 D A / (|ab|^2 |bc|^2 |ca|^2)
//! height of the turn a, b, c:              A / |ac|^2
//! ```
//!
//! o and r are the circle's centre and radius, D is the in-circle determinant, and A twice the area of the triangle.
//! Why it is right: the power of d to the circle is -D / A, and r is |ab| |bc| |ca| / 2 A. All factors are polynomials,
//! computed exactly. Only then is each rounded to a double, with its exponent apart, and a few roundings follow. So the
//! sign is exact, and the size right in relative terms, down to the smallest double. Cost: some microseconds.

use super::determinants::{cross, determinant, dot, minus, square};
use super::doubles::{exponent, power};
use super::{Scalar, Unbounded};

/// A coordinate type that the verifier can judge: it may tell how deep a fault is.
///
/// For a type of your own an empty implementation will do. Then faults have depths only if coordinates are doubles
/// ([`Scalar::APPROX_IS_EXACT`]). For depths in other types write both functions. A common positive factor of all
/// coordinates changes no depth, so another type may compute it, as it may predicates. [`Unbounded`] numbers have both.
///
/// ```
/// use std::cmp::Ordering;
/// use sweep_cdt::scalar::{Measure, Scalar, Stage};
///
/// /// A number of 256ths.
/// struct Fixed(i32);
///
/// fn whole(point: &[Fixed; 2]) -> [i32; 2] {
///     point.each_ref().map(|number| number.0)
/// }
///
/// impl Scalar for Fixed {
///     // ...
/// #   fn approx(&self) -> f64 { f64::from(self.0) / 256.0 }
/// #   fn compare(&self, other: &Self) -> Ordering { self.0.cmp(&other.0) }
/// #   fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
/// #       Scalar::orient2d(&whole(a), &whole(b), &whole(c))
/// #   }
/// #   fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> (Ordering, Stage) {
/// #       Scalar::in_circle(&whole(a), &whole(b), &whole(c), &whole(d))
/// #   }
/// }
///
/// impl Measure for Fixed {
///     fn depth(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Option<f64> {
///         Measure::depth(&whole(a), &whole(b), &whole(c), &whole(d))
///     }
///
///     fn height(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Option<f64> {
///         Measure::height(&whole(a), &whole(b), &whole(c))
///     }
/// }
///
/// // The wrong diagonal.
/// let points = [[0, 0], [4, 0], [5, 3], [0, 3]].map(|point| point.map(Fixed));
/// let wrong = sweep_cdt::verify::verify(&points, &[], &[[0, 1, 2], [0, 2, 3]]).unwrap_err();
/// assert!(wrong.depth().is_some_and(|depth| depth.get() > 0.1));
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be verified: it does not implement `Measure`",
    note = "for a `Scalar` of your own `impl Measure for {Self} {{}}` will do"
)]
pub trait Measure: Scalar {
    /// How deep `d` lies in the circumcircle of a counter-clockwise triangle `a`, `b`, `c`: the power of `d` to the
    /// circle in units of the squared radius, positive inside, 1 at the centre. `None` if the type does not tell.
    ///
    /// The sign must be that of [`in_circle`](Scalar::in_circle), the size right to some units of 2^-52 of itself.
    ///
    /// ```
    /// use sweep_cdt::scalar::Measure;
    ///
    /// let [a, b, c] = [[0_i64, 0], [4, 0], [4, 4]];
    /// assert_eq!(Measure::depth(&a, &b, &c, &[2, 2]), Some(1.0));
    /// assert_eq!(Measure::depth(&a, &b, &c, &[0, 4]), Some(0.0));
    /// assert_eq!(Measure::depth(&a, &b, &c, &[1, 3]), Some(0.75));
    /// ```
    fn depth(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Option<f64> {
        let [a, b, c, d] = coordinates([a, b, c, d])?;
        f64::depth(&a, &b, &c, &d)
    }

    /// The height of `b` over the line from `a` to `c`, in units of their distance, positive where `a`, `b`, `c` turn
    /// left. `None` if they turn by a right angle or more, or if the type does not tell.
    ///
    /// The sign must be that of [`orient2d`](Scalar::orient2d), the size as right as that of [`depth`](Measure::depth).
    ///
    /// ```
    /// use sweep_cdt::scalar::Measure;
    ///
    /// let turn = Measure::height(&[0.0, 0.0], &[1.0, -1e-17], &[2.0, 0.0]);
    /// assert_eq!(turn, Some(0.5e-17));
    /// ```
    fn height(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Option<f64> {
        let [a, b, c] = coordinates([a, b, c])?;
        f64::height(&a, &b, &c)
    }
}

/// The points as doubles, if doubles are the coordinates.
fn coordinates<S: Scalar, const N: usize>(points: [&[S; 2]; N]) -> Option<[[f64; 2]; N]> {
    let doubles = || points.map(|[x, y]| [x.approx(), y.approx()]);
    S::APPROX_IS_EXACT.then(doubles)
}

impl<T: Unbounded> Measure for T {
    fn depth(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Option<f64> {
        let rows = [a, b, c].map(|p| minus(p, d));
        let [ab, bc, ca] = [minus(b, a), minus(c, b), minus(a, c)];
        let area = cross(&ab, &bc);
        let squares = [square(&ab), square(&bc), square(&ca)];
        quotient(4.0, &[determinant(&rows), area], &squares)
    }

    fn height(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Option<f64> {
        let [ab, bc, ac] = [minus(b, a), minus(c, b), minus(c, a)];
        let goes_on = dot(&ab, &bc) > T::zero();
        let height = || quotient(1.0, &[cross(&ab, &bc)], &[square(&ac)]);
        goes_on.then(height).flatten()
    }
}

/// `first` times all of `over`, divided by all of `under`; `None` if one of these is zero.
fn quotient<T: Unbounded>(first: f64, over: &[T], under: &[T]) -> Option<f64> {
    let (mut value, mut exponent) = (first, 0);
    for factor in under {
        let (x, power) = parts(factor)?;
        if x == 0.0 {
            return None;
        }
        (value, exponent) = (value / x, exponent - power);
    }
    for factor in over {
        let (x, power) = parts(factor)?;
        (value, exponent) = (value * x, exponent + power);
    }
    // Two steps, since the power of two may be no double.
    let bounded = exponent.clamp(-1200, 1000);
    let size = value.abs() * power(bounded / 2) * power(bounded - bounded / 2);
    let size = if value == 0.0 {
        0.0
    } else {
        size.max(f64::from_bits(1))
    };
    Some(size.copysign(value))
}

/// A number as a double from 1 to 2, or zero, with its sign, and a power of two.
fn parts<T: Unbounded>(number: &T) -> Option<(f64, i64)> {
    const MANTISSA: u64 = (1 << 52) - 1;
    let (x, power) = number.near()?;
    let one = f64::from_bits(x.to_bits() & MANTISSA | 1.0_f64.to_bits());
    Some(if x == 0.0 {
        (0.0, 0)
    } else {
        (one.copysign(x), exponent(x.abs()) + power)
    })
}

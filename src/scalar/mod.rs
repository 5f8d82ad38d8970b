//! All arithmetic on coordinates: exact predicates, which take references and return signs.
//!
//! [`Scalar`] is the contract. A coordinate type gives an approximation of a value, a double; the order of two values;
//! and two exact signs: on which side of a line, and of a circle, a point lies. The approximations feed the
//! floating-point filter, which returns a sign only if it is certain, and choose what only costs time: hash buckets,
//! and the angles of the heuristics. All else saves time, or tells the verifier how much is wrong.
//!
//! Each sign comes from the first stage that is certain of it: the filter for doubles; doubles that are not rounded,
//! as all points are on a lattice; doubles as integers in one unit; doubles that are the coordinates; the type's
//! arithmetic.
//!
//! | type | how it is exact |
//! |---|---|
//! | `f64` | machine integers, adaptive expansions (crate `robust`), big integers where exponents are extreme |
//! | `f32`, `i32` | as `f64`, which holds all of them |
//! | `i64`, `i128` | 128-bit integers where they suffice, else big integers |
//! | `BigRational`, `Ratio<i64>` | integers over a common denominator |
//! | any [`Unbounded`] number (`BigInt`, your own, ...) | its own arithmetic |
//! | `rug::Rational`, `rug::Integer` (feature `rug`) | GMP's arithmetic |
//! | references to the built-in types | as the type |

mod determinants;
mod doubles;
mod f32;
mod f64;
pub(crate) mod filter;
mod forward;
mod integer;
mod integer_points;
mod lanes;
mod lattice;
mod measure;
mod predicates;
mod ratio;
mod rational;
mod recenter;
mod reference;
#[cfg(feature = "rug")]
mod rug;
mod scale;
mod unbounded;
mod wide;

use alloc::vec::Vec;
use core::cmp::Ordering;

pub(crate) use predicates::{ExactPoints, NearTies, Predicates};
pub use predicates::{in_circle, orient2d};
pub(crate) use rational::integers;
pub(crate) use recenter::recenter;
pub(crate) use scale::{Scale, is_in_range};
pub use unbounded::Unbounded;

/// A coordinate type with exact predicates.
///
/// Neither `Copy` nor `Clone` nor any operator is required, so that big rationals fit as well as doubles. A type of
/// your own needs `approx`, `compare`, `orient2d` and `in_circle`. All but `approx` must be exact for every value:
/// where the type's arithmetic rounds or overflows, compute in a wider type. The in-circle determinant has about four
/// times the digits of the differences of coordinates. Exact arithmetic without bounds needs only [`Unbounded`].
///
/// Predicates must be exact, agree with one another and with `compare`, and give the same answer each time. Otherwise
/// the sweep may return a wrong result, panic, or take long. The verifier, which asks the same predicates, is no judge
/// of them. `sweep-cdt-testing`, a package of the repository, has a test for a type of your own: `conformance`.
///
/// A predicate answers with an [`Ordering`], the sign of the determinant. Sweep and verifier ask only where the
/// floating-point filter leaves the sign open; [`orient2d`] and [`in_circle`] do so for a few points.
///
/// ```
/// use std::cmp::Ordering;
/// use sweep_cdt::scalar::Scalar;
///
/// let (a, b, c) = ([0.0, 0.0], [1.0, 0.0], [0.0, 1.0]);
/// assert_eq!(Scalar::orient2d(&a, &b, &c), Ordering::Greater);
/// assert_eq!(Scalar::in_circle(&a, &b, &c, &[1.0, 1.0]), Ordering::Equal);
/// ```
///
/// A type of your own can use another: signs do not change if all coordinates are multiplied by one positive number, so
/// `i64` does for fixed-point numbers:
///
/// ```
/// use std::cmp::Ordering;
/// use sweep_cdt::scalar::Scalar;
///
/// /// A number of 65536ths.
/// #[derive(Clone, Copy)]
/// struct Fixed(i64);
///
/// fn whole(point: &[Fixed; 2]) -> [i64; 2] {
///     point.map(|number| number.0)
/// }
///
/// impl Scalar for Fixed {
///     fn approx(&self) -> f64 {
///         self.0 as f64 / 65536.0
///     }
///
///     fn compare(&self, other: &Self) -> Ordering {
///         self.0.cmp(&other.0)
///     }
///
///     fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
///         Scalar::orient2d(&whole(a), &whole(b), &whole(c))
///     }
///
///     fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
///         Scalar::in_circle(&whole(a), &whole(b), &whole(c), &whole(d))
///     }
///
///     // Not required: the filter decides sooner on doubles that are the numbers.
///     fn as_doubles(points: &[[Self; 2]]) -> Option<Vec<[f64; 2]>> {
///         Scalar::as_doubles(&points.iter().map(whole).collect::<Vec<_>>())
///     }
/// }
///
/// let points = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|point| point.map(Fixed));
/// let result = sweep_cdt::triangulate(&points, &[[0, 2]])?;
/// assert_eq!(result.len(), 2);
/// assert!(result.with_points(&points).verify(&[[0, 2]]).is_ok());
/// # Ok::<(), sweep_cdt::Error>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no coordinate: it does not implement `Scalar`",
    label = "no exact predicates are known for `{Self}`",
    note = "coordinates are `f64`, `f32`, `i32`, `i64`, `i128`, `BigInt`, `BigRational`, `Ratio<i64>`, with the feature `rug` its `Integer` and `Rational`, and references to these",
    note = "other machine integers fit in one of them: `points.map(|p| p.map(i64::from))` does for `u32`, `i128::from` for `u64`",
    note = "other fractions, such as `Ratio<i32>`, become `Ratio<i64>` or `BigRational`",
    note = "a type of `num-bigint` or `num-rational` in another version is another type",
    note = "a type of your own implements `Scalar`, or `Unbounded` alone if its arithmetic is exact and never overflows"
)]
pub trait Scalar: Sized {
    /// Whether [`approx`](Scalar::approx) always returns the value itself.
    const APPROX_IS_EXACT: bool = false;

    /// Whether the number is finite; the sweep refuses points with a coordinate that is not.
    fn is_finite(&self) -> bool {
        true
    }

    /// A double near the number: monotone (`a <= b` gives `a.approx() <= b.approx()`), never NaN, and within a relative
    /// error of 2^-52 of every value in the range of normal doubles. Larger values may become infinite, and smaller
    /// ones may lose digits as doubles do or become zero.
    fn approx(&self) -> f64;

    /// Doubles that are exactly the coordinates of these points, all of them multiplied by one positive number; `None`
    /// if no number makes all coordinates doubles, or the type cannot tell at little cost.
    ///
    /// A positive factor changes no sign. So the sweep triangulates these doubles in place of the points, and the exact
    /// stages of `f64` decide what the filter leaves open. Types with [`Scalar::APPROX_IS_EXACT`] are not asked.
    ///
    /// ```
    /// use num_rational::BigRational;
    /// use sweep_cdt::scalar::Scalar;
    ///
    /// let [third, fifth] = [3, 5].map(|n: i32| BigRational::new(1.into(), n.into()));
    /// assert_eq!(Scalar::as_doubles(&[[third, fifth]]), Some(vec![[5.0, 3.0]]));
    /// assert_eq!(Scalar::as_doubles(&[[1_i64 << 60, 0], [1, 0]]), None);
    /// ```
    fn as_doubles(points: &[[Self; 2]]) -> Option<Vec<[f64; 2]>> {
        let _ = points;
        None
    }

    /// The difference to another value, rounded: `(x, power)` for x * 2^power; `None` where the type knows no better
    /// one than [`approx`](Scalar::approx) gives. It must be computed exactly, then rounded. With the other value fixed
    /// it must be monotone as `approx`, finite, zero for equal values only, and within a relative error of 2^-52.
    ///
    /// The sweep asks for differences where approximations cannot tell the points apart: points close to each other and
    /// far from zero, or all too large or too small for a double. Then the doubles that feed the filter and choose what
    /// costs time are relative to one of the points. Without differences such points take the time of exact arithmetic.
    ///
    /// The unit must be that of `approx`: the sweep may take differences along one axis and approximations along the
    /// other. So where another type computes the difference in 2^-16 of the unit, as `i64` does for the `Fixed` above,
    /// take 16 from its power: `self.0.difference(&other.0).map(|(x, power)| (x, power - 16))`. Where the unit is no power
    /// of two, as for cents, let `approx` be that of the whole number: any one unit will do.
    ///
    /// ```
    /// use num_bigint::BigInt;
    /// use sweep_cdt::scalar::Scalar;
    ///
    /// let far = BigInt::from(1) << 2000;
    /// let near: BigInt = &far + 3;
    /// assert_eq!(near.difference(&far), Some((3.0, 0)));
    /// assert_eq!(0.5_f64.difference(&0.25), None);
    /// ```
    fn difference(&self, other: &Self) -> Option<(f64, i64)> {
        let _ = other;
        None
    }

    /// The exact order of two coordinates.
    fn compare(&self, other: &Self) -> Ordering;

    /// `Greater` if `a`, `b`, `c` turn left (counter-clockwise), `Less` right, `Equal` if on one line.
    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering;

    /// For a counter-clockwise triangle `a`, `b`, `c`: `Greater` if `d` lies inside its circumcircle, `Less` outside,
    /// `Equal` on it. Swapping two of the first three points reverses the sign.
    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering;

    /// [`orient2d`](Scalar::orient2d) with the arithmetic that decided it, which is counted.
    #[doc(hidden)]
    fn orient2d_by_stage(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
        (Self::orient2d(a, b, c), Stage::Own)
    }

    /// [`in_circle`](Scalar::in_circle) with the arithmetic that decided it.
    #[doc(hidden)]
    fn in_circle_by_stage(
        a: &[Self; 2],
        b: &[Self; 2],
        c: &[Self; 2],
        d: &[Self; 2],
    ) -> (Ordering, Stage) {
        (Self::in_circle(a, b, c, d), Stage::Own)
    }

    /// How deep `d` lies in the circumcircle of a counter-clockwise triangle `a`, `b`, `c`: the power of `d` to the
    /// circle in units of the squared radius, positive inside, 1 at the centre. `None` if the type does not tell.
    ///
    /// The sign must be that of [`in_circle`](Scalar::in_circle), the size right to some units of 2^-52 of itself.
    ///
    /// ```
    /// use sweep_cdt::scalar::Scalar;
    ///
    /// let [a, b, c] = [[0_i64, 0], [4, 0], [4, 4]];
    /// assert_eq!(Scalar::depth(&a, &b, &c, &[2, 2]), Some(1.0));
    /// assert_eq!(Scalar::depth(&a, &b, &c, &[0, 4]), Some(0.0));
    /// assert_eq!(Scalar::depth(&a, &b, &c, &[1, 3]), Some(0.75));
    /// ```
    fn depth(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Option<f64> {
        let [a, b, c, d] = measure::coordinates([a, b, c, d])?;
        Scalar::depth(&a, &b, &c, &d)
    }

    /// The height of `b` over the line from `a` to `c`, in units of their distance, positive where `a`, `b`, `c` turn
    /// left. `None` if they turn by a right angle or more, or if the type does not tell.
    ///
    /// The sign must be that of [`orient2d`](Scalar::orient2d), the size as right as that of [`depth`](Scalar::depth).
    ///
    /// ```
    /// use sweep_cdt::scalar::Scalar;
    ///
    /// let turn = Scalar::height(&[0.0, 0.0], &[1.0, -1e-17], &[2.0, 0.0]);
    /// assert_eq!(turn, Some(0.5e-17));
    /// ```
    fn height(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Option<f64> {
        let [a, b, c] = measure::coordinates([a, b, c])?;
        Scalar::height(&a, &b, &c)
    }
}

/// The exact arithmetic that decided a sign where the floating-point filter did not.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stage {
    /// Machine integers of up to 256 bits.
    Integers,
    /// The adaptive expansions of Shewchuk (1997): sums of doubles, only as many as the sign needs.
    Expansions,
    /// Big integers.
    BigIntegers,
    /// The scalar's own arithmetic.
    Own,
}

/// The points with each coordinate as the double that `double` gives, if it gives one for all of them.
fn all_doubles<S>(points: &[[S; 2]], double: impl Fn(&S) -> Option<f64>) -> Option<Vec<[f64; 2]>> {
    let doubles = points.iter().map(|[x, y]| Some([double(x)?, double(y)?]));
    doubles.collect()
}

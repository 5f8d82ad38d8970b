//! All arithmetic on coordinates: exact predicates, which take references and return signs.
//!
//! The sweep asks four questions of a coordinate type: is it a finite number, which of two is larger, on
//! which side of a line is a point, and is a point inside a circle. All answers are exact. A fifth
//! function, [`Scalar::approx`], gives a double near the value. The doubles feed the floating-point filter
//! (which returns a sign only if it is certain) and choose what only costs time: hash buckets, and the
//! angles of the heuristics. A sixth, [`Scalar::difference`], may be left out. It gives a double near a
//! difference, for points whose own doubles tell too little. Two more, [`Scalar::depth`] and [`Scalar::height`], may be
//! left out too: the verifier tells by them how much is wrong.
//!
//! | type | how it is exact |
//! |---|---|
//! | `f64` | filter, then machine integers, then adaptive expansions (crate `robust`), then big integers where exponents are extreme |
//! | `f32` | as `f64`, which holds every `f32` |
//! | `i32`, `i64`, `i128` | 128-bit integers where they suffice, else big integers |
//! | `BigRational`, `Ratio<i64>` | filter, then integers over a common denominator |
//! | any [`Unbounded`] number (`BigInt`, your own, ...) | filter, then its own arithmetic |
//! | `rug::Rational`, `rug::Integer` (feature `rug`) | filter, then GMP's arithmetic |
//! | `&S` for each of these | as `S` |

mod conformance;
mod doubles;
mod f32;
mod f64;
pub(crate) mod filter;
pub(crate) mod frame;
mod i128;
mod integer;
mod lanes;
mod lattice;
mod ratio;
mod rational;
mod reference;
#[cfg(feature = "rug")]
mod rug;
#[cfg(feature = "rug")]
mod rug_integer;
mod scale;
mod unbounded;
mod whole;
mod wide;

use std::cmp::Ordering;

pub use conformance::{Nonconformity, conformance};
pub(crate) use rational::integers;
pub(crate) use scale::{Scale, is_in_range};
pub use unbounded::Unbounded;
pub(crate) use whole::WholePoints;

/// A coordinate type with exact predicates.
///
/// It requires neither `Copy` nor `Clone` nor any operator, so that big rationals fit as well as
/// doubles. A type of your own needs `approx`, `compare`, `orient2d` and `in_circle`. All
/// but `approx` must be exact for every value: where the type's own arithmetic rounds or overflows,
/// compute them in a wider type. The in-circle determinant has about four times the digits of the
/// differences of coordinates. Numbers whose arithmetic is exact without bounds need [`Unbounded`] only.
///
/// Everything relies on that: that the predicates are exact, agree with one another and with `compare`, and
/// give the same answer each time. [`conformance`] tests a type of your own. With a type that breaks this the sweep returns no correct result: it
/// may return a wrong one, panic, or take long. The verifier, which asks the same predicates, is no judge
/// of them.
///
/// References to all scalars of this crate are scalars too; for those to your own type see
/// [`scalar_by_reference!`](crate::scalar_by_reference).
///
/// A predicate answers with an [`Ordering`]: the sign of the determinant compared with zero.
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
/// Your own type: signs do not change if all coordinates are multiplied by the same positive number, so a
/// fixed-point number can leave the work to `i64`:
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
/// }
///
/// let points = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|point| point.map(Fixed));
/// assert_eq!(sweep_cdt::triangulate(&points, &[[0, 2]])?.len(), 2);
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

    /// Whether this is a finite number; the sweep refuses points for which it is not.
    fn is_finite(&self) -> bool {
        true
    }

    /// A double near the value.
    ///
    /// It must be monotone (`a <= b` gives `a.approx() <= b.approx()`), never NaN, and within a
    /// relative error of 2^-52 of every value that lies in the range of normal doubles. Larger values
    /// may become infinite, and smaller ones may lose digits as doubles do or become zero.
    fn approx(&self) -> f64;

    /// Doubles that are exactly the coordinates of these points, all of them multiplied by one positive number;
    /// `None` where there are none, or the type cannot tell at little cost.
    ///
    /// Such a number changes no sign. So the sweep triangulates these doubles in place of the points, and the exact
    /// stages of `f64` decide what the filter leaves open. It does not ask a type whose approximations are exact
    /// ([`APPROX_IS_EXACT`](Scalar::APPROX_IS_EXACT)).
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

    /// A double and a power of two, `(x, power)` for x * 2^power, near the difference to another value;
    /// `None` where the type knows no better one than [`approx`](Scalar::approx) gives.
    ///
    /// It is asked for where that loses what tells the points apart: they lie close to each other and
    /// far from zero, or are all too large or too small for a double. Then the doubles that feed the
    /// filter and choose what costs time are taken relative to one of the points. Without it such points
    /// take the time of exact arithmetic.
    ///
    /// The difference must be computed exactly and then rounded. With the other value fixed the result must
    /// be monotone as that of `approx` is, always finite, zero for equal values only, and within a
    /// relative error of 2^-52.
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

    /// `Greater` if `a`, `b`, `c` make a left turn (counter-clockwise), `Less` for a right turn,
    /// `Equal` if they lie on one line.
    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering;

    /// For a counter-clockwise triangle `a`, `b`, `c`: `Greater` if `d` lies inside its circumcircle,
    /// `Less` outside, `Equal` on it. Swapping two of the first three points reverses the sign.
    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering;

    /// How deep `d` lies in the circumcircle of a counter-clockwise triangle `a`, `b`, `c`: its power to the circle
    /// in units of the square of the radius, positive inside. The centre has depth 1. `None` if the type does not tell.
    ///
    /// The verifier says by it how wrong a side is. Its sign must be that of [`in_circle`](Scalar::in_circle), its
    /// size right to some units of 2^-52 of itself. A common positive factor of all coordinates changes nothing, so
    /// a type may leave this to another as it may leave the predicates.
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
        of_doubles([a, b, c, d]).and_then(|[a, b, c, d]| Scalar::depth(&a, &b, &c, &d))
    }

    /// The height of `b` over the line from `a` to `c`, in units of the distance from `a` to `c`; positive where the
    /// path through them turns left. `None` if it turns by a right angle or more, or if the type does not tell.
    ///
    /// What holds of [`depth`](Scalar::depth) holds of it, with the sign of [`orient2d`](Scalar::orient2d).
    ///
    /// ```
    /// use sweep_cdt::scalar::Scalar;
    ///
    /// let turn = Scalar::height(&[0.0, 0.0], &[1.0, -1e-17], &[2.0, 0.0]);
    /// assert_eq!(turn, Some(0.5e-17));
    /// ```
    fn height(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Option<f64> {
        of_doubles([a, b, c]).and_then(|[a, b, c]| Scalar::height(&a, &b, &c))
    }

    /// The answer of [`orient2d`](Scalar::orient2d), and the stage that gave it.
    ///
    /// The sweep and the verifier call this one, and only where the floating-point filter has left the
    /// sign open. A type whose `orient2d` filters too skips its filter here.
    fn orient2d_exact(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> (Ordering, Stage) {
        (Self::orient2d(a, b, c), Stage::Own)
    }

    /// The answer of [`in_circle`](Scalar::in_circle), and the stage that gave it; see
    /// [`orient2d_exact`](Scalar::orient2d_exact).
    fn in_circle_exact(
        a: &[Self; 2],
        b: &[Self; 2],
        c: &[Self; 2],
        d: &[Self; 2],
    ) -> (Ordering, Stage) {
        (Self::in_circle(a, b, c, d), Stage::Own)
    }
}

/// The exact arithmetic that decided a sign where the floating-point filter did not.
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

/// The points as doubles, if these are the coordinates themselves.
fn of_doubles<S: Scalar, const N: usize>(points: [&[S; 2]; N]) -> Option<[[f64; 2]; N]> {
    let doubles = || points.map(|[x, y]| [x.approx(), y.approx()]);
    S::APPROX_IS_EXACT.then(doubles)
}

/// [`Scalar::orient2d`] for those who call it directly with a few points: the [`filter`] at the scale of these points,
/// then the exact stages.
///
/// The sweep and the verifier have one scale for all their points, and call the filter themselves.
fn filtered_orient2d<S: Scalar>(points: [&[S; 2]; 3]) -> Ordering {
    let (doubles, scale) = scaled(points);
    let filtered = filter::orient2d(doubles, scale);
    let filtered = filtered.or_else(|| filter::orient2d_approx(doubles, scale));
    filtered.unwrap_or_else(|| {
        let [a, b, c] = points;
        S::orient2d_exact(a, b, c).0
    })
}

/// The same for [`Scalar::in_circle`].
fn filtered_in_circle<S: Scalar>(points: [&[S; 2]; 4]) -> Ordering {
    let (doubles, scale) = scaled(points);
    let filtered = filter::in_circle(doubles, scale);
    let filtered = filtered.or_else(|| filter::in_circle_approx(doubles, scale));
    filtered.unwrap_or_else(|| {
        let [a, b, c, d] = points;
        S::in_circle_exact(a, b, c, d).0
    })
}

fn scaled<S: Scalar, const N: usize>(points: [&[S; 2]; N]) -> ([[f64; 2]; N], Scale) {
    let mut near = points.map(|[x, y]| [x.approx(), y.approx()]);
    let scale = Scale::unify(&mut near, S::APPROX_IS_EXACT);
    (near, scale)
}

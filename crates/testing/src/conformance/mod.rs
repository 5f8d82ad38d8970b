//! Whether a scalar keeps its promises: every function of [`Scalar`] on
//! many numbers, against determinants of big integers.
//!
//! | | file |
//! |---|---|
//! | points: random, extreme, on and near lines and circles, near and far from zero | `samples` |
//! | their signs and sizes as the definitions have them | `truth` |
//! | what is asked of the scalar, and what it may answer | `questions` |
//! | what is wrong | `nonconformity` |
//!
//! Why it is right: the numbers of a sample are integers times one unit, so that the signs are those of plain
//! determinants of these integers, which share no code with the predicates of this crate. It cannot show that a scalar
//! is right, only that it is wrong. So samples lie where scalars go wrong: at each number of bits up to 130, at the ends
//! of what machine integers hold, where differences vanish beside the coordinates, and where a determinant is zero or
//! as near to it as can be.
//!
//! Cost: some seconds without optimization, less than one with it.

mod nonconformity;
mod questions;
mod samples;
mod truth;

use num_rational::BigRational;
use sweep_cdt::scalar::Scalar;

pub use nonconformity::Nonconformity;
use questions::Questions;
use samples::samples;

/// So many samples must be numbers of the type.
const LEAST: usize = 100;

/// Tries whether a scalar of your own is exact where it must be, and as near as it must be elsewhere. Returns how many
/// answers were right. For tests.
///
/// `of` makes a number of the type of a fraction: exactly this one, or `None` where the type has no such number. The
/// fractions are integers of up to 600 bits times one of these units: 1, powers of two from 2^-200 to 2^300, powers of
/// ten from 10^-9, 1/3 and 1/7. At least the smaller ones of some unit must be numbers of the type.
///
/// # Errors
/// [`Nonconformity`]: the first wrong answer, with its call.
///
/// ```
/// use num_traits::ToPrimitive;
/// use sweep_cdt_testing::conformance::conformance;
///
/// let right = conformance(|x| x.is_integer().then(|| x.to_i64()).flatten());
/// assert!(right.is_ok_and(|answers| answers > 10_000));
/// ```
///
/// A fixed-point number that computes in its own 64 bits overflows, and is told where:
///
/// ```
/// use std::cmp::Ordering;
/// use num_traits::ToPrimitive;
/// use sweep_cdt::scalar::Scalar;
/// use sweep_cdt_testing::conformance::{Nonconformity, conformance};
///
/// struct Fixed(i64);
///
/// # fn minus([a, b]: &[Fixed; 2], [c, d]: &[Fixed; 2]) -> [i64; 2] {
/// #     [a.0.wrapping_sub(c.0), b.0.wrapping_sub(d.0)]
/// # }
/// impl Scalar for Fixed {
///     fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
///         let ([ax, ay], [bx, by]) = (minus(a, c), minus(b, c));
///         ax.wrapping_mul(by).cmp(&ay.wrapping_mul(bx))
///     }
///     // ...
/// #     fn approx(&self) -> f64 { self.0 as f64 / 65536.0 }
/// #     fn compare(&self, other: &Self) -> Ordering { self.0.cmp(&other.0) }
/// #     fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
/// #         let [a, b, c, d] = [a, b, c, d].map(|[x, y]| [x.0, y.0]);
/// #         Scalar::in_circle(&a, &b, &c, &d)
/// #     }
/// }
///
/// let fixed = |x: &num_rational::BigRational| {
///     let whole = x * num_bigint::BigInt::from(65536);
///     whole.is_integer().then(|| whole.to_i64().map(Fixed)).flatten()
/// };
/// let Err(Nonconformity::WrongAnswer { call, .. }) = conformance(fixed) else {
///     panic!("it overflows");
/// };
/// assert!(call.starts_with("orient2d(["));
/// ```
pub fn conformance<S: Scalar>(
    of: impl Fn(&BigRational) -> Option<S>,
) -> Result<usize, Nonconformity> {
    let (mut tried, mut answers) = (0, 0);
    for sample in samples(|number| of(number).is_some()) {
        let fractions = sample.fractions();
        let number = |x: &BigRational| of(x).ok_or(());
        let points = fractions
            .iter()
            .map(|[x, y]| Ok([number(x)?, number(y)?]))
            .collect::<Result<Vec<[S; 2]>, ()>>();
        if let Ok(points) = points {
            tried += 1;
            answers += Questions::new(&sample, &fractions, &points).ask()?;
        }
    }
    if tried < LEAST {
        return Err(Nonconformity::TooFewNumbers { tried });
    }
    Ok(answers)
}

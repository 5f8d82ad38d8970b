//! Sizes behind the signs, for which only the verifier's report asks: [`Scalar::depth`] and [`Scalar::height`]. Both are
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
//! sign is exact, and the size right in relative terms, down to the smallest double. Cost: big integers.

use super::Scalar;
use super::determinants::{Arithmetic, cross, determinant, dot, minus, square};
use super::doubles::{exponent, power};

/// A number, rounded: x and power for x * 2^power, if there is any telling.
type Near<T> = fn(&T) -> Option<(f64, i64)>;

/// The points as doubles, if doubles are the coordinates.
pub(super) fn coordinates<S: Scalar, const N: usize>(
    points: [&[S; 2]; N],
) -> Option<[[f64; 2]; N]> {
    let doubles = || points.map(|[x, y]| [x.approx(), y.approx()]);
    S::APPROX_IS_EXACT.then(doubles)
}

/// [`Scalar::depth`] of exact numbers.
pub(super) fn depth<T: Arithmetic>([a, b, c, d]: [&[T; 2]; 4], near: Near<T>) -> Option<f64> {
    let rows = [a, b, c].map(|p| minus(p, d));
    let [ab, bc, ca] = [minus(b, a), minus(c, b), minus(a, c)];
    let area = cross(&ab, &bc);
    let squares = [square(&ab), square(&bc), square(&ca)];
    quotient(4.0, &[determinant(&rows), area], &squares, near)
}

/// [`Scalar::height`] of exact numbers.
pub(super) fn height<T: Arithmetic>([a, b, c]: [&[T; 2]; 3], near: Near<T>) -> Option<f64> {
    let [ab, bc, ac] = [minus(b, a), minus(c, b), minus(c, a)];
    let goes_on = dot(&ab, &bc).sign().is_gt();
    let height = || quotient(1.0, &[cross(&ab, &bc)], &[square(&ac)], near);
    goes_on.then(height).flatten()
}

/// `first` times all of `over`, divided by all of `under`; `None` if one of these is zero.
fn quotient<T>(first: f64, over: &[T], under: &[T], near: Near<T>) -> Option<f64> {
    let (mut value, mut exponent) = (first, 0);
    for factor in under {
        let (x, power) = parts(near(factor)?);
        if x == 0.0 {
            return None;
        }
        (value, exponent) = (value / x, exponent - power);
    }
    for factor in over {
        let (x, power) = parts(near(factor)?);
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
fn parts((x, power): (f64, i64)) -> (f64, i64) {
    const MANTISSA: u64 = (1 << 52) - 1;
    let one = f64::from_bits(x.to_bits() & MANTISSA | 1.0_f64.to_bits());
    if x == 0.0 {
        (0.0, 0)
    } else {
        (one.copysign(x), exponent(x.abs()) + power)
    }
}

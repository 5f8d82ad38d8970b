//! The right answers, by the definitions, in whole numbers.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;

type Point = [BigInt; 2];

/// Twice the area of the triangle, positive if it is counter-clockwise.
pub(super) fn area([a, b, c]: [&Point; 3]) -> BigInt {
    let ([ux, uy], [vx, vy]) = (minus(b, a), minus(c, a));
    ux * vy - uy * vx
}

/// The in-circle determinant.
pub(super) fn determinant([a, b, c, d]: [&Point; 4]) -> BigInt {
    let [a, b, c] = [a, b, c].map(|p| minus(p, d));
    let minor = |[px, py]: &Point, [qx, qy]: &Point| px * qy - py * qx;
    square(&a) * minor(&b, &c) - square(&b) * minor(&a, &c) + square(&c) * minor(&a, &b)
}

/// The depth of the last point in the circle of the others, which are no line: 1 - |d - o|^2 / r^2.
pub(super) fn depth([a, b, c, d]: [&Point; 4]) -> BigRational {
    // The centre is a + (cx, cy) / 2 A, by Cramer's rule.
    let (u, v) = (minus(b, a), minus(c, a));
    let twice = area([a, b, c]) * 2;
    let center = [
        &v[1] * square(&u) - &u[1] * square(&v),
        &u[0] * square(&v) - &v[0] * square(&u),
    ];
    let to_d = minus(d, a);
    let offset = [0, 1].map(|i| &to_d[i] * &twice - &center[i]);
    let ratio = BigRational::new(square(&offset), square(&center));
    BigRational::from(BigInt::from(1)) - ratio
}

/// The height of the turn over the line from the first to the last point; `None` if it is one of a right angle or more.
pub(super) fn height([a, b, c]: [&Point; 3]) -> Option<BigRational> {
    let (first, second, all) = (minus(b, a), minus(c, b), minus(c, a));
    let forward = &first[0] * &second[0] + &first[1] * &second[1];
    let height = || BigRational::new(area([a, b, c]), square(&all));
    (forward > BigInt::ZERO).then(height)
}

/// Whether a number is near another: off by at most this part of it.
pub(super) fn is_near(near: &BigRational, exact: &BigRational, bits: u32) -> bool {
    let size = |x: BigRational| if x.numer() < &BigInt::ZERO { -x } else { x };
    let error = size(near - exact) * (BigInt::from(1) << bits);
    error <= size(exact.clone())
}

/// The sign.
pub(super) fn sign(number: &BigInt) -> Ordering {
    number.cmp(&BigInt::ZERO)
}

fn minus(a: &Point, b: &Point) -> Point {
    [0, 1].map(|i| &a[i] - &b[i])
}

fn square([x, y]: &Point) -> BigInt {
    x * x + y * y
}

//! Every predicate of every scalar against plain determinants of big integers.
//!
//! Here: the determinants, and points to try them on.

#![expect(clippy::cast_possible_truncation, reason = "chosen to fit")]

mod approximation;
mod conforming;
mod crude;
mod frames;
mod lattices;
mod predicates;
mod rounded;

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{ToPrimitive, Zero};
use sweep_cdt::scalar::{Scalar, in_circle, orient2d};
use sweep_cdt_testing::Random;

/// A random number from -1 up to, but not, 1.
fn signed_unit(random: &mut Random) -> f64 {
    2.0 * random.unit() - 1.0
}

/// Four points whose coordinates a function draws.
fn draw(random: &mut Random, mut coordinate: impl FnMut(&mut Random) -> f64) -> Points {
    [(); 4].map(|()| [(); 2].map(|()| coordinate(random)))
}

type Points = [[f64; 2]; 4];
type Exact = [[BigRational; 2]; 4];

fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

fn exact(points: &Points) -> Exact {
    points.map(|p| p.map(rational))
}

/// The determinants as written in the textbook, in a common unit: orientation of the first three
/// points, in-circle of all, order of the first two abscissas.
fn reference(points: &Exact) -> [Ordering; 3] {
    let mut denominators: Vec<&BigInt> = points.iter().flatten().map(BigRational::denom).collect();
    denominators.sort();
    let unit = denominators
        .into_iter()
        .rev()
        .fold(BigInt::from(1), |unit, d| {
            if (&unit % d).is_zero() {
                unit
            } else {
                unit * d
            }
        });
    let [p, q, r, s] = points
        .each_ref()
        .map(|p| p.each_ref().map(|x| x.numer() * (&unit / x.denom())));
    let difference = |p: &[BigInt; 2], q: &[BigInt; 2]| [&p[0] - &q[0], &p[1] - &q[1]];
    let cross = |p: &[BigInt; 2], q: &[BigInt; 2]| &p[0] * &q[1] - &p[1] * &q[0];
    let lift = |p: &[BigInt; 2]| &p[0] * &p[0] + &p[1] * &p[1];
    let turn = cross(&difference(&q, &p), &difference(&r, &p));
    let [a, b, c] = [&p, &q, &r].map(|x| difference(x, &s));
    let det = lift(&a) * cross(&b, &c) - lift(&b) * cross(&a, &c) + lift(&c) * cross(&a, &b);
    [
        turn.cmp(&BigInt::zero()),
        det.cmp(&BigInt::zero()),
        p[0].cmp(&q[0]),
    ]
}

fn check<S: Scalar>(points: &[[S; 2]; 4], expected: [Ordering; 3], what: &str) {
    let [a, b, c, d] = points;
    let near: Vec<f64> = points.iter().flatten().map(S::approx).collect();
    let scalar = std::any::type_name::<S>();
    let exact = (
        S::orient2d(a, b, c),
        S::in_circle(a, b, c, d),
        S::in_circle(b, a, c, d),
    );
    let filtered = (
        orient2d(a, b, c),
        in_circle(a, b, c, d),
        in_circle(b, a, c, d),
    );
    for (turn, circle, swapped) in [exact, filtered] {
        assert_eq!(turn, expected[0], "orient2d {scalar} {what} {near:?}");
        assert_eq!(circle, expected[1], "in_circle {scalar} {what} {near:?}");
        let reversed = expected[1].reverse();
        assert_eq!(swapped, reversed, "swapped {scalar} {what} {near:?}");
    }
    assert_eq!(
        a[0].compare(&b[0]),
        expected[2],
        "compare {scalar} {what} {near:?}"
    );
    assert!(points.iter().flatten().all(S::is_finite));
}

#[expect(clippy::float_cmp, reason = "asks for exact equality")]
fn check_all(points: &Points, what: &str) {
    let rationals = exact(points);
    let expected = reference(&rationals);
    check(points, expected, what);
    check(&rationals, expected, what);
    #[cfg(feature = "rug")]
    check(
        &points.map(|p| p.map(|x| rug::Rational::from_f64(x).unwrap())),
        expected,
        what,
    );
    if points.iter().flatten().all(|&x| f64::from(x as f32) == x) {
        check(&points.map(|p| p.map(|x| x as f32)), expected, what);
    }
    if points.iter().flatten().all(|&x| x.round() == x) {
        check(
            &rationals.clone().map(|p| p.map(|x| x.to_integer())),
            expected,
            what,
        );
    }
    if let Some(integers) = whole(&rationals, ToPrimitive::to_i64) {
        check(&integers, expected, what);
        check(
            &integers.map(|p| p.map(Ratio::from_integer)),
            expected,
            what,
        );
    }
    if let Some(integers) = whole(&rationals, ToPrimitive::to_i128) {
        check(&integers, expected, what);
    }
    if let Some(integers) = whole(&rationals, ToPrimitive::to_i32) {
        check(&integers, expected, what);
    }
}

fn whole<I: Copy + Default>(points: &Exact, to: fn(&BigInt) -> Option<I>) -> Option<[[I; 2]; 4]> {
    let mut result = [[I::default(); 2]; 4];
    for (to_set, x) in result.iter_mut().flatten().zip(points.iter().flatten()) {
        *to_set = x.is_integer().then(|| to(x.numer())).flatten()?;
    }
    Some(result)
}

fn nudge(x: f64, steps: i64) -> f64 {
    (0..steps.abs()).fold(x, |x, _| {
        if steps > 0 {
            x.next_up()
        } else {
            x.next_down()
        }
    })
}

/// Moves each coordinate by up to two units in the last place.
fn nudged(random: &mut Random, points: Points) -> Points {
    points.map(|p| p.map(|x| nudge(x, random.below(5) as i64 - 2)))
}

#[cfg(feature = "rug")]
fn to_rug(x: &BigRational) -> rug::Rational {
    let integer = |x: &BigInt| rug::Integer::from_str_radix(&x.to_str_radix(16), 16).unwrap();
    rug::Rational::from((integer(x.numer()), integer(x.denom())))
}

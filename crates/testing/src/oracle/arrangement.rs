//! Edges that cross, in fractions: every pair is tried, points are compared with `==`, and lines meet by Cramer's rule.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::graph::Graph;
use super::numbers::{Number, Point, cross, dot, vector};
use crate::with_integers;

/// A point in fractions.
pub type Exact = Point<BigRational>;

/// Points in fractions.
///
/// # Panics
/// If a coordinate is not finite.
pub fn fractions(points: &[[f64; 2]]) -> Vec<Exact> {
    let exact = |x| BigRational::from_float(x).expect("a finite number");
    points.iter().map(|point| point.map(exact)).collect()
}

/// All pairs of edges that cross at a point that is no vertex, sorted, each with that point.
pub fn crossings(points: &[Exact], edges: &[[usize; 2]]) -> Vec<([usize; 2], Exact)> {
    let mut pairs = with_integers!(points, |exact| Graph::new(&exact, edges).crossings());
    pairs.sort_unstable();
    let with_point = |pair: [usize; 2]| {
        let lines = pair.map(|e| edges[e].map(|v| &points[v]));
        (pair, meeting(lines))
    };
    pairs.into_iter().map(with_point).collect()
}

/// Where the lines a x + b y = c and d x + e y = f through two points each meet.
fn meeting(lines: [[&Exact; 2]; 2]) -> Exact {
    let [[a, b, c], [d, e, f]] = lines.map(|[p, q]| {
        let (a, b) = (&q[1] - &p[1], &p[0] - &q[0]);
        let c = &a * &p[0] + &b * &p[1];
        [a, b, c]
    });
    let determinant = &a * &e - &b * &d;
    [
        (&c * &e - &b * &f) / &determinant,
        (&a * &f - &c * &d) / &determinant,
    ]
}

/// For each edge the points along it, from its first end to its second: vertices and crossings, each once.
pub fn chains(points: &[Exact], edges: &[[usize; 2]]) -> Vec<Vec<Exact>> {
    let crossings = crossings(points, edges).into_iter();
    let all: Vec<Exact> = points
        .iter()
        .cloned()
        .chain(crossings.map(|(_, point)| point))
        .collect();
    let chains = with_integers!(&all, |exact| edges
        .iter()
        .map(|&edge| chain(&exact, edge))
        .collect());
    let chains: Vec<Vec<usize>> = chains;
    let named = |chain: Vec<usize>| chain.into_iter().map(|v| all[v].clone()).collect();
    chains.into_iter().map(named).collect()
}

/// The points on an edge, from its first end to its second, of equal ones the first.
fn chain<N: Number>(points: &[Point<N>], ends: [usize; 2]) -> Vec<usize> {
    let [a, b] = ends.map(|v| &points[v]);
    let to = vector(a, b);
    let along = |p: &Point<N>| dot(&vector(a, p), &to);
    let length = along(b);
    let is_on = |p: &Point<N>| {
        let is_between = || !along(p).is_negative() && along(p) <= length;
        cross(&vector(a, p), &to).is_zero()
            && if length.is_zero() {
                p == a
            } else {
                is_between()
            }
    };
    let mut chain: Vec<usize> = (0..points.len()).filter(|&v| is_on(&points[v])).collect();
    chain.sort_by_key(|&v| along(&points[v]));
    chain.dedup_by(|v, w| points[*v] == points[*w]);
    chain
}

/// Whether no double is nearer, and where another one is as near, this one has an even last bit.
pub fn is_nearest(double: f64, exact: &BigRational) -> bool {
    let fraction = BigRational::from_float;
    let Some(double_exact) = fraction(double) else {
        return false;
    };
    // Which side of the place halfway to the next double it is on.
    let twice = exact + exact;
    let side = |next: f64| fraction(next).map(|next| twice.cmp(&(&double_exact + next)));
    let is_even = double.to_bits().is_multiple_of(2);
    let allows = |side: Option<Ordering>, allowed: Ordering| {
        side.is_none_or(|side| side == allowed || side == Ordering::Equal && is_even)
    };
    allows(side(double.next_down()), Ordering::Greater)
        && allows(side(double.next_up()), Ordering::Less)
}

/// The distance of the doubles next to a number of this size, away from zero.
///
/// # Panics
/// If the number is not finite, or the largest one.
pub fn unit(x: f64) -> BigRational {
    let bits = x.abs().to_bits();
    // Bits of the exponent: 0 and 1 have the same spacing, the smallest.
    let exponent = i32::try_from((bits >> 52).max(1)).expect("eleven bits") - 1075;
    let power = BigInt::one() << exponent.unsigned_abs();
    if exponent < 0 {
        BigRational::new(BigInt::one(), power)
    } else {
        BigRational::from(power)
    }
}

/// The least d so that a point of the segment differs from `p` by at most d times `units` in x and y.
///
/// The greater one of two differences is least where both are equal in size, or where one is zero, or at an end: all
/// these places are tried.
pub fn distance(p: &Exact, [a, b]: [&Exact; 2], units: &Exact) -> BigRational {
    let [to, along] = [p, b].map(|q| [0, 1].map(|i| (&q[i] - &a[i]) / &units[i]));
    // As integers over one denominator, so that no step reduces a fraction.
    let all = || to.iter().chain(&along);
    let scale = all().fold(BigInt::one(), |product, x| product.lcm(x.denom()));
    let integer = |x: &BigRational| x.numer() * (&scale / x.denom());
    let [to, along] = [&to, &along].map(|vector| vector.each_ref().map(integer));
    let quotients = [
        (to[0].clone(), along[0].clone()),
        (to[1].clone(), along[1].clone()),
        (&to[0] - &to[1], &along[0] - &along[1]),
        (&to[0] + &to[1], &along[0] + &along[1]),
    ];
    // Places on the segment, over / under.
    let places = quotients.into_iter().filter(|(_, under)| !under.is_zero());
    let ends = [
        (BigInt::zero(), BigInt::one()),
        (BigInt::one(), BigInt::one()),
    ];
    let clamped = places.map(|(over, under)| {
        let (over, under) = (over * under.signum(), under.abs());
        (over.clamp(BigInt::zero(), under.clone()), under)
    });
    let off = |(over, under): (BigInt, BigInt)| {
        let [x, y] = [0, 1].map(|i| (&to[i] * &under - &over * &along[i]).abs());
        (x.max(y), under)
    };
    let is_less = |one: &(BigInt, BigInt), other: &(BigInt, BigInt)| {
        (&one.0 * &other.1).cmp(&(&other.0 * &one.1))
    };
    let least = clamped.chain(ends).map(off).min_by(is_less);
    let (over, under) = least.expect("two ends");
    BigRational::new(over, under * scale)
}

//! Edges that cross, in fractions: every pair is tried, points are compared with `==`, and lines meet by Cramer's rule.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::graph::Graph;
use super::numbers::Point;

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
    let mut pairs = Graph::new(points, edges).crossings();
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
    let crossings = crossings(points, edges);
    let chain = |ends: &[usize; 2]| {
        let [a, b] = ends.map(|v| &points[v]);
        let along =
            |p: &Exact| (&p[0] - &a[0]) * (&b[0] - &a[0]) + (&p[1] - &a[1]) * (&b[1] - &a[1]);
        let length = along(b);
        let is_on = |p: &&Exact| {
            let area = (&p[0] - &a[0]) * (&b[1] - &a[1]) - (&p[1] - &a[1]) * (&b[0] - &a[0]);
            let inside = !along(p).is_negative() && along(p) <= length;
            area.is_zero() && if length.is_zero() { *p == a } else { inside }
        };
        let all = points
            .iter()
            .chain(crossings.iter().map(|(_, point)| point));
        let mut chain: Vec<Exact> = all.filter(is_on).cloned().collect();
        chain.sort_by_key(along);
        chain.dedup();
        chain
    };
    edges.iter().map(chain).collect()
}

/// Whether no double is nearer, and where another one is as near, this one has an even last bit.
pub fn is_nearest(double: f64, exact: &BigRational) -> bool {
    let off = |x: f64| BigRational::from_float(x).map(|x| (x - exact).abs());
    let Some(distance) = off(double) else {
        return false;
    };
    let is_even = double.to_bits().is_multiple_of(2);
    [double.next_down(), double.next_up()]
        .into_iter()
        .filter_map(off)
        .all(|other| distance < other || distance == other && is_even)
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
    let off = |t: &BigRational| {
        let [x, y] = [0, 1].map(|i| (&to[i] - t * &along[i]).abs());
        x.max(y)
    };
    let quotients = [
        (to[0].clone(), along[0].clone()),
        (to[1].clone(), along[1].clone()),
        (&to[0] - &to[1], &along[0] - &along[1]),
        (&to[0] + &to[1], &along[0] + &along[1]),
    ];
    let places = quotients.into_iter().filter(|(_, under)| !under.is_zero());
    let (zero, one) = (BigRational::zero(), BigRational::one());
    let places = places.map(|(over, under)| (over / under).clamp(zero.clone(), one.clone()));
    let places: Vec<BigRational> = places.collect();
    let ends = [BigRational::zero(), BigRational::one()];
    let all = places.iter().chain(&ends).map(off);
    all.min().expect("two ends")
}

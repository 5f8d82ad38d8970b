//! Exact numbers: doubles and fractions as integers of one scale, and the three predicates on them.

use std::cmp::Ordering;

use bnum::types::I256;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Float, One, Signed, Zero};

/// An exact number: an integer that does not overflow on the inputs at hand.
pub trait Number: Signed + Ord + Clone {}
impl<T: Signed + Ord + Clone> Number for T {}

/// A point.
pub type Point<N> = [N; 2];

/// Points as integers: 128 or 256 bits where the predicates fit in, else as many as it takes.
pub enum Integers {
    /// Small ones.
    Small(Vec<Point<i128>>),
    /// Points such as doubles of about the same size.
    Medium(Vec<Point<I256>>),
    /// Large ones.
    Big(Vec<Point<BigInt>>),
}

/// The value of an expression for points as [`integers`], whichever of the three kinds they are.
#[macro_export]
macro_rules! with_integers {
    ($points:expr, |$exact:ident| $value:expr) => {
        match $crate::oracle::integers($points) {
            $crate::oracle::Integers::Small($exact) => $value,
            $crate::oracle::Integers::Medium($exact) => $value,
            $crate::oracle::Integers::Big($exact) => $value,
        }
    };
}

/// With coordinates of this many bits, products of four differences (two of them of twice the length) and
/// a few sums fit in an `i128`.
const SMALL_BITS: u64 = 28;
/// With coordinates of this many bits, those products and sums fit in an `I256`.
const MEDIUM_BITS: u64 = 60;

/// The points multiplied by one positive number that makes them integers, small ones if that can be.
pub fn integers<C: Coordinate>(points: &[Point<C>]) -> Integers {
    C::integers(points)
}

/// A coordinate of points that can be made integers.
pub trait Coordinate: Sized {
    /// What [`integers`] returns.
    fn integers(points: &[Point<Self>]) -> Integers;
}

impl Coordinate for f64 {
    /// Multiplied by the one power of two that makes them the smallest integers.
    fn integers(points: &[[f64; 2]]) -> Integers {
        let parts = |x: f64| {
            let (mantissa, exponent, sign) = Float::integer_decode(x);
            let zeros = if mantissa == 0 {
                0
            } else {
                mantissa.trailing_zeros()
            };
            (
                i64::from(sign) * (mantissa >> zeros).cast_signed(),
                i32::from(exponent) + zeros.cast_signed(),
            )
        };
        let coordinates = || {
            points
                .iter()
                .flatten()
                .map(|&x| parts(x))
                .filter(|part| part.0 != 0)
        };
        let least = coordinates()
            .map(|(_, exponent)| exponent)
            .min()
            .unwrap_or(0);
        let shift = |exponent: i32| (exponent - least).unsigned_abs();
        let bits = coordinates()
            .map(|(m, e)| m.unsigned_abs().ilog2() + 1 + shift(e))
            .max()
            .unwrap_or(0);
        if u64::from(bits) <= SMALL_BITS {
            let integer = |x| match parts(x) {
                (0, _) => 0,
                (mantissa, exponent) => i128::from(mantissa) << shift(exponent),
            };
            Integers::Small(points.iter().map(|p| p.map(integer)).collect())
        } else if u64::from(bits) <= MEDIUM_BITS {
            let integer = |x| match parts(x) {
                (0, _) => I256::zero(),
                (mantissa, exponent) => I256::from(mantissa) << shift(exponent),
            };
            Integers::Medium(points.iter().map(|p| p.map(integer)).collect())
        } else {
            let integer = |x| match parts(x) {
                (0, _) => BigInt::zero(),
                (mantissa, exponent) => BigInt::from(mantissa) << shift(exponent),
            };
            Integers::Big(points.iter().map(|p| p.map(integer)).collect())
        }
    }
}

/// The least common denominator of fractions.
pub fn common_denominator<'a>(fractions: impl Iterator<Item = &'a BigRational>) -> BigInt {
    fractions.fold(BigInt::one(), |product, x| {
        match (&product % x.denom()).is_zero() {
            true => product,
            false => product.lcm(x.denom()),
        }
    })
}

impl Coordinate for BigRational {
    /// Multiplied by the least common denominator, and divided by the largest power of two that divides them all.
    ///
    /// What follows costs a few products of long integers. Fractions would be reduced after each step, which costs
    /// the square of their length.
    fn integers(points: &[Point<BigRational>]) -> Integers {
        let denominator = common_denominator(points.iter().flatten());
        let integer = |x: &BigRational| x.numer() * (&denominator / x.denom());
        let mut points: Vec<Point<BigInt>> =
            points.iter().map(|p| p.each_ref().map(integer)).collect();
        let zeros = points.iter().flatten().filter_map(BigInt::trailing_zeros);
        let zeros = zeros.min().unwrap_or(0);
        for x in points.iter_mut().flatten() {
            *x >>= zeros;
        }
        let bits = points.iter().flatten().map(BigInt::bits).max();
        let bits = bits.unwrap_or(0);
        if bits <= SMALL_BITS {
            let integer = |x: &BigInt| i128::try_from(x).expect("few bits");
            let small = points.iter().map(|p| p.each_ref().map(integer));
            Integers::Small(small.collect())
        } else if bits <= MEDIUM_BITS {
            let integer = |x: &BigInt| I256::from(i64::try_from(x).expect("few bits"));
            let medium = points.iter().map(|p| p.each_ref().map(integer));
            Integers::Medium(medium.collect())
        } else {
            Integers::Big(points)
        }
    }
}

/// `a` to `b` as a vector.
pub(super) fn vector<N: Number>(a: &Point<N>, b: &Point<N>) -> Point<N> {
    [b[0].clone() - a[0].clone(), b[1].clone() - a[1].clone()]
}

pub(super) fn dot<N: Number>(u: &Point<N>, v: &Point<N>) -> N {
    u[0].clone() * v[0].clone() + u[1].clone() * v[1].clone()
}

pub(super) fn cross<N: Number>(u: &Point<N>, v: &Point<N>) -> N {
    u[0].clone() * v[1].clone() - u[1].clone() * v[0].clone()
}

pub(super) fn sign<N: Number>(x: &N) -> Ordering {
    x.cmp(&N::zero())
}

/// `Greater` if `a`, `b`, `c` turn left.
pub(super) fn orient<N: Number>(a: &Point<N>, b: &Point<N>, c: &Point<N>) -> Ordering {
    sign(&cross(&vector(a, b), &vector(a, c)))
}

/// `Greater` if `d` lies inside the circle through `a`, `b`, `c`, which turn left.
pub(super) fn in_circle<N: Number>(
    a: &Point<N>,
    b: &Point<N>,
    c: &Point<N>,
    d: &Point<N>,
) -> Ordering {
    let [a, b, c] = [a, b, c].map(|p| vector(d, p));
    let lift = |v: &Point<N>| v[0].clone() * v[0].clone() + v[1].clone() * v[1].clone();
    sign(&(lift(&a) * cross(&b, &c) + lift(&b) * cross(&c, &a) + lift(&c) * cross(&a, &b)))
}

/// The order of the symbolic perturbation: leftmost first, the upper one of two.
pub(super) fn lowering<N: Number>(a: &Point<N>, b: &Point<N>) -> Ordering {
    a[0].cmp(&b[0]).then_with(|| b[1].cmp(&a[1]))
}

/// The order of the sweep: lowest first, the left one of two.
pub(super) fn sweep<N: Number>(a: &Point<N>, b: &Point<N>) -> Ordering {
    a[1].cmp(&b[1]).then_with(|| a[0].cmp(&b[0]))
}

/// [`in_circle`] of points lifted to the paraboloid and lowered a little, the first in the order of
/// [`lowering`] by far the most. Hence never `Equal` for four different points: of four on a circle,
/// lowering one of `a`, `b`, `c` tilts their plane, which sinks at `d` if that point and `d` lie on
/// the same side of the line through the other two, and rises otherwise.
pub(super) fn in_lowered_circle<N: Number>(
    a: &Point<N>,
    b: &Point<N>,
    c: &Point<N>,
    d: &Point<N>,
) -> Ordering {
    let exact = in_circle(a, b, c, d);
    if exact != Ordering::Equal {
        return exact;
    }
    let least = [a, b, c, d]
        .into_iter()
        .min_by(|p, q| lowering(p, q))
        .expect("four points");
    if least == d {
        Ordering::Greater
    } else if least == a {
        orient(b, c, d).reverse()
    } else if least == b {
        orient(c, a, d).reverse()
    } else {
        orient(a, b, d).reverse()
    }
}

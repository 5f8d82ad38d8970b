//! The same points as whole numbers, and as numbers that are hard to hold.
//!
//! None of these changes turns or circles: one positive factor for all coordinates, and one number that
//! is added to all.

use bnum::types::I256;
use num_bigint::BigInt;
use num_rational::BigRational;

use sweep_cdt_testing::oracle::{self, Integers};

type Whole = [BigInt; 2];

/// The points in the unit that makes them the smallest integers.
pub(super) fn integers(points: &[[f64; 2]]) -> Vec<Whole> {
    let widened = |x: I256| x.to_string().parse().expect("an integer");
    match oracle::integers(points) {
        Integers::Small(points) => points.iter().map(|p| p.map(BigInt::from)).collect(),
        Integers::Medium(points) => points.iter().map(|p| p.map(widened)).collect(),
        Integers::Big(points) => points,
    }
}

/// Rationals far from zero, where they need a bit more than a double or a machine's integer has.
pub(super) fn moved(points: &[Whole], number: usize) -> Vec<[BigRational; 2]> {
    const FAR: [i128; 8] = [
        1 << 53,
        -(1 << 53),
        (1 << 54) + 1,
        (1 << 61) - 1,
        -(1 << 62),
        1 << 63,
        (1 << 64) + 1,
        1 << 100,
    ];
    let by = BigInt::from(FAR[number % FAR.len()]);
    each(points, |x| BigRational::from_integer(x + &by))
}

/// Fractions, reduced or as they are; their denominators are alike or not, and may be below zero.
pub(super) fn divided(points: &[Whole], number: usize) -> Vec<[BigRational; 2]> {
    const DIVISORS: [u64; 8] = [3, 7, 10, 49, 60, 1_000_000_007, (1 << 53) + 1, u64::MAX];
    let divisor = BigInt::from(DIVISORS[number % DIVISORS.len()]);
    let style = number / DIVISORS.len();
    let mut factor = BigInt::from(if style & 1 == 0 { 1 } else { -1 });
    each(points, |x| {
        if style & 2 == 0 {
            return BigRational::new(x.clone(), divisor.clone());
        }
        if style & 4 == 0 {
            factor = 4 - &factor;
        }
        BigRational::new_raw(x * &factor, &divisor * &factor)
    })
}

/// Over the whole range of `i64`, if they do not need more.
pub(super) fn stretched(points: &[Whole]) -> Option<Vec<[i64; 2]>> {
    let coordinates = || points.iter().flatten();
    let (low, high) = (coordinates().min()?, coordinates().max()?);
    let span = (high - low).max(1.into());
    let factor = BigInt::from(u64::MAX) / span;
    let stretched = |x: &BigInt| i64::try_from((x - low) * &factor + i64::MIN);
    let points = points.iter().map(|p| p.each_ref().map(stretched));
    let points = points.map(|[x, y]| [x, y].map(|x| x.expect("it is in the range")));
    (factor > BigInt::ZERO).then(|| points.collect())
}

fn each<T>(points: &[Whole], mut number: impl FnMut(&BigInt) -> T) -> Vec<[T; 2]> {
    points
        .iter()
        .map(|p| p.each_ref().map(&mut number))
        .collect()
}

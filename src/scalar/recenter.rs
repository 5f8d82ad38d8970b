//! The doubles for all points of one input: approximations of the coordinates, or of their differences to an *origin*.
//! Approximations of the coordinates cannot tell points apart that are close to each other and far from zero, or all
//! too large or too small for doubles: different coordinates have the same double. Where a sample shows that, the
//! origin is the middle coordinate of that axis, and the doubles approximate the differences to it
//! ([`Scalar::difference`]). Signs do not change if all points are moved.
//!
//! An axis is moved only if that leaves at least as many different doubles as before: half of the points in one column
//! must not cost the others their digits. Doubles as coordinates are never moved, so all scalars take the same steps.
//! Why it is right: any doubles do, as long as they never fall where the coordinate grows, and are off by no more than
//! their [`Scale`] says. Differences are off by a part of themselves (`difference`), at any power of two in range.
//! Cost: little to look; for each axis that is moved n differences and two sorts of doubles.

use alloc::vec::Vec;
use core::num::FpCategory;

use super::doubles::{self, exponent, power};
use super::{Scalar, Scale};
use crate::tuning::SAMPLE_OF_AXIS;

/// The coordinates along one axis: for each point a double times a power of two.
type Axis = Vec<(f64, i64)>;

/// Turns approximations into the doubles that the filter gets. Doubles of points that are not finite mean nothing.
pub(crate) fn recenter<S: Scalar>(points: &[[S; 2]], approx: &mut [[f64; 2]]) -> Scale {
    if S::APPROX_IS_EXACT {
        return Scale::of_coordinates(approx);
    }
    match [0, 1].map(|i| moved(points, approx, i)) {
        [None, None] => Scale::unify(approx, false),
        axes => place(approx, axes),
    }
}

/// The differences to an origin along axis `i`, if they tell more than the approximations.
fn moved<S: Scalar>(points: &[[S; 2]], approx: &[[f64; 2]], i: usize) -> Option<Axis> {
    if !is_blurred(points, approx, i) {
        return None;
    }
    let mut order: Vec<usize> = (0..points.len())
        .filter(|&v| points[v][i].is_finite())
        .collect();
    let middle = order.len() / 2;
    if order.is_empty() {
        return None;
    }
    let (_, &mut middle, _) =
        order.select_nth_unstable_by(middle, |&a, &b| approx[a][i].total_cmp(&approx[b][i]));
    let origin = &points[middle][i];
    let difference = |point: &[S; 2]| {
        if point[i].is_finite() {
            point[i].difference(origin)
        } else {
            Some((0.0, 0))
        }
    };
    let axis: Axis = points
        .iter()
        .map(|point| difference(point).map(normal))
        .collect::<Option<_>>()?;
    let before = distinct(plain(approx, i));
    (distinct(axis.iter().copied()) >= before).then_some(axis)
}

/// Whether two different coordinates of axis `i`, of a sample, have the same double.
fn is_blurred<S: Scalar>(points: &[[S; 2]], approx: &[[f64; 2]], i: usize) -> bool {
    let double = |v: usize| approx[v][i].clamp(f64::MIN, f64::MAX);
    let step = points.len().div_ceil(SAMPLE_OF_AXIS).max(1);
    let mut order: Vec<usize> = (0..points.len())
        .step_by(step)
        .filter(|&v| points[v][i].is_finite())
        .collect();
    order.sort_unstable_by(|&a, &b| double(a).total_cmp(&double(b)));
    order.windows(2).any(|pair| {
        let [a, b] = [pair[0], pair[1]];
        double(a).total_cmp(&double(b)).is_eq() && points[a][i].compare(&points[b][i]).is_ne()
    })
}

/// How many different numbers there are; equal ones have equal bits.
fn distinct(numbers: impl Iterator<Item = (f64, i64)>) -> usize {
    let mut bits: Vec<(u64, i64)> = numbers.map(|(x, power)| (x.to_bits(), power)).collect();
    bits.sort_unstable();
    bits.dedup();
    bits.len()
}

/// The approximations of axis `i`, infinite where nothing is known.
fn plain(approx: &[[f64; 2]], i: usize) -> impl Iterator<Item = (f64, i64)> {
    let known = |x: f64| if x.abs() < f64::MAX { x } else { x * 2.0 };
    approx.iter().map(move |x| normal((known(x[i]), 0)))
}

/// A number with a double from 1 to 2 in size, if it is neither zero nor infinite.
fn normal((x, by): (f64, i64)) -> (f64, i64) {
    let (x, by) = match x.classify() {
        FpCategory::Normal => (x, by),
        FpCategory::Subnormal => (x * power(100), by.saturating_sub(100)),
        _ => return (x, 0),
    };
    let e = exponent(x.abs());
    // In two steps, since one factor might be beyond the doubles.
    let one_to_two = x * power(-e / 2) * power(-e + e / 2);
    (one_to_two, by.saturating_add(e))
}

/// Brings the axes to one scale. An axis that is not moved keeps its approximations.
fn place(approx: &mut [[f64; 2]], axes: [Option<Axis>; 2]) -> Scale {
    let is_plain = axes.iter().any(Option::is_none);
    let [x, y] = axes;
    let x = x.unwrap_or_else(|| plain(approx, 0).collect());
    let y = y.unwrap_or_else(|| plain(approx, 1).collect());
    let known = x.iter().chain(&y).filter(|(x, _)| x.is_normal());
    let mut shift = doubles::shift(known.map(|&(_, by)| by));
    let mut unit = 1.0;
    if is_plain {
        // Approximations below the normal doubles are scaled together with their errors.
        shift = shift.clamp(-1022, 1000);
        unit = power(shift);
    }
    for (approx, (x, y)) in approx.iter_mut().zip(x.into_iter().zip(y)) {
        *approx = [scaled(x, shift), scaled(y, shift)];
    }
    Scale::rounded(unit)
}

/// The number, which is [`normal`], times 2^`shift`.
fn scaled((x, by): (f64, i64), shift: i64) -> f64 {
    match by.saturating_add(shift) {
        _ if x == 0.0 => 0.0,
        ..-1022 => 0.0,
        by @ -1022..200 => x * power(by),
        200.. => x * f64::INFINITY,
    }
}

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;
    use num_rational::BigRational;
    use num_traits::One;

    use super::recenter;
    use crate::scalar::Scalar;

    /// Most points in a column far from zero, the others close to zero: the column is no origin.
    #[test]
    fn a_column_costs_the_others_no_digits() {
        let unit = BigRational::new(BigInt::one(), BigInt::from(10).pow(40));
        let x = |i: u32| {
            if i.is_multiple_of(5) {
                &unit * BigInt::from(i)
            } else {
                BigRational::one()
            }
        };
        let points: Vec<_> = (0..100).map(|i| [x(i), &unit * BigInt::from(i)]).collect();
        let mut approx: Vec<_> = points
            .iter()
            .map(|p| p.each_ref().map(Scalar::approx))
            .collect();
        recenter(&points, &mut approx);
        let others: Vec<[f64; 2]> = approx.into_iter().step_by(5).collect();
        assert!(others.windows(2).all(|pair| pair[0][0] < pair[1][0]));
    }
}

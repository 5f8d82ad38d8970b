//! What a few points far away, and points far from zero, cost the filter and the front: counted signs and
//! steps, never the clock.

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use sweep_cdt::scalar::{Scalar, Unbounded};
use sweep_cdt::verify::verify;
use sweep_cdt::{Counters, Triangulator};
use sweep_cdt_testing::counted;

use super::crude::Crude;
use super::*;

/// The work for these points; panics unless the verifier finds the result right.
fn work<S: Scalar>(points: &[[S; 2]]) -> Work {
    let run = counted(&Triangulator::new(), points, &[]);
    let run = run.expect("no edges");
    let triangles: Vec<_> = run.triangulation.triangles().collect();
    let report = verify(points, &[], &triangles).expect("a right result");
    let counters: Counters = run.stats.counters;
    Work {
        exact: counters.orient2d_exact() + counters.in_circle_exact(),
        steps: counters.front_steps,
        verified_exact: report.exact,
    }
}

#[derive(Debug)]
struct Work {
    /// Signs that the filter left open.
    exact: u64,
    steps: u64,
    /// Signs that the filter left open in the verifier.
    verified_exact: u64,
}

const COUNT: usize = 5000;

/// The outlier itself has a few sides, the others none that the filter leaves open.
#[test]
fn one_outlier_costs_the_others_nothing() {
    let plain = Random::new(1).points(COUNT);
    let expected = work(&plain).steps;
    for unit in [1.0, 1e-20, 1e-60, 1e-200, 1e60] {
        for outlier in [
            [f64::MAX, f64::MAX],
            [-f64::MAX, 0.5 * unit],
            [0.5 * unit, f64::MAX],
            [1e30, -1e30],
            [-9999.0, -9999.0],
            [5e-324, 1.0],
        ] {
            let mut points: Vec<_> = plain.iter().map(|p| p.map(|x| x * unit)).collect();
            points.push(outlier);
            let found = work(&points);
            let what = format!("{outlier:?} beside {unit}: {found:?}");
            assert!(found.exact < 400, "{what}");
            assert!(found.verified_exact < 400, "{what}");
            assert!(found.steps < expected + expected / 4, "{what}");
        }
    }
}

/// Several far away, whose doubles become equal ones.
#[test]
fn outliers_are_told_apart() {
    let mut points = Random::new(2).points(1000);
    for i in 1..=8 {
        let far = 1e300 * f64::from(i);
        points.extend([[far, 0.5], [0.5, -far], [far, far], [-far, far]]);
    }
    points.extend_from_within(1000..1010);
    let result = Triangulator::new()
        .triangulate(&points, &[])
        .expect("no edges");
    assert_eq!(result.duplicates().len(), 10);
    work(&points);
}

/// Points all over a square whose corner is the same for all.
fn at<S>(place: impl Fn(i64) -> S) -> Vec<[S; 2]> {
    let points = Random::new(3).points(1000).into_iter();
    points.map(|p| p.map(|x| place((x * 1e6) as i64))).collect()
}

/// No sign is left open, and no walk is long.
fn check_filtered<S: Scalar>(points: &[[S; 2]], what: &str) {
    let found = work(points);
    assert!(found.exact + found.verified_exact < 20, "{what}: {found:?}");
    assert!(found.steps < 2 * points.len() as u64, "{what}: {found:?}");
}

#[test]
fn points_close_together_and_far_from_zero() {
    let tiny = |digits: u32| BigRational::new(1.into(), BigInt::from(10).pow(digits));
    let one = BigRational::from(BigInt::from(1));
    for digits in [31, 400, 1500] {
        let points = at(|x| &one + tiny(digits) * BigInt::from(x));
        check_filtered(&points, "rationals near 1");
        #[cfg(feature = "rug")]
        check_filtered(
            &points
                .into_iter()
                .map(|p| p.map(|x| to_rug(&x)))
                .collect::<Vec<_>>(),
            "rug near 1",
        );
    }
    check_filtered(&at(|x| (1 << 62) + x), "i64");
    check_filtered(&at(|x| (1 << 126) + i128::from(x)), "i128");
    check_filtered(&at(|x| (BigInt::from(1) << 90) + x), "BigInt");
    let crude = at(|x| Crude::<true>(&one + tiny(31) * BigInt::from(x)));
    check_filtered(&crude, "a number of one's own");
}

#[test]
fn points_beyond_the_doubles_and_one_that_is_not() {
    let third = BigRational::new(1.into(), 3.into());
    for digits in [400, 1500] {
        let unit = BigInt::from(10).pow(digits);
        let huge = |x: i64| &unit * BigInt::from(x);
        check_filtered(&at(huge), "huge BigInt");
        let mut points = at(|x| BigRational::from(huge(x)));
        points.push([third.clone(), third.clone()]);
        check_filtered(&points, "huge rationals and a third");
        let tiny = at(|x| BigRational::new(x.into(), unit.clone()));
        check_filtered(&tiny, "tiny rationals");
    }
}

/// The contract of `difference`, for numbers in ascending order.
fn check_difference<S: Scalar>(numbers: &[(S, BigRational)]) {
    let tolerance = BigRational::new(1.into(), BigInt::from(1) << 52);
    let exactly = |(x, power): (f64, i64)| {
        let size = BigInt::from(1) << power.unsigned_abs();
        if power < 0 {
            rational(x) / size
        } else {
            rational(x) * size
        }
    };
    for (origin, exact_origin) in numbers.iter().step_by(7) {
        let mut before: Option<BigRational> = None;
        for (number, exact) in numbers {
            let near = exactly(number.difference(origin).expect("it is known"));
            let exact = exact - exact_origin;
            let [error, size] = [&near - &exact, exact].map(|x| x.clone().max(-x));
            assert!(error <= &size * &tolerance, "{near} {size}");
            assert!(before.is_none_or(|before| before <= near), "{near}");
            before = Some(near);
        }
    }
}

#[test]
fn differences() {
    let mut random = Random::new(4);
    let mut numbers: Vec<BigRational> = Vec::new();
    for _ in 0..120 {
        let bits = random.below(400) as u32;
        let shift = random.below(300);
        let product = BigInt::from(random.bits()) * BigInt::from(random.bits() | 1);
        let whole = (product << bits) >> shift;
        let signed = if random.one_in(2) { whole } else { -whole };
        let denominator = BigInt::from(random.bits() >> random.below(64)) + 1;
        let number = BigRational::new(signed, denominator);
        // Neighbours that differ by little.
        let little = BigRational::new(1.into(), BigInt::from(1) << random.below(500));
        numbers.extend([&number + &little, &number - &little, number]);
    }
    numbers.extend([-1, 0, 1].map(|x| BigRational::from(BigInt::from(x))));
    numbers.sort();
    let pairs = |numbers: &[BigRational]| -> Vec<_> {
        numbers.iter().map(|x| (x.clone(), x.clone())).collect()
    };
    check_difference(&pairs(&numbers));
    #[cfg(feature = "rug")]
    check_difference(
        &numbers
            .iter()
            .map(|x| (to_rug(x), x.clone()))
            .collect::<Vec<_>>(),
    );
    let integers: Vec<_> = numbers.iter().map(BigRational::trunc).collect();
    let whole = |x: &BigRational| (x.to_integer(), x.clone());
    check_difference(&integers.iter().map(whole).collect::<Vec<_>>());
    let mut small: Vec<i64> = (0..200)
        .map(|_| random.bits().cast_signed() >> random.below(64))
        .collect();
    small.extend([i64::MIN, i64::MAX, 0]);
    small.sort_unstable();
    let exact = |&x: &i64| (x, BigRational::from(BigInt::from(x)));
    check_difference(&small.iter().map(exact).collect::<Vec<_>>());
    let mut wide: Vec<i128> = small
        .iter()
        .map(|&x| i128::from(x) << random.below(64))
        .collect();
    wide.extend([i128::MIN, i128::MAX, 0]);
    wide.sort_unstable();
    let exact = |&x: &i128| (x, BigRational::from(BigInt::from(x)));
    check_difference(&wide.iter().map(exact).collect::<Vec<_>>());
    let mut ratios: Vec<Ratio<i64>> = small
        .iter()
        .map(|&x| {
            Ratio::new(
                x.max(-i64::MAX),
                1 + (random.bits() >> 1 >> random.below(63)).cast_signed() / 2,
            )
        })
        .collect();
    let exact = |x: &Ratio<i64>| BigRational::new((*x.numer()).into(), (*x.denom()).into());
    ratios.sort_by_key(exact);
    let pair = |x: &Ratio<i64>| (*x, exact(x));
    check_difference(&ratios.iter().map(pair).collect::<Vec<_>>());
    #[cfg(feature = "rug")]
    {
        let whole = |x: &BigRational| (to_rug(x).into_numer_denom().0, x.trunc());
        let integers: Vec<_> = numbers.iter().map(BigRational::trunc).collect();
        check_difference(&integers.iter().map(whole).collect::<Vec<_>>());
    }
}

/// What the default takes for near must not be lost or rounded to the largest double.
#[test]
fn numbers_at_the_ends_of_the_doubles_are_not_said_to_be_near() {
    let at = |power: i32| {
        BigRational::from(BigInt::from(3)) * BigRational::from(BigInt::from(2)).pow(power)
    };
    for (power, is_known) in [
        (0, true),
        (-900, true),
        (1000, true),
        (-1030, false),
        (1100, false),
    ] {
        assert_eq!(
            Unbounded::near(&Crude::<true>(at(power))).is_some(),
            is_known,
            "{power}"
        );
    }
    let zero = BigRational::from(BigInt::from(0));
    assert_eq!(Unbounded::near(&Crude::<true>(zero)), Some((0.0, 0)));
}

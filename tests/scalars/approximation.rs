//! The contract of `approx`, and the ends of each scalar's range.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{ToPrimitive, Zero};
use sweep_cdt::scalar::Scalar;

use super::*;

/// Numbers near every border of the doubles, and between them.
fn borderline() -> Vec<BigRational> {
    let mut random = Random::new(8);
    let mut numbers = vec![BigRational::zero()];
    let mut doubles = vec![
        5e-324,
        1e-310,
        f64::MIN_POSITIVE,
        1e-300,
        0.1,
        1.0,
        1.5,
        2.0,
        1e16,
        f64::MAX,
    ];
    doubles.extend(
        (0..300)
            .map(|_| f64::from_bits(random.bits()))
            .filter(|x| x.is_finite()),
    );
    for x in doubles {
        let x = rational(x.abs());
        for shift in [40, 52, 53, 54, 55, 60, 64, 70, 200, 1100] {
            let step = &x / (BigInt::from(1) << shift);
            for times in [-3, -2, -1, 0, 1, 2, 3] {
                numbers.push(&x + &step * BigInt::from(times));
                numbers.push((&x + &step * BigInt::from(times)) / BigInt::from(3));
            }
        }
    }
    numbers.extend([2000, 1024, 1023].map(|b| BigRational::from(BigInt::from(1) << b)));
    numbers
        .extend([2000, 1074, 1075, 1076].map(|b| BigRational::new(1.into(), BigInt::from(1) << b)));
    numbers.extend(numbers.clone().into_iter().map(|x| -x));
    numbers.sort();
    numbers
}

/// The contract of `approx`, on numbers in ascending order.
fn check_approx<S: Scalar>(numbers: &[(S, &BigRational)]) {
    let tolerance = BigRational::new(1.into(), BigInt::from(1) << 52);
    let normal = rational(f64::MIN_POSITIVE)..=rational(f64::MAX);
    for pair in numbers.windows(2) {
        assert!(
            pair[0].0.approx() <= pair[1].0.approx(),
            "{} {}",
            pair[0].1,
            pair[1].1
        );
    }
    for (number, exact) in numbers {
        let (near, size) = (number.approx(), exact.numer().magnitude().clone());
        let size = BigRational::new(size.into(), exact.denom().clone());
        assert!(!near.is_nan());
        if normal.contains(&size) {
            let error = rational(near) - *exact;
            assert!(
                error.clone().max(-error) <= &size * &tolerance,
                "{exact} {near:e}"
            );
        } else if size < *normal.start() {
            let error = rational(near) - *exact;
            assert!(
                error.clone().max(-error) < *normal.start(),
                "{exact} {near:e}"
            );
        } else {
            assert!(near.abs() >= f64::MAX, "{exact} {near:e}");
        }
    }
}

#[test]
fn approximations() {
    let numbers = borderline();
    check_approx(&numbers.iter().map(|x| (x.clone(), x)).collect::<Vec<_>>());
    let integers: Vec<BigRational> = numbers.iter().map(BigRational::trunc).collect();
    check_approx(
        &integers
            .iter()
            .map(|x| (x.to_integer(), x))
            .collect::<Vec<_>>(),
    );
    let small: Vec<_> = integers
        .iter()
        .filter_map(|x| Some((x.numer().to_i64()?, x)))
        .collect();
    check_approx(&small);
    let wide: Vec<_> = integers
        .iter()
        .filter_map(|x| Some((x.numer().to_i128()?, x)))
        .collect();
    check_approx(&wide);
    let part = |x: &BigInt| x.to_i64();
    let ratios = |x| {
        let numbers: &BigRational = x;
        Some((
            Ratio::new_raw(part(numbers.numer())?, part(numbers.denom())?),
            x,
        ))
    };
    check_approx(&numbers.iter().filter_map(ratios).collect::<Vec<_>>());
    #[cfg(feature = "rug")]
    check_approx(&numbers.iter().map(|x| (to_rug(x), x)).collect::<Vec<_>>());
}

#[test]
fn whole_range_of_integers() {
    let mut random = Random::new(9);
    for _ in 0..3000 {
        let shift = random.below(64);
        let corners = [i64::MIN, i64::MAX, 0, -1, i64::MIN + 1, i64::MAX - 1];
        let points: [[i64; 2]; 4] = [(); 4].map(|()| {
            [(); 2].map(|()| match random.below(3) {
                0 => corners[random.below(6)] >> shift,
                _ => random.bits().cast_signed() >> shift,
            })
        });
        let exact = points.map(|p| p.map(|x| BigRational::from_integer(x.into())));
        let expected = reference(&exact);
        check(&points, expected, "i64");
        check(&exact, expected, "i64");
        let narrow = points.map(|p| {
            p.map(|x| (x >> (63 - shift).min(32)).clamp(i32::MIN.into(), i32::MAX.into()))
        });
        let exact = narrow.map(|p| p.map(|x| BigRational::from_integer(x.into())));
        check(
            &narrow.map(|p| p.map(|x| i32::try_from(x).unwrap())),
            reference(&exact),
            "i32",
        );
    }
}

/// The differences need 129 bits, and their products 258.
#[test]
fn whole_range_of_wide_integers() {
    let mut random = Random::new(10);
    for _ in 0..3000 {
        let shift = random.below(128);
        let ends = [i128::MIN, i128::MAX, 0, -1, i128::MIN + 1, i128::MAX - 1];
        let bits = |r: &mut Random| i128::from(r.bits().cast_signed()) << 64 | i128::from(r.bits());
        let points: [[i128; 2]; 4] = [(); 4].map(|()| {
            [(); 2].map(|()| match random.below(3) {
                0 => ends[random.below(6)] >> shift,
                _ => bits(&mut random) >> shift,
            })
        });
        let exact = points.map(|p| p.map(|x| BigRational::from_integer(x.into())));
        check(&points, reference(&exact), "i128");
    }
}

/// Numerators and denominators of any size, whose products overflow; some lie on a line or a circle.
#[test]
fn whole_range_of_ratios() {
    let mut random = Random::new(13);
    for round in 0..3000 {
        let shift = random.below(63);
        let ends = [i64::MIN, i64::MAX, 1, -1, i64::MIN + 1, i64::MAX - 1];
        let mut part = || match random.below(3) {
            0 => ends[random.below(6)],
            _ => random.bits().cast_signed() >> shift,
        };
        let mut ratio = || {
            let (numerator, denominator) = (part(), part());
            // `new` negates a negative denominator, which overflows for the least one.
            let denominator = denominator.checked_abs().filter(|&d| d > 0).unwrap_or(7);
            Ratio::new(numerator.max(-i64::MAX), denominator)
        };
        let mut points = [(); 4].map(|()| [ratio(), ratio()]);
        if round % 3 == 0 {
            // A rectangle.
            let [[x, y], [z, w], ..] = points;
            points = [[x, y], [z, y], [z, w], [x, w]];
        }
        let big = |x: Ratio<i64>| BigRational::new((*x.numer()).into(), (*x.denom()).into());
        let exact = points.map(|p| p.map(big));
        check(&points, reference(&exact), "Ratio<i64>");
    }
}

#[test]
fn what_is_no_number() {
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(!Scalar::is_finite(&x) && !Scalar::is_finite(&(x as f32)));
    }
    assert_eq!(Scalar::compare(&0.0, &-0.0), Ordering::Equal);
    assert_eq!(Scalar::compare(&0f32, &-0f32), Ordering::Equal);
    // As `new_raw` makes them: no number, and two that are negative.
    assert!(!Scalar::is_finite(&Ratio::<i64>::new_raw(1, 0)));
    let [negative, less] = [1, 3].map(|numerator| Ratio::new_raw(numerator, -2_i64));
    assert_eq!((negative.approx(), less.approx()), (-0.5, -1.5));
    assert_eq!(less.compare(&negative), Ordering::Less);
    assert_eq!(negative.compare(&Ratio::from_integer(0)), Ordering::Less);
    assert_eq!(Scalar::as_doubles(&[[negative, less]]), None);
    for numerator in [0, 1] {
        assert!(!Scalar::is_finite(&BigRational::new_raw(
            numerator.into(),
            0.into()
        )));
    }
}

/// Doubles in place of points are these, all times one positive number.
fn check_doubles<S: Scalar + Clone>(numbers: &[(S, &BigRational)], expected: bool) {
    let points: Vec<[S; 2]> = numbers
        .iter()
        .map(|(x, _)| [x.clone(), numbers[0].0.clone()])
        .collect();
    let doubles = S::as_doubles(&points);
    assert_eq!(doubles.is_some(), expected, "{}", numbers[0].1);
    let Some(doubles) = doubles else { return };
    let (first, exact) = (rational(doubles[0][1]), numbers[0].1);
    assert!(
        &first * exact > BigRational::zero(),
        "the first is not zero"
    );
    for ([x, _], (_, number)) in doubles.into_iter().zip(numbers) {
        assert_eq!(rational(x) * exact, &first * *number);
    }
}

#[test]
fn doubles_stand_for_numbers_up_to_one_factor() {
    let mut random = Random::new(12);
    let mut whole = |bits: u64| i64::try_from(random.bits() >> (64 - bits)).expect("small") + 1;
    for _ in 0..300 {
        let numbers: Vec<i64> = (0..8).map(|i| whole(40) * (i % 3 - 1)).collect();
        let numbers: Vec<i64> = std::iter::once(7).chain(numbers).collect();
        for unit in [1_i64, 3, 1000, 1 << 40, 3 << 50, 7 * 11 * 13] {
            let unit = BigInt::from(unit);
            let exact = |x: &i64| BigRational::new(BigInt::from(*x), unit.clone());
            let exact: Vec<BigRational> = numbers.iter().map(exact).collect();
            let rationals: Vec<_> = exact.iter().map(|x| (x.clone(), x)).collect();
            check_doubles(&rationals, true);
            let small = |x: &BigInt| x.to_i64();
            let ratio = |x| {
                let number: &BigRational = x;
                Some((
                    Ratio::new(small(number.numer())?, small(number.denom())?),
                    x,
                ))
            };
            check_doubles(&exact.iter().filter_map(ratio).collect::<Vec<_>>(), true);
        }
        let exact: Vec<BigRational> = numbers
            .iter()
            .map(|&x| BigRational::from(BigInt::from(x)))
            .collect();
        let integers: Vec<_> = numbers.iter().copied().zip(&exact).collect();
        check_doubles(&integers, true);
        let wide = numbers.iter().map(|&x| i128::from(x)).zip(&exact);
        check_doubles(&wide.collect::<Vec<_>>(), true);
        let integers: Vec<_> = numbers
            .iter()
            .map(|&x| BigInt::from(x))
            .zip(&exact)
            .collect();
        check_doubles(&integers, true);
    }
    // What needs 54 bits, and what has no small unit.
    let large = (1_i64 << 53) + 1;
    let exact = BigRational::from(BigInt::from(large));
    check_doubles(&[(large, &exact)], false);
    check_doubles(&[(i128::from(large), &exact)], false);
    check_doubles(&[(Ratio::from_integer(large), &exact)], false);
    check_doubles(&[(BigInt::from(large), &exact)], false);
    check_doubles(&[(exact.clone(), &exact)], false);
    let primes = [4_294_967_291_i64, 4_294_967_279, 4_294_967_231].map(|p| rational_of(1, p));
    check_doubles(&primes.each_ref().map(|x| (x.clone(), x)), false);
    let raw = BigRational::new_raw(BigInt::from(1), BigInt::zero());
    assert_eq!(Scalar::as_doubles(&[[raw.clone(), raw]]), None);
}

fn rational_of(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(BigInt::from(numerator), BigInt::from(denominator))
}

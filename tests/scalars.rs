//! Every predicate of every scalar against plain determinants of big integers.

#![expect(clippy::cast_possible_truncation, reason = "chosen to fit")]

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use sweep_cdt::Scalar;

/// Pseudo-random numbers (the generator `SplitMix64`).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: u64) -> u64 {
        self.next() % n
    }

    /// In -1..1.
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// -n..=n as a double.
    fn integer(&mut self, n: u64) -> f64 {
        self.below(2 * n + 1) as f64 - n as f64
    }

    fn points(&mut self, mut coordinate: impl FnMut(&mut Random) -> f64) -> Points {
        [(); 4].map(|()| [(); 2].map(|()| coordinate(self)))
    }
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
    assert_eq!(
        S::orient2d(a, b, c),
        expected[0],
        "orient2d {scalar} {what} {near:?}"
    );
    assert_eq!(
        S::in_circle(a, b, c, d),
        expected[1],
        "in_circle {scalar} {what} {near:?}"
    );
    assert_eq!(
        S::in_circle(b, a, c, d),
        expected[1].reverse(),
        "swapped {scalar} {what} {near:?}"
    );
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

#[test]
fn random_points() {
    let mut random = Random(1);
    for _ in 0..2000 {
        let points = random.points(Random::unit);
        check_all(&points, "uniform");
        check_all(
            &points.map(|p| p.map(|x| f64::from(x as f32))),
            "single precision",
        );
    }
}

#[test]
fn lattices() {
    let mut random = Random(2);
    for size in [
        1,
        2,
        5,
        1000,
        1 << 20,
        1 << 29,
        1 << 30,
        (1 << 31) - 1,
        1 << 40,
        1 << 53,
        1 << 62,
    ] {
        for _ in 0..500 {
            let points = random.points(|r| r.integer(size));
            check_all(&points, "lattice");
            check_all(&points.map(|p| p.map(|x| x * 0.1)), "lattice, rounded");
            check_all(
                &points.map(|p| p.map(|x| x * 2f64.powi(-40) + 1024.0)),
                "lattice, moved",
            );
        }
    }
}

#[test]
fn near_lines() {
    let mut random = Random(3);
    for _ in 0..2000 {
        let [mut a, b, mut c, d] = random.points(Random::unit);
        let t = random.unit() * 3.0;
        for i in 0..2 {
            c[i] = a[i] + t * (b[i] - a[i]);
        }
        check_all(&[a, b, c, d], "on a line, rounded");
        check_all(&nudged(&mut random, [a, b, c, d]), "near a line");
        a = [a[0], a[0]];
        check_all(
            &nudged(&mut random, [a, [b[0]; 2], [c[0]; 2], d]),
            "near the diagonal",
        );
        check_all(&[a, a, c, d], "equal points");
    }
}

#[test]
fn near_circles() {
    let mut random = Random(4);
    for round in 0..2000 {
        let radius = 10f64.powi((round % 13) - 6);
        let center = [random.unit(), random.unit()].map(|x| x * f64::from(round % 3));
        let points = [(); 4].map(|()| {
            let (sin, cos) = (random.unit() * 3.2).sin_cos();
            [center[0] + radius * cos, center[1] + radius * sin]
        });
        check_all(&points, "on a circle, rounded");
        check_all(&nudged(&mut random, points), "near a circle");
    }
}

#[test]
fn on_circles() {
    // 5^2 * 13^2 * 17^2 = x^2 + y^2 in many ways.
    let radius = 5i32 * 13 * 17;
    let on_circle: Vec<[f64; 2]> = (-radius..=radius)
        .flat_map(|x| (-radius..=radius).map(move |y| [x, y]))
        .filter(|&[x, y]| x * x + y * y == radius * radius)
        .map(|p| p.map(f64::from))
        .collect();
    let mut random = Random(5);
    for scale in [
        1.0,
        2f64.powi(-30),
        2f64.powi(20),
        2f64.powi(-1000),
        2f64.powi(900),
        1e-310,
    ] {
        for _ in 0..300 {
            let points = [(); 4].map(|()| {
                let pick = on_circle[random.below(on_circle.len() as u64) as usize];
                pick.map(|x| (x + f64::from(radius)) * scale)
            });
            check_all(&points, "on a circle");
            check_all(&nudged(&mut random, points), "next to a circle");
        }
    }
}

#[test]
fn extreme_exponents() {
    let mut random = Random(6);
    let bits = |r: &mut Random| loop {
        let x = f64::from_bits(r.next());
        if x.is_finite() {
            return x;
        }
    };
    let palette = [
        0.0,
        -0.0,
        5e-324,
        -5e-324,
        1e-310,
        f64::MIN_POSITIVE,
        1e-300,
        1e-150,
        1.0,
        1e150,
        1e300,
        1e308,
        f64::MAX,
        f64::MIN,
        -1e-300,
        -1.0,
        -1e300,
        3e-324,
        2e-308,
    ];
    for _ in 0..60 {
        let points = random.points(bits);
        check_all(&points, "any bits");
        let points = random.points(|r| palette[r.below(19) as usize]);
        check_all(&points, "palette");
        check_all(
            &nudged(&mut random, points.map(|p| p.map(|x| x / 4.0))),
            "near the palette",
        );
        for scale in [
            1e-323, 1e-310, 1e-300, 1e-160, 1e-100, 1e-60, 1e60, 1e100, 1e160, 1e300, 1e308,
        ] {
            let points = random.points(|r| r.unit() * scale);
            check_all(&points, "scaled");
            let [a, b, c, _] = points;
            let fourth =
                [0, 1].map(|i| (b[i] / 2.0 + c[i] / 2.0 - a[i] / 2.0).clamp(-8e307, 8e307));
            check_all(&[a, b, c, fourth.map(|x| x * 2.0)], "parallelogram");
            let grid = random.points(|r| (r.integer(3) * scale).clamp(f64::MIN, f64::MAX));
            check_all(
                &nudged(&mut random, grid.map(|p| p.map(|x| x / 2.0))),
                "scaled grid",
            );
        }
    }
}

/// Rationals that no double equals, with denominators of any size, on and near lines and circles.
#[test]
fn proper_rationals() {
    let mut random = Random(7);
    let fraction = |r: &mut Random, bits: u64| {
        let part = |r: &mut Random| BigInt::from(r.integer(1 << 20) as i64);
        let digits = BigInt::from(r.next() | 1) << r.below(bits);
        BigRational::new((part(r) << r.below(bits)) + 1, digits)
    };
    for round in 0..150u64 {
        let bits = [1, 60, 300][(round % 3) as usize];
        let mut point = || [fraction(&mut random, bits), fraction(&mut random, bits)];
        let (a, u) = (point(), point());
        // Points of the circle through the origin with centre a: reflections across its diameters.
        let mut on_circle = || {
            let v = point();
            let norm = &v[0] * &v[0] + &v[1] * &v[1];
            let t = BigRational::from_integer(2.into()) * (&a[0] * &v[0] + &a[1] * &v[1]) / norm;
            [&v[0] * &t + &u[0], &v[1] * &t + &u[1]]
        };
        let mut points = [on_circle(), on_circle(), on_circle(), on_circle()];
        let line = [
            &points[0][0] * BigInt::from(3) - &points[1][0] * BigInt::from(2),
            &points[0][1] * BigInt::from(3) - &points[1][1] * BigInt::from(2),
        ];
        for _ in 0..2 {
            let collinear = [
                points[0].clone(),
                points[1].clone(),
                line.clone(),
                points[3].clone(),
            ];
            for set in [&points, &collinear] {
                let expected = reference(set);
                check(set, expected, "rationals");
                #[cfg(feature = "rug")]
                check(
                    &set.clone().map(|p| p.map(|x| to_rug(&x))),
                    expected,
                    "rationals",
                );
            }
            points[3][1] += BigRational::new(1.into(), BigInt::from(1) << 300u32);
        }
    }
}

#[cfg(feature = "rug")]
fn to_rug(x: &BigRational) -> rug::Rational {
    let integer = |x: &BigInt| rug::Integer::from_str_radix(&x.to_str_radix(16), 16).unwrap();
    rug::Rational::from((integer(x.numer()), integer(x.denom())))
}

/// Numbers near every border of the doubles, and between them.
fn borderline() -> Vec<BigRational> {
    let mut random = Random(8);
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
            .map(|_| f64::from_bits(random.next()))
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
    #[cfg(feature = "rug")]
    check_approx(&numbers.iter().map(|x| (to_rug(x), x)).collect::<Vec<_>>());
}

#[test]
fn whole_range_of_integers() {
    let mut random = Random(9);
    for _ in 0..3000 {
        let shift = random.below(64);
        let corners = [i64::MIN, i64::MAX, 0, -1, i64::MIN + 1, i64::MAX - 1];
        let points: [[i64; 2]; 4] = [(); 4].map(|()| {
            [(); 2].map(|()| match random.below(3) {
                0 => corners[random.below(6) as usize] >> shift,
                _ => random.next().cast_signed() >> shift,
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

#[test]
fn what_is_no_number() {
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(!Scalar::is_finite(&x) && !Scalar::is_finite(&(x as f32)));
    }
    assert_eq!(Scalar::compare(&0.0, &-0.0), Ordering::Equal);
    assert_eq!(Scalar::compare(&0f32, &-0f32), Ordering::Equal);
    for numerator in [0, 1] {
        assert!(!Scalar::is_finite(&BigRational::new_raw(
            numerator.into(),
            0.into()
        )));
    }
}

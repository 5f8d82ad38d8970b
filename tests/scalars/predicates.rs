//! Every predicate of every scalar on random, nearly degenerate and extreme points.

use num_bigint::BigInt;
use num_rational::BigRational;

use super::*;

#[test]
fn random_points() {
    let mut random = Random::new(1);
    for _ in 0..2000 {
        let points = draw(&mut random, signed_unit);
        check_all(&points, "uniform");
        check_all(
            &points.map(|p| p.map(|x| f64::from(x as f32))),
            "single precision",
        );
    }
}

#[test]
fn lattices() {
    let mut random = Random::new(2);
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
            let points = draw(&mut random, |r| r.integer(size));
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
    let mut random = Random::new(3);
    for _ in 0..2000 {
        let [mut a, b, mut c, d] = draw(&mut random, signed_unit);
        let t = signed_unit(&mut random) * 3.0;
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

/// Differences that are exact, and so far apart in size that the smallest vanish where the largest are scaled.
#[test]
fn far_smaller_than_the_others() {
    for (large, small) in [(899, -1070), (890, -200), (700, -500), (100, -900)] {
        let (large, small) = (2f64.powi(large), 2f64.powi(small));
        for c in [[small, -small], [-small, small], [small, 0.0]] {
            check_all(&[[large, 0.0], [0.0, large], c, [0.0; 2]], "far smaller");
        }
    }
}

#[test]
fn near_circles() {
    let mut random = Random::new(4);
    for round in 0..2000 {
        let radius = 10f64.powi((round % 13) - 6);
        let center =
            [signed_unit(&mut random), signed_unit(&mut random)].map(|x| x * f64::from(round % 3));
        let points = [(); 4].map(|()| {
            let (sin, cos) = (signed_unit(&mut random) * 3.2).sin_cos();
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
    let mut random = Random::new(5);
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
                let pick = on_circle[random.below(on_circle.len())];
                pick.map(|x| (x + f64::from(radius)) * scale)
            });
            check_all(&points, "on a circle");
            check_all(&nudged(&mut random, points), "next to a circle");
        }
    }
}

#[test]
fn extreme_exponents() {
    let mut random = Random::new(6);
    let bits = |r: &mut Random| loop {
        let x = f64::from_bits(r.bits());
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
        let points = draw(&mut random, bits);
        check_all(&points, "any bits");
        let points = draw(&mut random, |r| palette[r.below(19)]);
        check_all(&points, "palette");
        check_all(
            &nudged(&mut random, points.map(|p| p.map(|x| x / 4.0))),
            "near the palette",
        );
        for scale in [
            1e-323, 1e-310, 1e-300, 1e-160, 1e-100, 1e-60, 1e60, 1e100, 1e160, 1e300, 1e308,
        ] {
            let points = draw(&mut random, |r| signed_unit(r) * scale);
            check_all(&points, "scaled");
            let [a, b, c, _] = points;
            let fourth =
                [0, 1].map(|i| (b[i] / 2.0 + c[i] / 2.0 - a[i] / 2.0).clamp(-8e307, 8e307));
            check_all(&[a, b, c, fourth.map(|x| x * 2.0)], "parallelogram");
            let grid = draw(&mut random, |r| {
                (r.integer(3) * scale).clamp(f64::MIN, f64::MAX)
            });
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
    let mut random = Random::new(7);
    let fraction = |r: &mut Random, bits: usize| {
        let part = |r: &mut Random| BigInt::from(r.integer(1 << 20) as i64);
        let digits = BigInt::from(r.bits() | 1) << r.below(bits);
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

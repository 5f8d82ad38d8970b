//! Nearly collinear and nearly cocircular points whose doubles are other points.
//!
//! Far from the origin doubles are coarser than the points are apart from a line or circle, so the sign
//! of the determinant of the doubles says nothing. A filter that believes it is wrong.

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::triangulate;

use super::crude::Crude;
use super::*;

/// The predicates called directly, and the sweep, whose scale is that of all points.
fn check_scalar<S: Scalar>(points: &[[S; 2]; 4], exact: &Exact, what: &str) {
    check(points, reference(exact), what);
    let scalar = std::any::type_name::<S>();
    // The first three points, and all.
    for count in [3, 4] {
        let result = triangulate(&points[..count], &[]).expect("finite points");
        let triangles: Vec<_> = result.triangles().collect();
        judge(&exact[..count], &triangles, &format!("{scalar} {what}"));
    }
}

/// Panics unless these are the Delaunay triangles of the points.
fn judge(exact: &[[BigRational; 2]], triangles: &[[usize; 3]], what: &str) {
    let signs = |order: [usize; 4]| reference(&order.map(|v| exact[v].clone()));
    let count = exact.len();
    let mut others = (1..count).flat_map(|b| (0..b).map(move |a| [a, b]));
    let all_flat = others.all(|[a, b]| (0..a).all(|c| signs([a, b, c, a])[0].is_eq()));
    assert_eq!(triangles.is_empty(), all_flat, "{what} {exact:?}");
    for v in 0..count {
        let is_repeated = exact[..v].contains(&exact[v]);
        let is_there = triangles.iter().any(|triangle| triangle.contains(&v));
        assert!(
            is_there != is_repeated || all_flat,
            "a point: {what} {exact:?}"
        );
    }
    for &[a, b, c] in triangles {
        assert!(signs([a, b, c, a])[0].is_gt(), "a turn: {what} {exact:?}");
        for d in (0..count).filter(|d| ![a, b, c].contains(d)) {
            let side = signs([a, b, c, d])[1];
            assert!(side.is_le(), "a circle: {what} {exact:?}");
        }
    }
}

/// Every scalar whose doubles are not exact, on integer points and on thirds of them.
fn check_integers(points: [[i64; 2]; 4], what: &str) {
    let exact = points.map(|p| p.map(|x| BigRational::from(BigInt::from(x))));
    check_scalar(&points, &exact, what);
    check_scalar(&points.map(|p| p.map(BigInt::from)), &exact, what);
    check_scalar(&exact, &exact, what);
    check_rationals(&exact, what);
    check_rationals(&exact.map(|p| p.map(|x| x / BigInt::from(3))), what);
}

fn check_rationals(exact: &Exact, what: &str) {
    check_scalar(exact, exact, what);
    check_scalar(&exact.clone().map(|p| p.map(Crude::<false>)), exact, what);
    check_scalar(&exact.clone().map(|p| p.map(Crude::<true>)), exact, what);
    #[cfg(feature = "rug")]
    check_scalar(&exact.clone().map(|p| p.map(|x| to_rug(&x))), exact, what);
}

/// Offsets and sizes of the figures at them, as powers of two.
const PLACES: [[u32; 2]; 6] = [[60, 24], [60, 30], [61, 10], [58, 52], [54, 20], [62, 60]];

/// A random number from 2^`bits` to 5/4 of it.
fn far(random: &mut Random, bits: u32) -> i64 {
    (1 << bits) + (random.bits() >> (66 - bits)) as i64
}

/// The nearest number of 52 bits.
fn rounded(x: i64) -> i64 {
    let unit = 1_i64 << (64 - x.leading_zeros()).saturating_sub(52);
    (x + unit / 2) / unit * unit
}

/// Of some figures the one that rounding bends most, as this measures it.
fn most_bent<const N: usize>(
    mut figure: impl FnMut() -> [[i64; 2]; N],
    measure: impl Fn([[f64; 2]; N]) -> f64,
) -> [[i64; 2]; N] {
    let bend = |figure: &[[i64; 2]; N]| {
        let last = figure[N - 1].map(rounded);
        let row = |p: [i64; 2]| [0, 1].map(|i| (rounded(p[i]) - last[i]) as f64);
        measure(figure.map(row))
    };
    (0..100)
        .map(|_| figure())
        .max_by(|a, b| bend(a).total_cmp(&bend(b)))
        .expect("some figures")
}

#[test]
fn near_circles_far_away() {
    let mut random = Random::new(11);
    for round in 0..200 {
        let [offset, size] = PLACES[round % PLACES.len()];
        let radius = (1_i64 << size) as f64;
        let center = [(); 2].map(|()| far(&mut random, offset));
        let figure = || {
            [(); 4].map(|()| {
                let (sin, cos) = (random.unit() * 6.4).sin_cos();
                [
                    center[0] + (radius * cos) as i64,
                    center[1] + (radius * sin) as i64,
                ]
            })
        };
        let points = most_bent(figure, in_circle);
        check_integers(points, "near a circle, far away");
    }
}

#[test]
fn near_squares_far_away() {
    let mut random = Random::new(12);
    for round in 0..200 {
        let [offset, size] = PLACES[round % PLACES.len()];
        let figure = || {
            let corner = [(); 2].map(|()| far(&mut random, offset));
            let side = far(&mut random, size) / 2;
            let mut points = [[0, 0], [side, 0], [side, side], [0, side]]
                .map(|p| [0, 1].map(|i| corner[i] + p[i]));
            points[round % 4][round % 2] += random.below(3) as i64 - 1;
            points
        };
        let points = most_bent(figure, in_circle);
        check_integers(points, "near a square, far away");
    }
}

/// The in-circle determinant against the sum of the absolute values of its terms.
fn in_circle([[ax, ay], [bx, by], [cx, cy], _]: Points) -> f64 {
    let lifts = [ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy];
    let pairs = [(bx * cy, by * cx), (ay * cx, ax * cy), (ax * by, ay * bx)];
    let sum = |term: fn(f64, f64) -> f64| -> f64 {
        let terms = lifts
            .iter()
            .zip(pairs)
            .map(|(lift, (p, q))| lift * term(p, q));
        terms.sum()
    };
    sum(|p, q| p - q).abs() / sum(|p, q| p.abs() + q.abs())
}

#[test]
fn near_lines_far_away() {
    let mut random = Random::new(13);
    for round in 0..300 {
        let [offset, size] = PLACES[round % PLACES.len()];
        let figure = || {
            let start = [(); 2].map(|()| far(&mut random, offset));
            let step = [(); 2].map(|()| far(&mut random, size / 2));
            let along = |times: i64| [0, 1].map(|i| start[i] + times * step[i]);
            let (near, most) = (random.below(9) as i64, far(&mut random, size / 2) / 2);
            let mut points = [along(most), along(near), along(0)];
            points[round % 3][round % 2] += random.below(3) as i64 - 1;
            points
        };
        let [mut a, mut b, c] = most_bent(figure, |[[ax, ay], [bx, by], _]| {
            (ax * by - ay * bx).abs() / (ax.abs() + ay.abs() + bx.abs() + by.abs())
        });
        if round % 2 == 0 {
            (a, b) = (b, a);
        }
        let d = [c[0] + (1 << (size / 2)), c[1]];
        check_integers([a, b, c, d], "near a line, far away");
    }
}

/// Numbers among the subnormal doubles, which approximations may lose, beside larger ones.
#[test]
fn points_that_doubles_lose() {
    let mut random = Random::new(15);
    for _ in 0..300 {
        let large = (1_u64 << random.below(25)) as f64;
        let points = draw(&mut random, |r| r.integer(3) * r.pick(&[1.0, large]));
        let unit = BigRational::new(1.into(), BigInt::from(1) << 1024_u32);
        let tiny = exact(&points).map(|p| p.map(|x| x * &unit));
        check_rationals(&tiny, "tiny");
    }
}

/// Doubles beside much larger ones: their products are below the doubles, or scaling loses their digits.
#[test]
fn points_that_products_or_scaling_lose() {
    let mut random = Random::new(17);
    for round in 0..2000 {
        let [small, large] = match round % 4 {
            0 | 1 => [-538 + random.below(20) as i32, random.below(20) as i32],
            2 => [-100, 999],
            _ => [-60 - random.below(30) as i32, 990 + random.below(30) as i32],
        };
        let sizes = [small, small, small, large].map(|power| 2_f64.powi(power));
        let points = draw(&mut random, |r| (7.0 + r.integer(9)) * r.pick(&sizes));
        let points = if round % 8 < 4 {
            points
        } else {
            // The large one last.
            let mut points = draw(&mut random, |r| (7.0 + r.integer(9)) * sizes[0]);
            points[3] = [sizes[3], random.integer(3) * sizes[3]];
            points
        };
        check_scalar(&points, &exact(&points), "lost");
        if round % 16 < 2 {
            check_rationals(&exact(&points), "lost");
        }
    }
}

/// Four points so near each other, beside a fifth, that the products of their differences underflow.
#[test]
fn circles_that_products_lose() {
    let mut random = Random::new(18);
    for round in 0..4000 {
        let unit = 2_f64.powi(-269 - round % 5);
        let [a, b, c, d] = draw(&mut random, |r| r.integer(6) * unit);
        let points = [a, b, c, d, [1.0, 0.5]];
        let result = triangulate(&points, &[]).expect("finite points");
        let triangles: Vec<_> = result.triangles().collect();
        judge(
            &points.map(|p| p.map(rational)),
            &triangles,
            "a small circle",
        );
    }
}

/// Numbers above the doubles, some of which become the same one.
#[test]
#[ignore = "5 seconds: `.ci/nightly` runs it"]
fn points_beyond_doubles() {
    let mut random = Random::new(16);
    for _ in 0..300 {
        let points = exact(&draw(&mut random, |r| r.integer(3)));
        let huge = points
            .map(|p| p.map(|x| x * (BigInt::from(1) << random.pick(&[0, 1000, 1030, 2000_u32]))));
        check_rationals(&huge, "huge");
    }
}

//! Nearly collinear and nearly cocircular points whose doubles are other points.
//!
//! Far from the origin doubles are coarser than the points are apart from a line or circle, so the sign
//! of the determinant of the doubles says nothing. A filter that believes it is wrong.

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::{Scalar, triangulate};

use crate::crude::Crude;
use crate::reference::*;

/// The predicates called directly, and the sweep, whose scale is that of all points.
fn check_scalar<S: Scalar>(points: &[[S; 2]; 4], exact: &Exact, what: &str) {
    check(points, reference(exact), what);
    let scalar = std::any::type_name::<S>();
    // The first three points, and all.
    for count in [3, 4] {
        let result = triangulate(&points[..count], &[]).expect("finite points");
        let triangles: Vec<_> = result.triangles().collect();
        judge(exact, count, &triangles, &format!("{scalar} {what}"));
    }
}

/// Panics unless these are the Delaunay triangles of the first `count` points.
fn judge(exact: &Exact, count: usize, triangles: &[[usize; 3]], what: &str) {
    let signs = |order: [usize; 4]| reference(&order.map(|v| exact[v].clone()));
    let flat = |[a, b, c]: [usize; 3]| signs([a, b, c, a])[0].is_eq();
    let triples = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]];
    let all_flat = triples[..if count == 3 { 1 } else { 4 }]
        .iter()
        .all(|&triple| flat(triple));
    assert_eq!(triangles.is_empty(), all_flat, "{what} {exact:?}");
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
    check_scalar(&exact.clone().map(|p| p.map(Crude)), exact, what);
    #[cfg(feature = "rug")]
    check_scalar(&exact.clone().map(|p| p.map(|x| to_rug(&x))), exact, what);
}

/// Offsets and sizes of the figures at them, as powers of two.
const PLACES: [[u32; 2]; 6] = [[60, 24], [60, 30], [61, 10], [58, 52], [54, 20], [62, 60]];

#[test]
fn near_circles_far_away() {
    let mut random = Random(11);
    for round in 0..3000 {
        let [offset, radius] = PLACES[round % PLACES.len()];
        let radius = f64::from(1 << (radius / 2)) * f64::from(1 << (radius - radius / 2));
        let center = [(); 2].map(|()| (1_i64 << offset) + (random.next() >> (66 - offset)) as i64);
        let points = [(); 4].map(|()| {
            let (sin, cos) = (random.unit() * 3.2).sin_cos();
            [
                center[0] + (radius * cos) as i64,
                center[1] + (radius * sin) as i64,
            ]
        });
        check_integers(points, "near a circle, far away");
    }
}

#[test]
fn near_squares_far_away() {
    let mut random = Random(12);
    for round in 0..2000 {
        let [offset, size] = PLACES[round % PLACES.len()];
        let corner = [(); 2].map(|()| (1_i64 << offset) + (random.next() >> (66 - offset)) as i64);
        let side = (1_i64 << (size - 1)) + (random.next() >> (66 - size)) as i64;
        let mut points =
            [[0, 0], [side, 0], [side, side], [0, side]].map(|p| [0, 1].map(|i| corner[i] + p[i]));
        points[round % 4][round % 2] += random.below(3) as i64 - 1;
        check_integers(points, "near a square, far away");
    }
}

#[test]
fn near_lines_far_away() {
    let mut random = Random(13);
    for round in 0..3000 {
        let [offset, size] = PLACES[round % PLACES.len()];
        let start = [(); 2].map(|()| (1_i64 << offset) + (random.next() >> (66 - offset)) as i64);
        let small = |random: &mut Random, bits: u32| (random.next() >> (64 - bits)) as i64;
        let step = [(); 2].map(|()| small(&mut random, size / 2));
        let along = |times: i64| [0, 1].map(|i| start[i] + times * step[i]);
        let mut points = [1, 0, 0, 0].map(|_| along(small(&mut random, size / 2)));
        points[3][0] += 1 << (size / 2);
        points[round % 3][round % 2] += random.below(3) as i64 - 1;
        check_integers(points, "near a line, far away");
    }
}

/// Three points on a diagonal, of those with one line the ones that rounding moves farthest off it.
#[test]
fn diagonals_that_rounding_bends() {
    let mut random = Random(14);
    for round in 0..400 {
        let unit = 1_i64 << 8;
        let start = (1_i64 << 60) + ((random.next() >> 30) as i64) * unit;
        // `up` loses nearly a unit in the last place, `down` loses nothing.
        let (up, down) = (random.below(8) as i64, unit - 1 - random.below(8) as i64);
        let near = 1 + random.below(1 << 10) as i64;
        let far = (1 << 13) + random.below(1 << 14) as i64;
        // x and y differ by `down - up` throughout; after rounding, by nothing or by a whole unit.
        let a = [start + far * unit + down, start + far * unit + up];
        let b = [
            start + near * unit + up + unit,
            start + near * unit + 2 * up + unit - down,
        ];
        let c = [start + down, start + up];
        let mut points = [a, b, c, [start - far * unit, start + far * unit]];
        points.swap(round % 3, (round / 3) % 3);
        check_integers(points, "on a diagonal");
        points[round % 3][round % 2] += random.below(3) as i64 - 1;
        check_integers(points, "near a diagonal");
    }
}

/// Numbers among the subnormal doubles, which approximations may lose, beside larger ones.
#[test]
fn points_that_doubles_lose() {
    let mut random = Random(15);
    for _ in 0..300 {
        let large = 1_u64 << random.below(25);
        let points = random
            .points(|r| r.integer(3) * [1.0, large as f64][r.below(2) as usize])
            .map(|p| p.map(rational));
        let unit = BigRational::new(1.into(), BigInt::from(1) << 1024_u32);
        check_rationals(&points.map(|p| p.map(|x| x * &unit)), "tiny");
    }
}

/// Numbers above the doubles, some of which become the same one.
#[test]
fn points_beyond_doubles() {
    let mut random = Random(16);
    for _ in 0..300 {
        let points = random.points(|r| r.integer(3)).map(|p| {
            p.map(|x| {
                rational(x)
                    * (BigInt::from(1) << [0, 1000, 1030, 2000_u32][random.below(4) as usize])
            })
        });
        check_rationals(&points, "huge");
    }
}

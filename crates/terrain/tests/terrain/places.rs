//! The place on the border that is nearest to a point outside.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use num_rational::BigRational;
use sweep_cdt::interior::{FillRule, Interior};
use sweep_cdt_generate::Random;
use sweep_cdt_terrain::{Places, Surface};

use crate::{Lattice, below, triangulated};

/// A square with square holes, some of which touch, and points between.
fn with_holes(random: &mut Random) -> (Lattice, Vec<[usize; 2]>) {
    let mut lattice = Lattice::new(random, false);
    let mut edges = Vec::new();
    let holes = (0..9).filter(|_| random.bits().is_multiple_of(2));
    let squares = holes.map(|i| ([4 * (i % 3), 4 * (i / 3)], 2 + i % 3));
    for ([x, y], size) in std::iter::once(([-1, -1], 14)).chain(squares) {
        let first = lattice.points.len();
        let corners = [[0, 0], [size, 0], [size, size], [0, size]];
        lattice
            .points
            .extend(corners.map(|[dx, dy]| [x + dx, y + dy]));
        edges.extend([0, 1, 2, 3].map(|i| [first + i, first + (i + 1) % 4]));
    }
    let place: BTreeMap<[i64; 2], i64> = lattice
        .points
        .iter()
        .zip(0..)
        .map(|(p, i)| (*p, i * i % 7))
        .collect();
    lattice.heights = lattice.points.iter().map(|p| Some(place[p])).collect();
    (lattice, edges)
}

/// A point on the border near another one: square of the distance, its y and x, all as fractions of one denominator, and
/// the height as a numerator and a denominator.
type Near = (i64, [i64; 3], Option<[i64; 2]>);

fn compare(one: &Near, other: &Near) -> Ordering {
    let places = one.1.map(|x| i128::from(x) * i128::from(other.0));
    places.cmp(&other.1.map(|x| i128::from(x) * i128::from(one.0)))
}

/// The nearest place on the border by the definition, in quarters of the lattice; `None` if the point lies on a triangle.
fn nearest(lattice: &Lattice, triangles: &[[usize; 3]], [x, y]: [i64; 2]) -> Option<Near> {
    let point = |v: usize| lattice.points[v].map(|x| 4 * x);
    let turn = |a: [i64; 2], b: [i64; 2]| (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    let sides = |t: &[usize; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
    if triangles.iter().any(|t| {
        sides(t)
            .iter()
            .all(|[a, b]| turn(point(*a), point(*b)) >= 0)
    }) {
        return None;
    }
    let all: Vec<[usize; 2]> = triangles.iter().flat_map(sides).collect();
    let on_border = all.iter().filter(|&&[a, b]| !all.contains(&[b, a]));
    let near = on_border.map(|&[a, b]| {
        let [from, to] = [a, b].map(point);
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let square = dx * dx + dy * dy;
        let part = ((x - from[0]) * dx + (y - from[1]) * dy).clamp(0, square);
        let apart = [
            (x - from[0]) * square - part * dx,
            (y - from[1]) * square - part * dy,
        ];
        let place = [from[1] * square + part * dy, from[0] * square + part * dx];
        // The square of a distance has the denominator of the place twice.
        let distance = apart.iter().map(|d| d * d).sum::<i64>();
        let height = match part {
            0 => lattice.heights[a].map(|height| [height, 1]),
            _ if part == square => lattice.heights[b].map(|height| [height, 1]),
            _ => lattice.heights[a]
                .zip(lattice.heights[b])
                .map(|(low, high)| [low * square + part * (high - low), square]),
        };
        (
            square,
            [distance / square, place[0], place[1]],
            distance % square,
            height,
        )
    });
    let near = near.map(|(denominator, key, rest, height)| {
        assert_eq!(rest, 0, "the foot of a perpendicular");
        (denominator, key, height)
    });
    near.min_by(compare)
}

#[test]
fn nearest_places_are_those_of_the_definition() {
    let mut random = Random::new(7);
    let (mut near, mut far, mut ties) = (0, 0, 0);
    for round in 0..600 {
        let (lattice, edges) = match round % 2 {
            0 => (Lattice::new(&mut random, round % 4 == 0), vec![]),
            _ => with_holes(&mut random),
        };
        let points = lattice.doubles();
        let result = sweep_cdt::triangulate(&points, &edges).expect("a correct input");
        let interior = match edges.is_empty() {
            true => Interior::whole(&result),
            false => result.interior(FillRule::EvenOdd).expect("closed rings"),
        };
        let triangles: Vec<[usize; 3]> = interior.triangles().collect();
        let queries: Vec<[i64; 2]> = (0..40)
            .map(|_| [0, 1].map(|_| below(&mut random, 100) - 20))
            .collect();
        // In quarters, whose squares are whole: a distance that is just reached counts.
        let within = [0, 1, 2, 5, 13, i64::MAX][round / 2 % 6];
        // Doubles of every size, and fractions that no double is.
        let (scale, divisor) = (
            [1.0, 2f64.powi(-900), 2f64.powi(900), 2f64.powi(-1060)][round % 4],
            3,
        );
        let scaled = |points: &[[i64; 2]], quarter: i64| -> Vec<[f64; 2]> {
            points
                .iter()
                .map(|p| p.map(|x| x as f64 / quarter as f64 * scale))
                .collect()
        };
        let fractions = |points: &[[i64; 2]], quarter: i64| -> Vec<[BigRational; 2]> {
            let fraction = |x: i64| BigRational::new(x.into(), (divisor * quarter).into());
            points.iter().map(|p| p.map(fraction)).collect()
        };
        let asked = match within {
            i64::MAX => f64::INFINITY,
            within => within as f64 / 4.0,
        };
        let known = lattice.known();
        let doubles = scaled(&lattice.points, 1);
        let places = scaled(&queries, 4);
        let places = Places::new(&doubles, &interior, &places, Some(asked * scale));
        let of_doubles = Surface::new(&doubles, &interior, &known).heights_of(&places);
        let exact = fractions(&lattice.points, 1);
        let places = fractions(&queries, 4);
        // A third of a whole number of quarters is no double: the next one above it is as good.
        let places = Places::new(&exact, &interior, &places, Some((asked / 3.0).next_up()));
        let of_fractions = Surface::new(&exact, &interior, &known).heights_of(&places);
        for (i, query) in queries.iter().enumerate() {
            let Some((denominator, [square, ..], height)) = nearest(&lattice, &triangles, *query)
            else {
                continue;
            };
            let most = i128::from(within).saturating_mul(i128::from(within));
            let is_near = i128::from(square) <= most.saturating_mul(i128::from(denominator));
            let expected = height
                .filter(|_| is_near)
                .map(|[over, under]| over as f64 / under as f64);
            *(if is_near { &mut near } else { &mut far }) += 1;
            ties += usize::from(is_near && square == 25 * denominator);
            for found in [of_doubles[i], of_fractions[i]] {
                let is_right = match (found, expected) {
                    (Some(found), Some(expected)) => (found - expected).abs() < 1e-12,
                    (found, expected) => found == expected,
                };
                assert!(
                    is_right,
                    "round {round}: {query:?} within {within}: {found:?}, not {expected:?}"
                );
            }
        }
    }
    assert!(near > 2000 && far > 2000 && ties > 9, "{near} {far} {ties}");
}

/// Each of many points outside has one side of many near it: looking at all would take hours.
#[test]
fn many_sides_take_no_time() {
    let count = 20_000;
    let corner = |i: i32| {
        let angle = f64::from(i) / f64::from(count) * std::f64::consts::TAU;
        [angle.cos(), angle.sin()]
    };
    let points: Vec<[f64; 2]> = (0..count).map(corner).collect();
    let result = triangulated(&points);
    let whole = Interior::whole(&result);
    let heights: Vec<f64> = points.iter().map(|[x, _]| *x).collect();
    let surface = Surface::new(&points, &whole, &heights);
    let outside: Vec<[f64; 2]> = (0..2000)
        .map(|i| corner(10 * i + 3).map(|x| x * 1.5))
        .collect();
    let places = Places::new(&points, &whole, &outside, Some(f64::INFINITY));
    for ([x, _], found) in outside.iter().zip(surface.heights_of(&places)) {
        assert!(found.is_some_and(|height| (height * 1.5 - x).abs() < 1e-9));
    }
}

#[test]
fn nothing_is_near_where_nothing_is() {
    let points = [[0.0, 0.0], [1.0, 1.0]];
    let result = triangulated(&points);
    let whole = Interior::whole(&result);
    let surface = Surface::new(&points, &whole, &[1.0, 1.0]);
    let places = [[0.5, 0.5], [f64::NAN, 0.0], [f64::INFINITY, 0.0]];
    let found = surface.heights_of(&Places::new(&points, &whole, &places, Some(f64::INFINITY)));
    assert_eq!(found, [None; 3], "points on a line have no border");
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let result = triangulated(&corners);
    let whole = Interior::whole(&result);
    let surface = Surface::new(&corners, &whole, &[1.0; 3]);
    for within in [f64::NAN, -1.0, 0.0] {
        let places = [[-0.5, 0.5], [f64::NAN, 0.0], [f64::INFINITY, 0.0]];
        let found = surface.heights_of(&Places::new(&corners, &whole, &places, Some(within)));
        assert_eq!(found, [None; 3], "{within}");
    }
}

//! Heights of points.

use num_rational::BigRational;
use sweep_cdt::interior::{FillRule, Interior};
use sweep_cdt_generate::Random;
use sweep_cdt_terrain::Surface;

use crate::{Lattice, below, triangulated};

/// Twice the area of a triangle.
fn area(a: [i64; 2], b: [i64; 2], c: [i64; 2]) -> i64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// All triangles that hold the point, each with the height there as a fraction.
#[test]
fn heights_are_those_of_the_definition() {
    let mut random = Random::new(4);
    let (mut found_some, mut found_none) = (0, 0);
    for round in 0..2000 {
        let lattice = Lattice::new(&mut random, round % 3 == 0);
        let points = lattice.doubles();
        let result = triangulated(&points);
        let whole = Interior::whole(&result);
        let surface = Surface::new(&points, &whole, &lattice.known());
        // Points of a lattice four times as fine: many are vertices or on sides.
        let queries: Vec<[i64; 2]> = (0..60)
            .map(|_| [0, 1].map(|_| below(&mut random, 56) - 4))
            .collect();
        let doubles: Vec<[f64; 2]> = queries.iter().map(|q| q.map(|x| x as f64 / 4.0)).collect();
        let heights = surface.heights_at(&doubles);
        for (query, found) in queries.iter().zip(heights) {
            let expected = expected(&lattice, result.triangles(), *query);
            match (found, expected) {
                (None, None) => found_none += 1,
                (Some(found), Some(expected)) if (found - expected).abs() < 1e-11 => {
                    found_some += 1;
                }
                _ => panic!("round {round}: {query:?} has {found:?}, not {expected:?}"),
            }
        }
    }
    assert!(
        found_some > 20_000 && found_none > 20_000,
        "{found_some} {found_none}"
    );
}

/// The height by the definition, where coordinates of the query are in quarters.
fn expected(
    lattice: &Lattice,
    triangles: impl Iterator<Item = [usize; 3]>,
    query: [i64; 2],
) -> Option<f64> {
    for corners in triangles {
        let [a, b, c] = corners.map(|v| lattice.points[v].map(|x| 4 * x));
        let weights = [area(query, b, c), area(a, query, c), area(a, b, query)];
        if weights.iter().any(|&weight| weight < 0) {
            continue;
        }
        // Corners that count have heights.
        let counted = (0..3).filter(|&i| weights[i] > 0);
        let sum = counted
            .map(|i| Some(weights[i] * lattice.heights[corners[i]]?))
            .sum::<Option<i64>>();
        return sum.map(|sum| sum as f64 / weights.iter().sum::<i64>() as f64);
    }
    None
}

#[test]
fn heights_on_a_plane_are_the_planes() {
    let mut random = Random::new(5);
    let mut point = || [0, 1].map(|_| below(&mut random, 1 << 20) as f64 / 1024.0);
    let points: Vec<[f64; 2]> = (0..3000).map(|_| point()).collect();
    let queries: Vec<[f64; 2]> = (0..3000).map(|_| point()).collect();
    let plane = |[x, y]: [f64; 2]| 0.75 * x - 0.5 * y + 12.0;
    let heights: Vec<f64> = points.iter().map(|point| plane(*point)).collect();
    let result = triangulated(&points);
    let whole = Interior::whole(&result);
    let surface = Surface::new(&points, &whole, &heights);
    let found = surface.heights_at(&queries);
    assert!(found.iter().flatten().count() > 2900);
    for (query, found) in queries.iter().zip(found) {
        assert!(found.is_none_or(|height| (height - plane(*query)).abs() < 1e-9));
    }
    assert_eq!(
        surface.heights_at(&points),
        heights.iter().map(|z| Some(*z)).collect::<Vec<_>>()
    );
}

/// The weights of a point in a sliver are differences of numbers that agree in all but their last digits.
#[test]
fn slivers_have_heights_as_good_as_others() {
    let thin = f64::EPSILON;
    let points = [
        [0.0, 0.0],
        [3.0, 3.0 + 4.0 * thin],
        [1.0, 1.0 + 4.0 * thin],
        [9.0, -5.0],
    ];
    let heights = [0.0, 30.0, 1000.0, 0.0];
    let result = sweep_cdt::triangulate(&points, &[[0, 1]]).expect("a correct input");
    let whole = Interior::whole(&result);
    let surface = Surface::new(&points, &whole, &heights);
    let query = [1.5, 1.5 + 3.0 * thin];
    let exact = {
        let fraction = |x: f64| BigRational::from_float(x).expect("finite");
        let rational = |point: [f64; 2]| point.map(fraction);
        let area = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
            let [a, b, c] = [a, b, c].map(rational);
            (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0])
        };
        let [a, b, c] = [points[0], points[1], points[2]];
        let weights = [area(query, b, c), area(a, query, c), area(a, b, query)];
        assert!(
            weights.iter().all(|w| *w > fraction(0.0)),
            "the point is inside"
        );
        let over: BigRational = weights
            .iter()
            .zip(heights)
            .map(|(w, z)| w * fraction(z))
            .sum();
        let whole: BigRational = weights.iter().sum();
        over / whole
    };
    let found = surface.heights_at(&[query])[0].expect("inside");
    let found = BigRational::from_float(found).expect("finite");
    let difference = if found > exact {
        found - exact
    } else {
        exact - found
    };
    assert!(
        difference < BigRational::new(1.into(), 1_000_000_000.into()),
        "{difference}"
    );
}

/// Differences of coordinates, and areas, may be beyond all doubles.
#[test]
fn places_at_the_ends_of_the_range_have_heights() {
    let points = [[-1.2e308, 0.0], [1.2e308, 0.0], [0.0, 1.2e308]];
    let result = triangulated(&points);
    let whole = Interior::whole(&result);
    let surface = Surface::new(&points, &whole, &[0.0, 8.0, 100.0]);
    let found = surface.heights_at(&[[0.6e308, 0.0], [0.0, 0.0], [0.0, 0.6e308]]);
    assert_eq!(found, [Some(6.0), Some(4.0), Some(52.0)]);
    // Products of areas and heights may be below all doubles.
    let points = [[-1.2e-120, 0.0], [1.2e-120, 0.0], [0.0, 1.2e-120]];
    let result = triangulated(&points);
    let whole = Interior::whole(&result);
    let unit = 2.0_f64.powi(-960);
    let heights = [0.0, 8.0 * unit, 100.0 * unit];
    let surface = Surface::new(&points, &whole, &heights);
    assert_eq!(surface.heights_at(&[[0.0, 0.6e-120]]), [Some(52.0 * unit)]);
}

#[test]
fn rationals_have_heights() {
    let third = |x: i64| BigRational::new(x.into(), 3.into());
    let points = [[0, 0], [3, 0], [0, 3], [3, 3]].map(|point| point.map(third));
    let edges = [[0, 3]];
    let result = sweep_cdt::triangulate(&points, &edges).expect("a correct input");
    let whole = Interior::whole(&result);
    let surface = Surface::new(&points, &whole, &[0.0, 9.0, 3.0, 6.0]);
    let queries = [[1, 1], [2, 1], [1, 2], [3, 1], [4, 1]].map(|point| point.map(third));
    // On the diagonal 0 + 6 / 3; below it 9 / 3 + 6 / 3; above it 3 / 3 + 6 / 3; on the border 9 - 3 / 3.
    let expected = [Some(2.0), Some(5.0), Some(3.0), Some(8.0), None];
    assert_eq!(surface.heights_at(&queries), expected);
}

#[test]
fn missing_heights_and_the_outside_have_none() {
    let mut points = vec![[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]];
    points.extend([[3.0, 3.0], [6.0, 3.0], [6.0, 6.0], [3.0, 6.0]]);
    let mut heights: Vec<f64> = points.iter().map(|[x, _]| *x).collect();
    let ring = |first: usize| [0, 1, 2, 3].map(|i| [first + i, first + (i + 1) % 4]);
    let edges = [ring(0), ring(4)].concat();
    let result = sweep_cdt::triangulate(&points, &edges).expect("a correct input");
    let domain = result.interior(FillRule::EvenOdd).expect("closed rings");
    let queries = [
        [4.5, 4.5],
        [3.0, 4.5],
        [3.0, 3.0],
        [1.0, 4.0],
        [9.0, 1.0],
        [9.5, 1.0],
        [f64::NAN, 1.0],
        [1.0, f64::INFINITY],
    ];
    let surface = Surface::new(&points, &domain, &heights);
    let expected = [
        None,
        Some(3.0),
        Some(3.0),
        Some(1.0),
        Some(9.0),
        None,
        None,
        None,
    ];
    assert_eq!(surface.heights_at(&queries), expected);
    heights[0] = f64::NAN;
    let surface = Surface::new(&points, &domain, &heights);
    assert!(surface.missing() >= 2);
    let found = surface.heights_at(&[[0.0, 0.0], [0.5, 0.5], [0.0, 4.5], [0.0, 9.0], [3.0, 4.5]]);
    assert_eq!(found, [None, None, None, Some(0.0), Some(3.0)]);
}

#[test]
fn few_points_and_none_have_no_triangles() {
    for points in [
        vec![],
        vec![[1.0, 1.0]],
        vec![[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]],
    ] {
        let heights = vec![1.0; points.len()];
        let result = triangulated(&points);
        let whole = Interior::whole(&result);
        let surface = Surface::new(&points, &whole, &heights);
        assert_eq!(surface.heights_at(&[[1.0, 1.0]]), [None]);
        assert_eq!(surface.heights_at(&[]), []);
        assert_eq!(surface.range(), None);
        assert_eq!(surface.contours(&[0.5]), Ok(vec![]));
    }
}

/// Long thin triangles side by side, and as many points on each: a walk from point to point would pass most of them each
/// time.
#[test]
fn many_thin_triangles_take_no_time() {
    let count = 20_000_i32;
    let points: Vec<[f64; 2]> = (0..count)
        .map(|i| [f64::from(i % 2) * 1e6, f64::from(i)])
        .collect();
    let edges: Vec<[usize; 2]> = (1..points.len()).map(|i| [i - 1, i]).collect();
    let result = sweep_cdt::triangulate(&points, &edges).expect("a zigzag");
    let whole = Interior::whole(&result);
    let heights: Vec<f64> = points.iter().map(|[_, y]| *y).collect();
    let surface = Surface::new(&points, &whole, &heights);
    let mut random = Random::new(6);
    let queries: Vec<[f64; 2]> = (0..50_000)
        .map(|_| {
            let [x, y] = [1_000_000, 19_990].map(|most| below(&mut random, most) as f64);
            [x, y + 2.0]
        })
        .collect();
    let found = surface.heights_at(&queries);
    for ([_, y], found) in queries.iter().zip(found) {
        assert!(
            found.is_some_and(|height| (height - y).abs() < 1e-7),
            "{y} {found:?}"
        );
    }
}

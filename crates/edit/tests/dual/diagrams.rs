//! Voronoi diagrams, compared with distances to all points.

use std::cmp::Ordering;

use num_rational::BigRational;
use sweep_cdt::crossings::Exact;
use sweep_cdt::triangulate;
use sweep_cdt_edit::{Voronoi, VoronoiError};
use sweep_cdt_testing::Random;

use crate::{Place, area, below, distance, whole};

/// Points of a kind: on a lattice, on a circle and in it, even ones, on one line.
fn points(kind: usize, random: &mut Random) -> Vec<[i64; 2]> {
    const CIRCLE: [[i64; 2]; 8] = [
        [5, 0],
        [4, 3],
        [3, 4],
        [0, 5],
        [-5, 0],
        [-4, -3],
        [3, -4],
        [0, -5],
    ];
    let count = 1 + random.below(14);
    let mut point = || match kind {
        0 => [below(random, 5), below(random, 5)],
        1 => random.pick(&CIRCLE),
        2 => [below(random, 1 << 12), below(random, 1 << 12)],
        _ => {
            let i = below(random, 9);
            [2 * i, 3 * i]
        }
    };
    (0..count).map(|_| point()).collect()
}

#[test]
fn every_place_is_in_the_cell_of_the_nearest_point() {
    let mut random = Random::new(17);
    for case in 0..200 {
        let given = points(case % 4, &mut random);
        let exact: Vec<Place> = given.iter().map(|point| point.map(whole)).collect();
        let result = triangulate(&exact, &[]).expect("points");
        let voronoi = Voronoi::new(&result, &exact).expect("no edges");
        let nearest = |place: &Place| {
            exact
                .iter()
                .map(|p| distance(place, p))
                .min()
                .expect("a point")
        };
        // No point is nearer to a Voronoi vertex than the points of its cells, and it is the vertex of three at least.
        for (v, place) in voronoi.vertices.iter().enumerate() {
            let cells = (0..exact.len()).filter(|&p| voronoi.cells[p].contains(&v));
            let of: Vec<usize> = cells.filter(|&p| result.representative(p) == p).collect();
            assert!(of.len() >= 3, "{given:?}");
            for (p, point) in exact.iter().enumerate() {
                let order = distance(place, point).cmp(&nearest(place));
                let is_of = of.contains(&result.representative(p));
                assert_eq!(order == Ordering::Equal, is_of, "{given:?}");
            }
        }
        // A cell has each of its vertices once, counter-clockwise.
        for cell in &voronoi.cells {
            let places: Vec<Place> = cell.iter().map(|&v| voronoi.vertices[v].clone()).collect();
            assert!(
                (1..cell.len()).all(|i| !cell[..i].contains(&cell[i])),
                "{given:?}"
            );
            assert!(area(&places) >= whole(0), "{given:?}");
        }
        // Ridges lie between the cells of their points.
        for ridge in &voronoi.ridges {
            for point in ridge.points {
                let ends = ridge.ends.iter().flatten();
                assert!(
                    ends.clone().all(|end| voronoi.cells[point].contains(end)),
                    "{given:?}"
                );
            }
        }
        // The cells tile a box, and each corner of a cell is nearest to its point.
        let far = whole(if case % 2 == 0 { 10_000 } else { 3 });
        let corner = |x: &BigRational, y: &BigRational| [x.clone(), y.clone()];
        let low = -&far;
        let square = [
            corner(&low, &low),
            corner(&far, &low),
            corner(&far, &far),
            corner(&low, &far),
        ];
        let mut sum = whole(0);
        for (p, point) in exact.iter().enumerate() {
            let cell = voronoi.cell_within(p, &square).expect("a point");
            assert!(
                cell.iter()
                    .all(|place| distance(place, point) == nearest(place)),
                "{given:?}"
            );
            if result.representative(p) == p {
                sum += area(&cell);
            }
        }
        assert_eq!(sum, area(&square), "{given:?}");
    }
}

#[test]
fn doubles_are_fractions_rounded_once() {
    let mut random = Random::new(23);
    for case in 0..40 {
        let given = points(case % 3, &mut random);
        let doubles: Vec<[f64; 2]> = given
            .iter()
            .map(|point| point.map(|x| x as f64 / 7.0))
            .collect();
        let exact: Vec<Place> = doubles
            .iter()
            .map(|point| point.map(|x| x.to_fraction()))
            .collect();
        let of = |points: &[[f64; 2]]| triangulate(points, &[]).expect("points");
        let result = of(&doubles);
        let rounded = Voronoi::new(&result, &doubles).expect("no edges");
        let voronoi = Voronoi::new(&result, &exact).expect("no edges");
        let nearest: Vec<[f64; 2]> = voronoi
            .vertices
            .iter()
            .map(|place| place.each_ref().map(f64::nearest))
            .collect();
        assert_eq!(rounded.vertices, nearest);
        assert_eq!(
            (rounded.ridges, rounded.cells),
            (voronoi.ridges, voronoi.cells)
        );
    }
}

#[test]
fn edges_that_are_in_the_way_are_refused() {
    let kite = [[0, 0], [4, -1], [8, 0], [4, 1]].map(|point| point.map(f64::from));
    let free = triangulate(&kite, &[]).expect("a kite");
    assert!(Voronoi::new(&free, &kite).is_ok());
    let result = triangulate(&kite, &[[0, 2]]).expect("one edge");
    let side = [0, 2];
    assert_eq!(
        Voronoi::new(&result, &kite),
        Err(VoronoiError::NotDelaunay { side })
    );
    // An edge along a Delaunay side is none.
    let result = triangulate(&kite, &[[1, 3]]).expect("one edge");
    assert!(Voronoi::new(&result, &kite).is_ok());
    assert_eq!(
        Voronoi::new(&result, &kite[..3]),
        Err(VoronoiError::OtherInput)
    );
    let voronoi = Voronoi::new(&result, &kite).expect("a kite");
    let point = 4;
    assert_eq!(
        voronoi.cell_within(point, &kite),
        Err(VoronoiError::NoPoint { point })
    );
    let open = [kite[0], [f64::NAN, 0.0], kite[2]];
    let corner = 1;
    assert_eq!(
        voronoi.cell_within(0, &open),
        Err(VoronoiError::NonFiniteCorner { corner })
    );
}

/// Points of another triangulation, as many: refused, or a diagram of what they are, but no panic.
#[test]
fn points_of_others_are_no_panic() {
    let mut random = Random::new(29);
    let mut refused = 0;
    for case in 0..400 {
        let given = points(case % 4, &mut random);
        let doubles: Vec<[f64; 2]> = given.iter().map(|point| point.map(|x| x as f64)).collect();
        let result = triangulate(&doubles, &[]).expect("points");
        let mut others = doubles.clone();
        for other in &mut others {
            let numbers = [f64::NAN, 0.0, 1.0, -7.0, f64::MAX];
            *other = if random.one_in(2) {
                *other
            } else {
                [random.pick(&numbers), random.pick(&numbers)]
            };
        }
        refused += usize::from(Voronoi::new(&result, &others).is_err());
    }
    assert!(refused > 100, "{refused}");
}

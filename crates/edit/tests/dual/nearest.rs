//! Nearest points and natural neighbours, compared with all points and with the cells of fresh diagrams.

use num_rational::BigRational;
use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::FillRule;
use sweep_cdt_edit::{DynamicTriangulation, Edits, Voronoi, VoronoiError};
use sweep_cdt_testing::Random;

use crate::{Place, area, below, distance, whole};

/// Lattices, lines, even points, and points far from the origin, from one to sixty.
fn points(kind: usize, random: &mut Random) -> Vec<[i64; 2]> {
    let count = 1 + random.below(60);
    let mut point = || match kind {
        0 => [below(random, 6), below(random, 6)],
        1 => [3 * below(random, 9), 0],
        2 => [below(random, 1 << 20), below(random, 1 << 20)],
        3 => [below(random, 40), below(random, 3)],
        _ => [(1 << 50) + below(random, 9), (1 << 50) + below(random, 9)],
    };
    (0..count).map(|_| point()).collect()
}

/// A place near the points: one of them, in the middle of two, or moved a little or far.
fn near(points: &[[i64; 2]], random: &mut Random) -> [i64; 2] {
    let [p, q] = [0, 1].map(|_| random.pick(points));
    let far = random.pick(&[0, 0, 1, 7, 1 << 21]);
    [0, 1].map(|k| i64::midpoint(p[k], q[k]) + far * (below(random, 3) - 1))
}

fn squared_distance(p: &[i64; 2], q: &[i64; 2]) -> i128 {
    let along = |k: usize| i128::from(p[k]) - i128::from(q[k]);
    along(0) * along(0) + along(1) * along(1)
}

fn assert_nearest<S: Exact>(convert: impl Fn(i64) -> S, cases: usize) {
    let mut random = Random::new(41);
    let mut constrained = 0;
    for case in 0..cases {
        let given = points(case % 5, &mut random);
        let mut edited = DynamicTriangulation::new();
        let places = given.iter().map(|point| point.map(&convert)).collect();
        let batch = Edits {
            points: places,
            ..Edits::default()
        };
        edited.apply(batch).expect("finite points");
        for _ in 0..random.below(12) {
            let ends = [0, 1].map(|_| random.below(given.len()));
            constrained += usize::from(edited.insert_edge(ends).is_ok());
        }
        for _ in 0..20 {
            let place = near(&given, &mut random);
            let distance = |&i: &usize| squared_distance(&given[i], &place);
            let nearest = (0..given.len()).min_by_key(distance);
            let found = edited.nearest(&place.map(&convert));
            assert_eq!(
                found,
                nearest,
                "{place:?} of {given:?}, edges {:?}",
                edited.edges().collect::<Vec<_>>()
            );
        }
    }
    assert!(constrained > cases, "{constrained}");
}

#[test]
fn no_point_is_nearer_than_the_nearest() {
    assert_nearest(|x| x as f64, 400);
    // Fractions that no double holds.
    assert_nearest(|x| BigRational::new(x.into(), 3.into()), 40);
}

#[test]
fn nothing_is_nearest_to_what_is_no_place() {
    let mut edited = DynamicTriangulation::new();
    assert_eq!(edited.nearest(&[0.0, 0.0]), None);
    edited.insert([1.0, 1.0]).expect("a point");
    assert_eq!(edited.nearest(&[f64::NAN, 0.0]), None);
    assert_eq!(edited.nearest(&[f64::MAX, 0.0]), Some(0));
}

/// Weights by another way: the cell of the place in a fresh diagram with it, cut with the old cell of each point.
#[test]
fn weights_are_parts_of_the_cell() {
    let mut random = Random::new(43);
    let mut inside = 0;
    for case in 0..250 {
        let given = points([0, 2, 3, 4][case % 4], &mut random);
        let exact: Vec<Place> = given.iter().map(|point| point.map(whole)).collect();
        let mut edited = DynamicTriangulation::new();
        let batch = Edits {
            points: exact.clone(),
            ..Edits::default()
        };
        edited.apply(batch).expect("points");
        let place = near(&given, &mut random).map(whole);
        let weights = edited.natural_neighbors(&place).expect("no edges");
        if weights.is_empty() {
            continue;
        }
        let sum: BigRational = weights.iter().map(|(_, weight)| weight).sum();
        assert_eq!(sum, whole(1), "{given:?}, {place:?}");
        for k in 0..2 {
            let mean: BigRational = weights
                .iter()
                .map(|(p, weight)| weight * &exact[*p][k])
                .sum();
            assert_eq!(mean, place[k], "{given:?}, {place:?}");
        }
        // The cell of the place is bounded if it lies strictly inside of the hull.
        let mut with = exact.clone();
        with.push(place.clone());
        let new = sweep_cdt::triangulate(&with, &[]).expect("points");
        let is_on_hull = new.vertex_stars().is_on_hull(given.len());
        if is_on_hull || new.representative(given.len()) != given.len() {
            continue;
        }
        inside += 1;
        let diagram = Voronoi::new(&new, &with).expect("no edges");
        let corners = diagram.cells[given.len()].iter();
        let cell: Vec<Place> = corners.map(|&v| diagram.vertices[v].clone()).collect();
        let old = sweep_cdt::triangulate(&exact, &[]).expect("points");
        let before = Voronoi::new(&old, &exact).expect("no edges");
        for p in (0..exact.len()).filter(|&p| old.representative(p) == p) {
            let part = area(&before.cell_within(p, &cell).expect("a point"));
            let weight = weights.iter().find(|(q, _)| *q == p);
            let weight = weight.map_or_else(|| whole(0), |(_, weight)| weight.clone());
            assert_eq!(weight, part / area(&cell), "{given:?}, {place:?}");
        }
    }
    assert!(inside > 60, "{inside}");
}

#[test]
fn weights_at_points_on_the_hull_and_outside() {
    let mut square = DynamicTriangulation::new();
    for corner in [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]] {
        square.insert(corner).expect("a point");
    }
    let weights = |place: [f64; 2]| square.natural_neighbors(&place).expect("no edges");
    assert_eq!(weights([4.0, 4.0]), [(2, 1.0)]);
    assert_eq!(weights([4.0, 3.0]), [(1, 0.25), (2, 0.75)]);
    assert_eq!(weights([5.0, 3.0]), []);
    let edge = square.insert_edge([0, 2]).expect("an edge");
    assert_eq!(
        square.natural_neighbors(&[1.0, 1.0]),
        Err(VoronoiError::Edge { edge })
    );
}

/// The parts of all cells inside a domain with a hole cover it, and each corner is as near to its point as to any other.
#[test]
fn cells_tile_a_domain_with_a_hole() {
    let ring = |low: i64, high: i64| [[low, low], [high, low], [high, high], [low, high]];
    let mut corners: Vec<[i64; 2]> = ring(0, 12).into_iter().chain(ring(4, 7)).collect();
    // A notch that reaches to a corner of the hole.
    corners.splice(4..4, [[0, 5], [4, 4], [0, 3]]);
    let count = corners.len();
    let exact: Vec<Place> = corners.iter().map(|corner| corner.map(whole)).collect();
    let outer = count - 4;
    let mut edges: Vec<[usize; 2]> = (0..outer).map(|i| [i, (i + 1) % outer]).collect();
    edges.extend((0..4).map(|i| [outer + i, outer + (i + 1) % 4]));
    let result = sweep_cdt::triangulate(&exact, &edges).expect("a domain");
    let domain = result.interior(FillRule::EvenOdd).expect("closed");
    let of = |t: [usize; 3]| area(&t.map(|v| exact[v].clone()));
    let total: BigRational = domain.triangles().map(of).sum();
    let mut random = Random::new(47);
    let mut split = 0;
    for case in 0..60 {
        let sites: Vec<Place> = (0..1 + random.below(9))
            .map(|_| [0, 1].map(|_| whole(below(&mut random, 15) - 1)))
            .collect();
        let result = sweep_cdt::triangulate(&sites, &[]).expect("points");
        let voronoi = Voronoi::new(&result, &sites).expect("no edges");
        let mut sum = whole(0);
        for (p, site) in sites.iter().enumerate() {
            let polygons = voronoi.cell_inside(p, &domain, &exact).expect("a point");
            split += usize::from(polygons.len() > 1);
            for ring in polygons.iter().flatten() {
                for corner in ring {
                    let nearest = sites.iter().map(|other| distance(corner, other)).min();
                    assert_eq!(nearest, Some(distance(corner, site)), "case {case}");
                }
                if result.representative(p) == p {
                    sum += area(ring);
                }
                let mut places = ring.clone();
                places.sort();
                places.dedup();
                assert_eq!(
                    places.len(),
                    ring.len(),
                    "case {case}: a ring touches itself"
                );
            }
        }
        assert_eq!(sum, total, "case {case}");
    }
    assert!(split > 10, "{split}");
}

/// A hole that touches the outer ring twice cuts a domain in two. The domain is turned, so that each place comes first.
#[test]
fn parts_that_touch_are_rings_of_their_own() {
    let mut corners = [
        [1, 0],
        [3, 0],
        [4, 2],
        [3, 4],
        [1, 4],
        [0, 2],
        [2, 1],
        [2, 3],
    ];
    let outer = (0..6).map(|i| [i, (i + 1) % 6]);
    let edges: Vec<[usize; 2]> = outer.chain([[5, 6], [6, 2], [2, 7], [7, 5]]).collect();
    let site = [[whole(1), whole(1)]];
    let result = sweep_cdt::triangulate(&site, &[]).expect("a point");
    let voronoi = Voronoi::new(&result, &site).expect("no edges");
    for _ in 0..4 {
        corners = corners.map(|[x, y]| [-y, x]);
        let exact = corners.map(|corner| corner.map(whole));
        let result = sweep_cdt::triangulate(&exact, &edges).expect("a domain");
        let domain = result.interior(FillRule::EvenOdd).expect("closed");
        let polygons = voronoi.cell_inside(0, &domain, &exact).expect("a point");
        let rings: Vec<_> = polygons.into_iter().flatten().collect();
        let areas: Vec<BigRational> = rings.iter().map(|ring| area(ring)).collect();
        assert_eq!(areas, [whole(8), whole(8)], "{corners:?}");
        assert!(rings.iter().all(|ring| ring.len() == 5), "{corners:?}");
    }
}

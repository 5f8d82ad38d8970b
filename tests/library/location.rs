//! Where points lie, and what is around a vertex, against a look at all triangles in whole numbers.

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::scalar::{Scalar, orient2d};
use sweep_cdt::{Algorithm, Location, Triangulation, Triangulator, triangulate};
use sweep_cdt_testing::families::{self, Family};
use sweep_cdt_testing::{Input, Random};

type Point = [i64; 2];

/// Points of a lattice of even numbers, and edges that are pieces of its rows or do not cross for other reasons:
/// those that a triangulation takes one by one.
pub(crate) fn input(
    random: &mut Random,
    count: usize,
    width: usize,
) -> (Vec<Point>, Vec<[usize; 2]>) {
    let even = |random: &mut Random| i64::try_from(random.below(width)).expect("small") * 2;
    let points: Vec<Point> = (0..count).map(|_| [even(random), even(random)]).collect();
    let mut edges = Vec::new();
    for _ in 0..count / 2 {
        edges.push([random.below(count), random.below(count)]);
        if triangulate(&points, &edges).is_err() {
            edges.pop();
        }
    }
    (points, edges)
}

/// What a look at every triangle finds.
fn expected(result: &Triangulation, points: &[Point], query: Point) -> Location {
    let turn = |a: Point, b: Point| {
        let [[ax, ay], [bx, by], [x, y]] = [a, b, query].map(|p| p.map(i128::from));
        (bx - ax) * (y - ay) - (by - ay) * (x - ax)
    };
    if result.is_empty() {
        return Location::Outside;
    }
    if let Some(vertex) = points.iter().position(|&point| point == query) {
        return Location::Vertex(vertex);
    }
    for (t, corners) in result.triangles().enumerate() {
        let [a, b, c] = corners.map(|v| points[v]);
        let turns = [turn(b, c), turn(c, a), turn(a, b)];
        if turns.iter().all(|&turn| turn > 0) {
            return Location::Triangle(t);
        }
        if turns.iter().all(|&turn| turn >= 0) {
            let side = turns.iter().position(|&turn| turn == 0).expect("one is");
            return Location::Side { triangle: t, side };
        }
    }
    Location::Outside
}

/// From everywhere, in one scalar.
fn check<S: Scalar>(points: &[[S; 2]], query: &[S; 2], result: &Triangulation, right: Location) {
    assert_eq!(result.with_points(points).locate(query), right);
    let some = (0..result.len()).step_by(1 + result.len() / 7);
    for hint in some.chain([result.len(), usize::MAX]) {
        assert_eq!(
            result.with_points(points).locate_from(query, hint),
            right,
            "from {hint}"
        );
    }
}

#[test]
fn every_point_of_a_lattice_is_found() {
    let mut random = Random::new(1);
    let mut found = [0; 4];
    for round in 0..60 {
        let (count, width) = [(3, 2), (8, 3), (20, 5), (60, 7), (120, 40)][round % 5];
        let (points, edges) = input(&mut random, count, width);
        let result = triangulate(&points, &edges).expect("edges that do not cross");
        let doubles: Vec<_> = points.iter().map(|p| p.map(|x| x as f64 * 0.5)).collect();
        let third = |x: i64| BigRational::new(x.into(), BigInt::from(3));
        let thirds: Vec<_> = points.iter().map(|p| p.map(third)).collect();
        let end = 2 * i64::try_from(width).expect("small");
        let (mut queries, mut all) = (Vec::new(), Vec::new());
        for x in (-1..end).step_by(1 + width / 10) {
            for y in (-1..end).step_by(1 + width / 10) {
                let right = expected(&result, &points, [x, y]);
                check(&points, &[x, y], &result, right);
                check(&doubles, &[x, y].map(|x| x as f64 * 0.5), &result, right);
                check(&thirds, &[x, y].map(third), &result, right);
                queries.push([x, y]);
                all.push(right);
                found[match right {
                    Location::Triangle(_) => 0,
                    Location::Side { .. } => 1,
                    Location::Vertex(_) => 2,
                    Location::Outside => 3,
                }] += 1;
            }
        }
        // By walks, by the sweep alone, and as many of each as it comes to.
        for steps in [0, 1, 4, usize::MAX] {
            let view = result.with_points(&points);
            assert_eq!(view.locate_within(&queries, steps).0, all, "{steps} steps");
        }
        let exact: Vec<_> = queries.iter().map(|query| query.map(third)).collect();
        assert_eq!(result.with_points(&thirds).locate_all(&exact), all);
    }
    assert!(found.iter().all(|&count| count > 300), "{found:?}");
}

/// Doubles next to a side, whose determinant rounds to zero or to the wrong sign.
#[test]
fn points_next_to_a_side_are_told_from_those_on_it() {
    let points = [
        [12.0, 12.0],
        [24.0, 24.0],
        [0.5, 0.5],
        [30.0, 1.0],
        [1.0, 30.0],
    ];
    let result = triangulate(&points, &[[2, 1]]).expect("one edge");
    let at = |x: f64, y: f64| result.with_points(&points).locate(&[x, y]);
    let next = 5.0_f64.next_up();
    assert!(matches!(at(5.0, 5.0), Location::Side { .. }));
    let (below, above) = (at(next, 5.0), at(5.0, next));
    assert!(matches!((below, above), (Location::Triangle(a), Location::Triangle(b)) if a != b));
}

#[test]
fn what_is_no_number_is_outside() {
    let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let many = Random::new(4).points(100);
    for points in [&points[..], &many] {
        let result = triangulate(points, &[]).expect("no edges");
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let queries = [[x, 0.1], [0.1, x], [x, x]];
            for query in queries {
                check(points, &query, &result, Location::Outside);
            }
            let found = result.with_points(points).locate_all(&queries);
            assert_eq!(found, [Location::Outside; 3]);
        }
    }
    let line = triangulate(&points[..2], &[]).expect("no edges");
    assert_eq!(
        line.with_points(&points[..2]).locate(&[0.0, 0.0]),
        Location::Outside
    );
}

/// Many triangles, where the walk is long: the number of steps is not counted, but a look at all would take minutes.
#[test]
fn many_points_are_found_among_many() {
    let points = Random::new(2).points(100_000);
    let result = triangulate(&points, &[]).expect("no edges");
    for query in Random::new(3).points(20_000) {
        // Away from the hull.
        let query = query.map(|x| 0.05 + 0.9 * x);
        let Location::Triangle(t) = result.with_points(&points).locate(&query) else {
            panic!("random points lie inside of triangles: {query:?}");
        };
        let [a, b, c] = result.triangle(t).map(|v| points[v]);
        let turns = [[a, b], [b, c], [c, a]].map(|[a, b]| orient2d(&a, &b, &query));
        assert!(turns.iter().all(|turn| turn.is_gt()), "{query:?}");
    }
}

#[test]
fn stars_have_all_triangles_in_order() {
    let mut random = Random::new(4);
    for round in 0..40 {
        let (count, width) = [(3, 2), (8, 3), (30, 5), (60, 30)][round % 4];
        let (points, edges) = input(&mut random, count, width);
        let result = triangulate(&points, &edges).expect("edges that do not cross");
        let stars = result.vertex_stars();
        for v in 0..count + 2 {
            let around: Vec<_> = stars.star(v).collect();
            let vertex = result.representative(v);
            let corner = |t: usize| result.triangle(t).iter().position(|&w| w == vertex);
            let has = |t| corner(t).map(|corner| (t, corner));
            let mut sorted = around.clone();
            sorted.sort_unstable();
            assert_eq!(
                sorted,
                (0..result.len()).filter_map(has).collect::<Vec<_>>()
            );
            for pair in around.windows(2) {
                let [(t, i), (u, j)] = [pair[0], pair[1]];
                let shared = [
                    result.triangle(t)[(i + 2) % 3],
                    result.triangle(u)[(j + 1) % 3],
                ];
                assert_eq!(shared[0], shared[1], "counter-clockwise");
            }
            let (Some(&(t, i)), Some(&(u, j))) = (around.first(), around.last()) else {
                continue;
            };
            let mut neighbors: Vec<usize> = result
                .sides()
                .flat_map(|[a, b]| [[a, b], [b, a]])
                .filter(|side| side[0] == vertex)
                .map(|side| side[1])
                .collect();
            neighbors.sort_unstable();
            let mut found: Vec<usize> = stars.neighbors(v).collect();
            assert_eq!(found[0], result.triangle(t)[(i + 1) % 3]);
            found.sort_unstable();
            assert_eq!(found, neighbors);
            let is_on_hull = result.hull().any(|w| w == vertex);
            assert_eq!(stars.is_on_hull(v), is_on_hull);
            let [clockwise, other] = [(t, (i + 2) % 3), (u, (j + 1) % 3)];
            let across = [clockwise, other].map(|(t, side)| result.neighbor(t, side));
            assert_eq!(
                across,
                if is_on_hull {
                    [None; 2]
                } else {
                    [Some(u), Some(t)]
                }
            );
        }
    }
}

#[test]
fn sides_are_listed_once_and_have_twins() {
    let (points, edges) = input(&mut Random::new(5), 60, 30);
    let result = triangulate(&points, &edges).expect("edges that do not cross");
    let mut expected = Vec::new();
    for (t, side) in (0..result.len()).flat_map(|t| [0, 1, 2].map(|side| (t, side))) {
        let [a, b] = result.side(t, side);
        assert!(!result.side(t, side).contains(&result.triangle(t)[side]));
        match result.twin(t, side) {
            Some((across, other)) => {
                assert_eq!(result.twin(across, other), Some((t, side)));
                assert_eq!(result.side(across, other), [b, a]);
                assert_eq!(result.neighbor(t, side), Some(across));
            }
            None => assert_eq!(result.neighbor(t, side), None),
        }
        expected.push([a.min(b), a.max(b)]);
    }
    expected.sort_unstable();
    expected.dedup();
    let mut sides: Vec<[usize; 2]> = result.sides().map(|[a, b]| [a.min(b), a.max(b)]).collect();
    sides.sort_unstable();
    assert_eq!(sides, expected);
}

#[test]
fn results_are_equal_however_they_came_about() {
    let (points, edges) = input(&mut Random::new(6), 60, 30);
    let result = triangulate(&points, &edges).expect("edges that do not cross");
    let other = Triangulator::new().algorithm(Algorithm::DivideAndConquer);
    assert_eq!(other.triangulate(&points, &edges), Ok(result.clone()));
    let turned: Vec<[usize; 2]> = edges.iter().map(|&[a, b]| [b, a]).collect();
    assert_ne!(triangulate(&points, &turned), Ok(result.clone()));
    assert_ne!(triangulate(&points, &edges[1..]), Ok(result.clone()));
    assert_ne!(triangulate(&points[..points.len() - 1], &[]), Ok(result));
}

/// Points within the box of a family's member, and others halfway between two of its vertices.
fn queries(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let middle =
        |a: [f64; 2], b: [f64; 2], part: f64| [0, 1].map(|i| a[i] * part + b[i] * (1.0 - part));
    let (mut low, mut high) = (points[0], points[0]);
    for point in points {
        low = [0, 1].map(|i| point[i].min(low[i]));
        high = [0, 1].map(|i| point[i].max(high[i]));
    }
    let mut random = Random::new(7);
    let count = points.len();
    let query = |i: usize| {
        if i.is_multiple_of(2) {
            let [x, y] = [random.unit(), random.unit()];
            [middle(low, high, x)[0], middle(low, high, y)[1]]
        } else {
            middle(
                points[random.below(count)],
                points[random.below(count)],
                0.5,
            )
        }
    };
    (0..count).map(query).collect()
}

/// Slivers, fans and clusters, where a walk from one point to the next may pass most triangles: the walks end, and the
/// sweep finds what is left. No order of the points makes a difference.
#[test]
fn many_points_in_slivers_take_few_steps() {
    let mut given_up = 0;
    let mut most: f64 = 0.0;
    let evenly = |family: &Family| ["uniform", "lattice"].contains(&family.name);
    for family in families::all().chain(families::slanted()) {
        for n in [500, 4000] {
            let Input { points, edges } = families::scattered(&(family.member)(n));
            let result = triangulate(&points, &edges).expect("edges that do not cross");
            let view = result.with_points(&points);
            let mut queries = queries(&points);
            let (found, steps) = view.locate_within(&queries, 4);
            let (swept, none) = view.locate_within(&queries, 0);
            assert_eq!((&found, none), (&swept, 0), "{}", family.name);
            for (query, found) in queries.iter().zip(&found).step_by(n / 20) {
                assert_eq!(view.locate(query), *found, "{}", family.name);
            }
            queries.reverse();
            let backwards = view.locate_all(&queries);
            assert!(backwards.iter().rev().eq(&found), "{}", family.name);
            let spent = 4 * (result.len() + queries.len());
            assert!(steps <= spent, "{}", family.name);
            given_up += usize::from(steps == spent);
            if evenly(&family) {
                most = most.max(steps as f64 / queries.len() as f64);
            }
        }
    }
    assert!(given_up > 5, "walks were given up {given_up} times");
    assert!(most < 6.0, "{most} steps a point among even triangles");
}

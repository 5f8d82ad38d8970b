//! Refined meshes keep their bounds, are those of a fresh run, and say what stayed and why.

use std::collections::BTreeSet;

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::{FillRule, Interior};
use sweep_cdt::triangulate;
use sweep_cdt_edit::{Bounds, BoundsError, Broken, Reason, RefineError, Refined, Refinement};
use sweep_cdt_generate::KINDS;
use sweep_cdt_testing::data::Hard;
use sweep_cdt_testing::{Input, Random};

fn angle(least: f64) -> Bounds {
    Bounds {
        least_angle: Some(least),
        ..Bounds::default()
    }
}

/// Panics unless a refined mesh keeps all promises.
fn assert_mesh<S: Exact + PartialEq>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    bounds: Bounds,
    mesh: &Refined<S>,
    name: &str,
) {
    assert!(
        mesh.points[..points.len()] == *points,
        "{name}: given points"
    );
    // The triangles are those of a fresh run on the points and parts.
    let fresh = triangulate(&mesh.points, &mesh.edges).expect(name);
    let all: BTreeSet<[usize; 3]> = fresh.canonical_triangles().into_iter().collect();
    assert!(mesh.triangles.iter().all(|t| all.contains(t)), "{name}");
    // The bounds; of small meshes on fractions, which no filter decides.
    let exactly = |point: &[S; 2]| point.each_ref().map(S::to_fraction);
    let broken = if mesh.points.len() < 1_000 {
        let exact: Vec<[BigRational; 2]> = mesh.points.iter().map(exactly).collect();
        bounds.violations(&exact, &mesh.triangles)
    } else {
        bounds.violations(&mesh.points, &mesh.triangles)
    };
    let broken = broken.expect(name);
    let left: Vec<(usize, Broken)> = mesh.left.iter().map(|l| (l.triangle, l.bound)).collect();
    assert_eq!(broken, left, "{name}");
    // The parts of each edge are a chain from end to end.
    let of_input = triangulate(points, edges).expect(name);
    for (e, ends) in edges.iter().enumerate() {
        let parts = mesh.edges.iter().zip(&mesh.edge_of);
        let parts: Vec<_> = parts.filter(|(_, of)| **of == Some(e)).collect();
        let [a, b] = ends.map(|v| of_input.representative(v));
        let mut at = a;
        for ([from, to], _) in parts {
            assert_eq!(at, *from, "{name}: edge {e}");
            at = *to;
        }
        assert_eq!(at, b, "{name}: edge {e}");
    }
}

/// The bound that a triangle breaks.
fn broken<S: Exact>(bounds: Bounds, corners: &[[S; 2]; 3]) -> Option<Broken> {
    let violations = bounds.violations(corners, &[[0, 1, 2]]);
    Some(violations.expect("bounds and points").first()?.1)
}

/// Twice the area of all triangles.
fn area(points: &[[BigRational; 2]], triangles: impl Iterator<Item = [usize; 3]>) -> BigRational {
    let zero = || BigRational::from_integer(0.into());
    triangles.fold(zero(), |sum, t| {
        let [a, b, c] = t.map(|v| &points[v]);
        sum + (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0])
    })
}

#[test]
fn generated_inputs_keep_their_bounds() {
    for kind in KINDS {
        // Outliers make a strip 48 million long and 12 high, which needs millions of points.
        let may_end = kind.name == "outliers";
        for (least, rule) in [(20.0, None), (26.0, Some(FillRule::EvenOdd))] {
            let input = Input::generated(kind.name, 16, 7);
            let name = format!("{} {least}", kind.name);
            let (points, edges) = (&input.points, &input.edges);
            let result = triangulate(points, edges).expect("a correct input");
            // Edges that are no rings have no inside.
            let inside = rule.and_then(|rule| result.interior(rule).ok());
            let inside = inside.filter(|inside| inside.inside().len() > 0);
            let inside = inside.unwrap_or_else(|| Interior::whole(&result));
            let most = if may_end { 500 } else { 30_000 };
            let refinement = Refinement::new(angle(least)).most_points(most);
            let mesh = refinement.run(points, edges, &inside).expect(&name);
            assert_mesh(points, edges, angle(least), &mesh, &name);
            let limit = mesh.left.iter().find(|left| left.reason == Reason::Limit);
            assert!(
                may_end || limit.is_none(),
                "{name}: {} points",
                mesh.points.len()
            );
        }
    }
}

#[test]
fn hard_inputs_end() {
    for Hard { name, input, .. } in Hard::own() {
        let (points, edges) = (&input.points, &input.edges);
        let Ok(result) = triangulate(points, edges) else {
            continue;
        };
        let most = points.len() + 300;

        let refinement = Refinement::new(angle(20.0)).most_points(most);
        let mesh = refinement.run(points, edges, &Interior::whole(&result));
        let mesh = mesh.expect(&name);
        assert_mesh(points, edges, angle(20.0), &mesh, &name);
        assert!(mesh.points.len() <= most.max(points.len()), "{name}");
    }
}

/// With fractions every new point of an edge lies on it, so that the area stays.
#[test]
fn fractions_keep_the_area() {
    let mut random = Random::new(5);
    for round in 0..5 {
        let mut fraction = || BigRational::new(BigInt::from(random.below(1000)), 7.into());
        let points: Vec<[BigRational; 2]> = (0..12).map(|_| [fraction(), fraction()]).collect();
        let edges = [[0, 1]];
        let result = triangulate(&points, &edges).expect("one edge");
        let bounds = Bounds {
            greatest_area: Some(500.0),
            ..angle(20.0)
        };
        let mesh = Refinement::new(bounds).run(&points, &edges, &Interior::whole(&result));
        let mesh = mesh.expect("a correct input");
        assert_mesh(&points, &edges, bounds, &mesh, &format!("round {round}"));
        let before = area(&points, result.triangles());
        assert_eq!(area(&mesh.points, mesh.triangles.iter().copied()), before);
        for ([a, b], of) in mesh.edges.iter().zip(&mesh.edge_of) {
            if *of == Some(0) {
                let on = |v: usize| area(&mesh.points, [[edges[0][0], edges[0][1], v]].into_iter());
                assert_eq!(
                    [on(*a), on(*b)],
                    [0, 0].map(|n| BigRational::from_integer(n.into()))
                );
            }
        }
    }
}

/// A square in a square: a region each, and a hole.
fn squares() -> (Vec<[f64; 2]>, Vec<[usize; 2]>) {
    let square = |r: f64| [[-r, -r], [r, -r], [r, r], [-r, r]];
    let ring = |first: usize| (0..4).map(move |i| [first + i, first + (i + 1) % 4]);
    let points = [9.0, 5.0, 1.0].into_iter().flat_map(square).collect();
    (points, (0..3).flat_map(|i| ring(4 * i)).collect())
}

#[test]
fn regions_have_areas_of_their_own() {
    let (points, edges) = squares();
    let result = triangulate(&points, &edges).expect("squares");
    let placed = result.with_points(&points);
    let inside = placed.interior_of_seeds(&[[0.0, 0.0]], &[[8.0, 0.0], [3.0, 0.0]]);
    let inside = inside.expect("seeds inside");
    let areas = [4.0, 0.5];
    let refinement = Refinement::new(angle(25.0)).region_areas(&areas);
    let mesh = refinement.run(&points, &edges, &inside).expect("squares");
    assert_mesh(&points, &edges, angle(25.0), &mesh, "squares");
    let mut counts = [0; 2];
    for (triangle, region) in mesh.triangles.iter().zip(&mesh.regions) {
        let region = region.expect("a region");
        counts[region] += 1;
        let bounds = Bounds {
            greatest_area: Some(areas[region]),
            ..angle(25.0)
        };
        assert_eq!(broken(bounds, &triangle.map(|v| mesh.points[v])), None);
        // The centroid lies in the region.
        let [x, y] = [0, 1].map(|i| triangle.iter().map(|&v| mesh.points[v][i]).sum::<f64>() / 3.0);
        let far = x.abs().max(y.abs());
        assert!(if region == 0 {
            far > 5.0
        } else {
            far > 1.0 && far < 5.0
        });
    }
    // The areas are 224 and 96.
    assert!(counts[0] >= 56 && counts[1] >= 192, "{counts:?}");
}

#[test]
fn areas_depend_on_the_place() {
    let (points, edges) = squares();
    let result = triangulate(&points, &edges).expect("squares");
    let area_at = |[x, _]: [f64; 2]| if x < 0.0 { 0.25 } else { 8.0 };
    let refinement = Refinement::new(angle(20.0)).area_at(&area_at);
    let mesh = refinement.run(&points, &edges, &Interior::whole(&result));
    let mesh = mesh.expect("squares");
    let (mut left, mut right) = (0, 0);
    for triangle in &mesh.triangles {
        let corners = triangle.map(|v| mesh.points[v]);
        let x = corners.iter().map(|corner| corner[0] / 3.0).sum();
        let most = Some(area_at([x, 0.0]));
        let bounds = Bounds {
            greatest_area: most,
            ..angle(20.0)
        };
        assert_eq!(broken(bounds, &corners), None);
        *(if x < 0.0 { &mut left } else { &mut right }) += 1;
    }
    assert!(left > 4 * right, "{left} {right}");
    assert_eq!(mesh.left, []);
}

#[test]
fn a_kept_boundary_has_no_new_points() {
    let points = [[0.0, 0.0], [10.0, 0.0], [10.0, 1.0], [0.0, 1.0]];
    let edges = [[0, 1], [1, 2], [2, 3], [3, 0]];
    let result = triangulate(&points, &edges).expect("a rectangle");
    let whole = Interior::whole(&result);
    let kept = Refinement::new(angle(30.0))
        .keep_boundary()
        .run(&points, &edges, &whole);
    let kept = kept.expect("a rectangle");
    assert_eq!(kept.edges, edges);
    assert!(kept.left.iter().all(|left| left.reason == Reason::Boundary));
    assert!(!kept.left.is_empty());
    let free = Refinement::new(angle(30.0))
        .run(&points, &edges, &whole)
        .expect("a rectangle");
    assert_eq!(free.left, []);
    assert!(free.edges.len() > 4);
}

#[test]
fn sharp_corners_stay_and_the_rest_does_not() {
    // Spokes at 5 degrees.
    let spoke = |i: u32| (f64::from(i) * 5.0).to_radians();
    let mut points = vec![[0.0, 0.0]];
    points.extend((0..18).map(|i| [100.0 * spoke(i).cos(), 100.0 * spoke(i).sin()]));
    let edges: Vec<[usize; 2]> = (1..19).map(|i| [0, i]).collect();
    let result = triangulate(&points, &edges).expect("spokes");
    let mesh = Refinement::new(angle(25.0)).run(&points, &edges, &Interior::whole(&result));
    let mesh = mesh.expect("spokes");
    assert_mesh(&points, &edges, angle(25.0), &mesh, "spokes");
    assert!(mesh.points.len() < 2_000, "{}", mesh.points.len());
    assert!(
        mesh.left
            .iter()
            .all(|left| left.reason == Reason::InputAngle)
    );
    // All that stay lie near the corner or at two spokes.
    let at_corner = |left: &sweep_cdt_edit::Left| mesh.triangles[left.triangle].contains(&0);
    assert_eq!(mesh.left.iter().filter(|left| at_corner(left)).count(), 17);
}

#[test]
fn limits_and_refusals() {
    let (points, edges) = squares();
    let result = triangulate(&points, &edges).expect("squares");
    let whole = Interior::whole(&result);
    let run = |refinement: Refinement<'_>| refinement.run(&points, &edges, &whole);
    let area = |most: f64| Bounds {
        greatest_area: Some(most),
        ..Bounds::default()
    };
    let mesh = run(Refinement::new(area(0.001)).most_points(100)).expect("a limit");
    assert_eq!(mesh.points.len(), 100);
    assert!(mesh.left.iter().all(|left| left.reason == Reason::Limit));
    assert_mesh(&points, &edges, area(0.001), &mesh, "limit");
    for (bounds, error) in [
        (angle(60.0), RefineError::Bounds(BoundsError::Angle)),
        (angle(f64::NAN), RefineError::Bounds(BoundsError::Angle)),
        (angle(-1.0), RefineError::Bounds(BoundsError::Angle)),
        (angle(35.0), RefineError::Endless),
        (area(0.0), RefineError::Bounds(BoundsError::Size)),
        (area(f64::NAN), RefineError::Bounds(BoundsError::Size)),
    ] {
        assert_eq!(run(Refinement::new(bounds)), Err(error));
    }
    let other = triangulate(&points[..4], &[]).expect("a square");
    let refused = Refinement::new(angle(20.0)).run(&points, &edges, &Interior::whole(&other));
    assert_eq!(refused, Err(RefineError::OtherInput));
    let nothing = triangulate::<f64>(&[], &[]).expect("nothing");
    let mesh = Refinement::new(angle(20.0)).run::<f64>(&[], &[], &Interior::whole(&nothing));
    assert_eq!(mesh.expect("nothing").triangles, [[0; 3]; 0]);
}

/// Doubles and fractions decide alike, where a bound just holds and where it just does not.
#[test]
fn the_filter_of_bounds_is_right() {
    let mut random = Random::new(11);
    for _ in 0..4_000 {
        let mut double = || {
            let low = random.below(1 << 10) as f64 * 2.0_f64.powi(-45);
            random.below(16) as f64 + if random.one_in(2) { 0.0 } else { low }
        };
        let corners: [[f64; 2]; 3] = [0; 3].map(|_| [double(), double()]);
        let exact = corners.map(|corner| corner.map(|x| x.to_fraction()));
        let side = (corners[0][0] - corners[1][0]).hypot(corners[0][1] - corners[1][1]);
        let side = side.max(0.5);
        let area = (1 + random.below(40)) as f64 / 2.0;
        for bounds in [
            angle(45.0),
            angle(30.0),
            Bounds {
                greatest_area: Some(area),
                ..Bounds::default()
            },
            Bounds {
                greatest_side: Some(side),
                ..Bounds::default()
            },
        ] {
            let found = broken(bounds, &corners);
            assert_eq!(found, broken(bounds, &exact), "{corners:?} {bounds:?}");
        }
    }
}

/// A place of one of eight kinds: few places, so that many are equal, on lines and on circles; and far from each other.
fn place(kind: usize, random: &mut Random) -> [f64; 2] {
    let mut below = |n: usize| random.below(n) as f64;
    match kind {
        0 => [below(6), below(6)],
        1 => [below(40), below(3)],
        2 => {
            let i = below(12);
            [2.0 * i, 3.0 * i + (below(6) / 5.0).floor()]
        }
        3 | 4 => {
            let (angle, radius) = (below(360).to_radians(), 1.0 + below(kind - 2));
            [radius * angle.cos(), radius * angle.sin()]
        }
        5 => [below(1 << 20) / 977.0, below(1 << 20) / 977.0],
        6 => [1000.0 * below(2) + below(5) / 3.0, below(5) / 7.0],
        _ => {
            let size = (below(40) - 20.0).exp2();
            [below(9) * size, below(9) * size]
        }
    }
}

#[test]
fn random_inputs_keep_bounds_and_area() {
    let mut random = Random::new(3);
    for case in 0..400 {
        let n = 3 + random.below(25);
        let points: Vec<[f64; 2]> = (0..n).map(|_| place(case % 8, &mut random)).collect();
        let mut edges: Vec<[usize; 2]> = Vec::new();
        for _ in 0..random.below(12) {
            edges.push([random.below(n), random.below(n)]);
            if triangulate(&points, &edges).is_err() {
                edges.pop();
            }
        }
        let result = triangulate(&points, &edges).expect("edges that do not cross");
        let inside = Interior::whole(&result);
        let bounds = Bounds {
            least_angle: (!random.one_in(5)).then(|| random.below(34) as f64),
            greatest_area: random
                .one_in(4)
                .then(|| (1 + random.below(20)) as f64 / 4.0),
            greatest_side: random.one_in(6).then(|| 1.0 + random.below(20) as f64),
        };
        let most = n + random.below(400);
        let mut refinement = Refinement::new(bounds).most_points(most);
        if random.one_in(5) {
            refinement = refinement.keep_boundary();
        }
        let name = format!("case {case}: {points:?} {edges:?} {bounds:?} {most}");
        let mesh = refinement.run(&points, &edges, &inside).expect(&name);
        assert_mesh(&points, &edges, bounds, &mesh, &name);
        assert!(mesh.points.len() <= most.max(n), "{name}");
        let exact = |points: &[[f64; 2]]| -> Vec<[BigRational; 2]> {
            let exactly = |point: &[f64; 2]| point.map(|x| x.to_fraction());
            points.iter().map(exactly).collect()
        };
        let before = area(&exact(&points), result.triangles());
        let after = area(&exact(&mesh.points), mesh.triangles.iter().copied());
        // Rounded points bend the hull.
        let size = points
            .iter()
            .flatten()
            .fold(0.0_f64, |size, x| size.max(x.abs()));
        let bent = f64::nearest(&(before - after)).abs();
        assert!(bent <= 1e-12 * size * size, "{name}: {bent}");
    }
}

/// All points on one line: edges have parts, and there is nothing to refine.
#[test]
fn points_on_one_line_are_returned() {
    let points = [[0.0, 0.0], [4.0, 4.0], [2.0, 2.0]];
    let result = triangulate(&points, &[[0, 1]]).expect("one edge");
    let mesh = Refinement::new(angle(20.0)).run(&points, &[[0, 1]], &Interior::whole(&result));
    let mesh = mesh.expect("a line");
    assert_eq!((mesh.edges, mesh.triangles), (vec![[0, 2], [2, 1]], vec![]));
}

/// A part that may not be split had free vertices over it removed and inserted again, without end.
#[test]
fn parts_that_stay_whole_remove_nothing() {
    let points = [
        [11, 0],
        [28, 2],
        [36, 2],
        [30, 2],
        [28, 1],
        [11, 1],
        [32, 0],
        [24, 2],
        [20, 2],
        [38, 1],
        [14, 2],
    ];
    let points = points.map(|point| point.map(f64::from));
    let edges = [[1, 10], [3, 6], [1, 0], [9, 2]];
    let result = triangulate(&points, &edges).expect("edges that do not cross");
    let bounds = Bounds {
        least_angle: Some(25.0),
        greatest_area: Some(3.75),
        greatest_side: Some(1.0),
    };
    let refinement = Refinement::new(bounds).most_points(281);
    let mesh = refinement.run(&points, &edges, &Interior::whole(&result));
    assert!(mesh.expect("a limit").points.len() <= 281);
}

/// Meshes of any program: numbers of points that do not exist, coordinates that are not finite, bounds that are none.
#[test]
fn violations_refuse_what_they_cannot_compare() {
    let points = [[0.0, 0.0], [1.0, 0.0], [f64::NAN, 1.0]];
    let of = |bounds: Bounds, triangle: [usize; 3]| bounds.violations(&points, &[triangle]);
    let (triangle, point) = (0, 3);
    assert_eq!(
        of(angle(20.0), [0, 1, 3]),
        Err(BoundsError::NoPoint { triangle, point })
    );
    let point = 2;
    assert_eq!(
        of(angle(20.0), [0, 1, 2]),
        Err(BoundsError::NonFiniteCoordinate { point })
    );
    assert_eq!(of(angle(-20.0), [0, 1, 1]), Err(BoundsError::Angle));
    let side = |most: f64| Bounds {
        greatest_side: Some(most),
        ..Bounds::default()
    };
    assert_eq!(of(side(-1.0), [0, 1, 1]), Err(BoundsError::Size));
    // Nothing is too long for an infinite bound, and flat triangles have no angle.
    assert_eq!(of(side(f64::INFINITY), [0, 1, 1]), Ok(vec![]));
    assert_eq!(of(angle(20.0), [0, 1, 1]), Ok(vec![(0, Broken::Angle)]));
    // Clockwise triangles have angles and areas, too.
    let corners = [[0.0, 0.0], [0.0, 1.0], [8.0, 0.0]];
    assert_eq!(broken(angle(8.0), &corners), Some(Broken::Angle));
    assert_eq!(broken(angle(7.0), &corners), None);
}

/// Points of another triangulation, as many: refused, or refined if the triangles are the same, but no panic.
#[test]
fn points_of_others_are_no_panic() {
    let mut random = Random::new(31);
    let mut refused = 0;
    for case in 0..400 {
        let n = 3 + random.below(12);
        let points: Vec<[f64; 2]> = (0..n).map(|_| place(case % 8, &mut random)).collect();
        let edges = [[0, 1], [1, 2]];
        let Ok(result) = triangulate(&points, &edges) else {
            continue;
        };
        let mut others = points.clone();
        for other in &mut others {
            let numbers = [f64::NAN, 0.0, 1.0, -7.0, f64::MAX];
            if random.one_in(3) {
                *other = [random.pick(&numbers), random.pick(&numbers)];
            }
        }
        let refinement = Refinement::new(angle(20.0)).most_points(n + 50);
        refused += usize::from(
            refinement
                .run(&others, &edges, &Interior::whole(&result))
                .is_err(),
        );
    }
    assert!(refused > 100, "{refused}");
}

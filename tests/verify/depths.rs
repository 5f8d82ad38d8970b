//! How deep faults are, against fractions; and what is measured.

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::{Verifier, Violation, Violations, verify};
use sweep_cdt_testing::oracle::arrangement::fractions;
use sweep_cdt_testing::oracle::refined::{faulty_sides, height, is_near};

use super::*;

/// The sides that are not Delaunay, lower vertex first, sorted, with their depths.
fn sides(violations: &Violations) -> Vec<([usize; 2], f64)> {
    let mut sides: Vec<([usize; 2], f64)> = violations
        .list
        .iter()
        .map(|violation| match violation {
            Violation::NotDelaunay { side, depth, .. } => {
                let [a, b] = *side;
                ([a.min(b), a.max(b)], depth.expect("it is measured").get())
            }
            _ => panic!("{violation:?}"),
        })
        .collect();
    sides.sort_by_key(|side| side.0);
    sides
}

/// Points on a lattice within a square, but off by some units in the last place, and the triangles of the lattice.
fn jittered(random: &mut Random, scale: f64) -> Case {
    let mut points = vec![[0, 0], [6, 0], [6, 6], [0, 6]];
    points.extend((0..10).map(|_| [1 + random.below(5), 1 + random.below(5)]));
    let points = points.into_iter().map(|p| p.map(|x| x as f64 * scale));
    let mut case = Case::of(points.collect(), &[]);
    for x in case.points[4..].iter_mut().flatten() {
        match random.below(8) {
            0 => *x = x.next_up(),
            1 => *x = x.next_down(),
            2 => *x *= 1.0 - 1e-13,
            _ => {}
        }
    }
    case
}

#[test]
fn depths_are_those_of_fractions() {
    let mut random = Random::new(5);
    let (mut found, mut small) = (0, 0);
    for round in 0..4000 {
        let scale = [1.0, 0.1, 1e-150, 1e150, 3e-310][round % 5];
        let case = jittered(&mut random, scale);
        let Err(violations) =
            Verifier::new()
                .limit(1000)
                .verify(&case.points, &[], &case.triangles)
        else {
            continue;
        };
        let Some(deepest) = violations.depth() else {
            continue;
        };
        if violations.list.iter().any(|v| v.name() != "not-delaunay") {
            continue;
        }
        let exact = fractions(&case.points);
        let expected = faulty_sides(&exact, &[], &case.triangles);
        let sides = sides(&violations);
        assert_eq!(sides.len(), expected.len(), "{case:?}");
        for ((side, depth), (of, exact)) in sides.iter().zip(&expected) {
            assert_eq!(side, of);
            assert!(is_near(*depth, exact), "{depth:e} {case:?}");
            small += usize::from(*depth < 1e-14);
        }
        let greatest = expected.iter().map(|side| &side.1).max().unwrap();
        assert!(is_near(deepest.get(), greatest));
        let mut decades = std::collections::BTreeMap::new();
        for (_, depth) in &sides {
            // Powers of ten as the parser of doubles knows them.
            let is_in = |e: &i32| *depth >= format!("1e{e}").parse::<f64>().unwrap();
            *decades
                .entry((-330..=0).rev().find(is_in).unwrap())
                .or_insert(0) += 1;
        }
        assert_eq!(violations.depths.decades, decades);
        assert_eq!(violations.depths.measured(), violations.found);
        found += sides.len();
        let again = verify(&exact, &[], &case.triangles).unwrap_err();
        assert_eq!(again.depths, violations.depths, "{case:?}");
    }
    assert!(found > 500 && small > 100, "{found} {small}");
}

/// Turns of the hull that are off by rounding.
#[test]
fn heights_are_those_of_fractions() {
    for x in [0.5, 1.0, 1.7] {
        for y in [5e-324, 1e-300, 1e-17, 1e-3, 0.3] {
            let case = Case::literal(
                &[[0.0, 0.0], [x, y], [2.0, 0.0], [1.0, 2.0]],
                &[[0, 1, 3], [1, 2, 3]],
            );
            let violations = case.verify().unwrap_err();
            let [Violation::ConcaveBoundary { vertices, depth }] = violations.list[..] else {
                panic!("{violations:?}");
            };
            let exact = fractions(&case.points);
            let exact = -height(vertices.map(|v| &exact[v]));
            assert!(is_near(depth.unwrap().get(), &exact), "{x} {y} {depth:?}");
            assert_eq!(violations.depth(), depth);
        }
    }
}

#[test]
fn what_is_no_rounding_has_no_depth() {
    // The hull turns back at vertex 5, or by a right angle at vertex 3; and a hole is beside a shallow turn.
    let back = Case::literal(
        &[
            [0.0, -5.0],
            [12.0, -5.0],
            [12.0, 5.0],
            [0.0, 5.0],
            [0.0, 1e-9],
            [9.0, 0.0],
            [0.0, -1e-9],
        ],
        &[[6, 0, 5], [0, 1, 5], [1, 2, 5], [2, 3, 5], [3, 4, 5]],
    );
    let square = Case::literal(
        &[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 2.0], [0.0, 4.0]],
        &[[0, 1, 3], [1, 2, 3], [0, 3, 4]],
    );
    for case in [back, square] {
        let violations = case.verify().unwrap_err();
        assert!(
            violations
                .list
                .iter()
                .any(|v| v.name() == "concave-boundary")
        );
        assert_eq!(violations.depth(), None, "{violations:?}");
    }
    let mut holed = Case::of(
        vec![
            [0.0, 0.0],
            [9.0, 0.0],
            [9.0, 9.0],
            [0.0, 9.0],
            [4.0, 4.0],
            [5.0, 4.0],
            [4.0, 5.0],
        ],
        &[[4, 5], [5, 6], [6, 4]],
    );
    holed.edges.clear();
    let hole = holed
        .triangles
        .iter()
        .position(|t| t.iter().all(|&v| v > 3));
    holed.triangles.remove(hole.unwrap());
    assert_eq!(holed.verify().unwrap_err().depth(), None);
}

/// A boundary of shallow turns that covers itself: twice round a hub is no hull.
#[test]
fn a_boundary_that_covers_itself_is_not_measured() {
    let n = 40;
    let angle = |i: usize| std::f64::consts::TAU * 2.0 * i as f64 / n as f64;
    let radius = |i: usize| [1.0, 0.94][i % 2];
    let mut points = vec![[0.0, 0.0]];
    // Each vertex of the second round is a little off that of the first.
    points.extend((0..n).map(|i| {
        let r = radius(i) * (1.0 + i as f64 / 1e4);
        [r * angle(i).cos(), r * angle(i).sin()]
    }));
    let triangles: Vec<[usize; 3]> = (0..n).map(|i| [0, 1 + i, 1 + (i + 1) % n]).collect();
    let violations = verify(&points, &[], &triangles).unwrap_err();
    let concave = |v: &&Violation| v.name() == "concave-boundary";
    assert!(violations.list.iter().filter(concave).count() > 10);
    assert!(
        violations
            .list
            .iter()
            .filter(concave)
            .all(|v| v.depth().is_none())
    );
    assert_eq!(violations.depth(), None);
}

#[test]
fn every_scalar_tells_sizes() {
    let square = [[0, 0], [1000, 0], [1000, 999], [0, 1000]];
    let triangles = [[0, 1, 3], [1, 2, 3]];
    fn greatest<S: Scalar>(points: &[[S; 2]], triangles: &[[usize; 3]]) -> f64 {
        let violations = verify(points, &[], triangles).unwrap_err();
        violations.depth().expect("it is measured").get()
    }
    let doubles = greatest(&square.map(|p| p.map(f64::from)), &triangles);
    assert!((doubles / 1.999e-3 - 1.0).abs() < 0.01, "{doubles}");
    let others = [
        greatest(&square.map(|p| p.map(|x| x as f32)), &triangles),
        greatest(&square, &triangles),
        greatest(&square.map(|p| p.map(i64::from)), &triangles),
        greatest(&square.map(|p| p.map(BigInt::from)), &triangles),
        greatest(
            &square.map(|p| p.map(|x| BigRational::new(x.into(), 7.into()))),
            &triangles,
        ),
        #[cfg(feature = "rug")]
        greatest(
            &square.map(|p| p.map(|x| rug::Rational::from((-x, 7)))),
            &triangles.map(|t| t),
        ),
    ];
    for other in others {
        assert!((other / doubles - 1.0).abs() < 1e-14, "{other} {doubles}");
    }
}

#[test]
fn of_very_many_faults_some_are_measured() {
    // Rows of squares, each with the wrong diagonal.
    let n = 60;
    let points: Vec<[f64; 2]> = (0..n * n)
        .map(|v| [(v % n) as f64 + 0.25 * (v / n) as f64, (v / n) as f64])
        .collect();
    let corners = (0..n * n).filter(|v| v % n + 1 < n && v / n + 1 < n);
    let triangles: Vec<[usize; 3]> = corners
        .flat_map(|v| [[v, v + 1, v + n + 1], [v, v + n + 1, v + n]])
        .collect();
    let some = verify(&points, &[], &triangles).unwrap_err();
    assert_eq!(some.found, (n - 1) * (n - 1));
    assert_eq!((some.depths.measured(), some.depth()), (1000, None));
    let all = Verifier::new().all_depths(true);
    let all = all.verify(&points, &[], &triangles).unwrap_err();
    assert_eq!(all.depths.measured(), all.found);
    assert_eq!(all.depth(), all.depths.greatest);
}

//! What is reported of right and wrong triangulations.

use sweep_cdt::verify::{Verifier, Violation, verify};

use super::domains;
use super::*;
use sweep_cdt_testing::Random;

#[test]
fn offenders() {
    let list = |case: Case| {
        let mut list = case.verify().unwrap_err().list;
        // How deep they are is tested elsewhere.
        for violation in &mut list {
            if let Violation::NotDelaunay { depth, .. } | Violation::ConcaveBoundary { depth, .. } =
                violation
            {
                assert!(depth.take().is_some());
            }
        }
        list
    };
    let [side, triangles, opposite] = [[3, 1], [1, 0], [2, 0]];
    assert_eq!(
        list(square(1e-150)),
        [Violation::NotDelaunay {
            side,
            triangles,
            opposite,
            depth: None
        }]
    );
    let case = Case::literal(
        &[[0.0, 0.0], [1.0, 1e-300], [2.0, 0.0], [1.0, 2.0]],
        &[[0, 1, 3], [1, 2, 3]],
    );
    assert_eq!(
        list(case),
        [Violation::ConcaveBoundary {
            vertices: [0, 1, 2],
            depth: None
        }]
    );
    let mut case = Case::of(
        vec![[0.0, 0.0], [4.0, 0.0], [2.0, 1.0], [2.0, -1.0], [2.0, 0.0]],
        &[[0, 1]],
    );
    assert_eq!(case.verify().unwrap().constrained_sides, 2);
    case.points[4][1] = 1e-300;
    assert_eq!(list(case), [Violation::MissingEdge { edge: 0, after: 0 }]);
}

#[test]
fn a_hole_is_named() {
    let mut case = random();
    let [a, b, c] = case.triangles.swap_remove(case.inner_triangle());
    let list = case.verify().unwrap_err().list;
    let [Violation::ExtraBoundary { side, sides: 3 }] = list[..] else {
        panic!("{list:?}");
    };
    // As the triangles around it have it.
    assert!([[b, a], [c, b], [a, c]].contains(&side), "{side:?}");
}

#[test]
fn texts() {
    let violations = |limit| {
        let (case, verifier) = (square(1.0), Verifier::new().limit(limit));
        verifier
            .verify(&case.points, &[], &case.triangles)
            .unwrap_err()
    };
    assert_eq!(
        violations(1).to_string(),
        "not a constrained Delaunay triangulation: side 3-1 of triangles 1 and 0 is not Delaunay: \
         the circle of one holds vertex 2 or 0 of the other"
    );
    assert_eq!(
        violations(0).to_string(),
        "not a constrained Delaunay triangulation: 1 violation"
    );
    let twice = [[0, 1, 2], [0, 1, 2]];
    let two_more = Verifier::new()
        .limit(1)
        .verify(&square(1.0).points, &[], &twice);
    assert_eq!(
        two_more.unwrap_err().to_string(),
        "not a constrained Delaunay triangulation: triangles 0 and 1 both lie to the left of side \
         0-1, and 3 more violations"
    );
    let points = [[0.0, 0.0], [f64::NAN, 0.0], [0.0, f64::NAN]];
    assert_eq!(
        verify(&points, &[], &[]).unwrap_err().to_string(),
        "not a constrained Delaunay triangulation: vertex 1 has a coordinate that is not finite, \
         and 1 more violation"
    );
    let options = format!("{:?}", Verifier::new().limit(7).accept_clockwise(true));
    assert_eq!(
        options,
        "Verifier { clockwise: true, boundary: None, level: Delaunay, added_from: None, regions: None, limit: 7, measured: 1000, .. }"
    );
}

#[test]
fn correct_results() {
    let mut rng = Random::new(2);
    for n in (3..60).chain([1000, 40_000]) {
        let uniform = Case::of(rng.points(n), &[]).verify().unwrap();
        assert_eq!((uniform.points, uniform.is_canonical()), (n, true));
        let side = n.isqrt() + 1;
        let lattice = (0..n)
            .map(|i| [(i % side) as f64, (i / side) as f64])
            .collect();
        assert!(Case::of(lattice, &[]).verify().unwrap().is_canonical());
    }
    let case = constrained();
    let report = case.verify().unwrap();
    assert_eq!(report.triangles, case.triangles.len());
    assert!(report.constrained_sides >= 5, "{report:?}");
    assert_eq!(report.edges, case.edges.len());
}

#[test]
fn few_and_collinear_points() {
    for points in [
        vec![],
        vec![[1.0, 1.0]],
        vec![[1.0, 1.0]; 5],
        vec![[0.0, 0.0], [1.0, 1e-300]],
    ] {
        assert_eq!(verify(&points, &[], &[]).unwrap().triangles, 0);
    }
    let line: Vec<[f64; 2]> = (0..9).map(|i| [f64::from(i), 2.0 * f64::from(i)]).collect();
    assert!(verify(&line, &[[0, 8]], &[]).is_ok());
}

#[test]
fn duplicates_through_any_of_them() {
    let points = [
        [0.0, 0.0],
        [1.0, 0.0],
        [0.0, 1.0],
        [1.0, -0.0],
        [-0.0, 1.0],
        [1.0, 2.0],
    ];
    let report = verify(&points, &[[4, 3], [1, 3]], &[[0, 3, 2], [1, 5, 4]]).unwrap();
    assert_eq!(
        (
            report.points,
            report.distinct_points,
            report.constrained_sides
        ),
        (6, 4, 1)
    );
}

#[test]
fn edges_given_twice() {
    let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    let triangles = [[0, 1, 3], [1, 2, 3]];
    for edge in [[0, 1], [1, 3]] {
        let [a, b] = edge;
        let report = verify(&points, &[edge, [b, a], edge], &triangles).unwrap();
        assert_eq!(report.constrained_sides, 1, "{edge:?}");
    }
}

#[test]
fn both_triangles_of_a_side_given_twice() {
    let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [1.0, -1.0]];
    let triangles = [[0, 1, 2], [0, 1, 2], [1, 0, 3], [1, 0, 3]];
    let list = verify(&points, &[], &triangles).unwrap_err().list;
    let expected = [
        ([0, 1], [0, 1]),
        ([1, 2], [0, 1]),
        ([2, 0], [0, 1]),
        ([1, 0], [2, 3]),
        ([3, 1], [2, 3]),
        ([0, 3], [2, 3]),
    ];
    let repeated = |(side, triangles)| Violation::RepeatedSide { side, triangles };
    assert_eq!(list, expected.map(repeated));
}

#[test]
fn clockwise_files() {
    let mut case = random();
    for triangle in &mut case.triangles {
        triangle.swap(1, 2);
    }
    let verifier = Verifier::new().accept_clockwise(true);
    assert!(
        verifier
            .verify(&case.points, &[], &case.triangles)
            .unwrap()
            .clockwise
    );
    assert!(
        !verifier
            .verify(&case.points, &[], &random().triangles)
            .unwrap()
            .clockwise
    );
    case.triangles[5].swap(1, 2);
    let mixed = verifier
        .verify(&case.points, &[], &case.triangles)
        .unwrap_err();
    assert_eq!(mixed.list[0], Violation::ReversedTriangle { triangle: 5 });
}

#[test]
fn canonical_choice() {
    let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let canonical = verify(&points, &[], &[[0, 1, 3], [1, 2, 3]]).unwrap();
    assert_eq!(
        (canonical.cocircular_sides, canonical.uncanonical_sides),
        (1, 0)
    );
    let other = verify(&points, &[], &[[0, 1, 2], [0, 2, 3]]).unwrap();
    assert_eq!((other.cocircular_sides, other.uncanonical_sides), (1, 1));
}

#[test]
fn domains_with_holes() {
    // A square ring around a hole, and a point in the hole.
    let mut points = domains::POINTS.to_vec();
    points.push([4.0, 4.0]);
    let mut ring = domains::RING.to_vec();
    let chains = [vec![0, 1, 2, 3], vec![4, 7, 6, 5]];
    let verifier = Verifier::new().boundary(&chains);
    let report = verifier.verify(&points, &[[4, 5]], &ring).unwrap();
    assert_eq!((report.boundary_sides, report.constrained_sides), (8, 1));
    assert_eq!(
        verify(&points, &[], &ring).unwrap_err().list[0].name(),
        "extra-boundary"
    );

    points.push([1.0, 4.0]);
    let list = verifier.verify(&points, &[], &ring).unwrap_err().list;
    assert_eq!(list, [Violation::UnusedPoint { vertex: 9 }]);
    points.pop();
    ring.pop();
    let list = verifier.verify(&points, &[], &ring).unwrap_err().list;
    assert_eq!(
        list,
        [
            Violation::UndeclaredBoundary {
                side: [4, 0],
                triangle: 0
            },
            Violation::UndeclaredBoundary {
                side: [3, 4],
                triangle: 6
            },
            Violation::MissingBoundary { side: [3, 0] },
        ]
    );
    let chains = [vec![0, 1, 2, 77], vec![], vec![5]];
    assert!(
        Verifier::new()
            .boundary(&chains)
            .verify(&points, &[], &ring)
            .is_err()
    );
}

#[test]
fn many_violations() {
    let points = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let copies = vec![[0, 1, 2]; 1_000_000];
    let violations = Verifier::new()
        .limit(7)
        .verify_parallel(&points, &[], &copies)
        .unwrap_err();
    assert_eq!((violations.list.len(), violations.found), (7, 3 * 999_999));
    assert!(
        Verifier::new()
            .limit(0)
            .verify(&points, &[], &copies)
            .unwrap_err()
            .list
            .is_empty()
    );
    assert!(
        violations.to_string().contains("and 2999996 more"),
        "{violations}"
    );
}

#[test]
fn progress_ends_at_the_total() {
    let seen = std::sync::Mutex::new((0, 0));
    let progress = |done, total| *seen.lock().unwrap() = (done, total);
    let case = random();
    let verifier = Verifier::new().progress(&progress);
    verifier.verify(&case.points, &[], &case.triangles).unwrap();
    assert_eq!(
        seen.into_inner().unwrap(),
        (2 * case.triangles.len(), 2 * case.triangles.len())
    );
}

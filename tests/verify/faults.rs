//! A table of faults: each class is reported as that class.

use num_rational::BigRational;
use sweep_cdt::verify::{Verifier, verify};

use super::*;

/// A fault: its name, a triangulation that has it, and the first violation to be reported.
type Fault = (&'static str, fn() -> Case, &'static str);

const FAULTS: &[Fault] = &[
    (
        "flipped side",
        || changed(random(), Case::flip),
        "not-delaunay",
    ),
    (
        "flipped side among constraints",
        || changed(constrained(), Case::flip),
        "not-delaunay",
    ),
    ("one ulp inside the circle", || square(1.0), "not-delaunay"),
    (
        "one ulp inside the circle at 1e-150",
        || square(1e-150),
        "not-delaunay",
    ),
    (
        "one ulp inside the circle at 1e150",
        || square(1e150),
        "not-delaunay",
    ),
    (
        "one ulp inside the circle at 1e-300",
        || square(1e-300),
        "not-delaunay",
    ),
    (
        "dropped inner triangle",
        || {
            changed(random(), |case| {
                case.triangles.swap_remove(case.inner_triangle());
            })
        },
        "extra-boundary",
    ),
    (
        "dropped hull triangle",
        || {
            changed(random(), |case| {
                let at_hull = (0..case.triangles.len()).find(|&t| case.neighbor(t).is_none());
                case.triangles.remove(at_hull.unwrap());
            })
        },
        "concave-boundary",
    ),
    (
        "repeated triangle",
        || changed(random(), |case| case.triangles.push(case.triangles[7])),
        "repeated-side",
    ),
    (
        "repeated triangle, rotated",
        || {
            changed(random(), |case| {
                let [a, b, c] = case.triangles[7];
                case.triangles.push([c, a, b]);
            })
        },
        "repeated-side",
    ),
    (
        "reversed triangle",
        || changed(random(), |case| case.triangles[7].swap(0, 1)),
        "reversed-triangle",
    ),
    (
        "all reversed",
        || {
            changed(random(), |case| {
                case.triangles.iter_mut().for_each(|t| t.swap(0, 1));
            })
        },
        "reversed-triangle",
    ),
    (
        "corner repeated",
        || changed(random(), |case| case.triangles[7][0] = case.triangles[7][1]),
        "flat-triangle",
    ),
    (
        "flat triangle on the hull",
        || {
            Case::literal(
                &[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 2.0]],
                &[[0, 2, 3], [0, 1, 2]],
            )
        },
        "flat-triangle",
    ),
    (
        "two vertices exchanged",
        || {
            changed(random(), |case| {
                for corner in case.triangles.iter_mut().flatten() {
                    *corner = match *corner {
                        3 => 4,
                        4 => 3,
                        v => v,
                    };
                }
            })
        },
        "reversed-triangle",
    ),
    (
        "corners of two triangles exchanged",
        || {
            let row = [0.0, 1.0, 2.0];
            let points: Vec<[f64; 2]> = (0..6).map(|i| [row[i % 3], row[i / 3]]).collect();
            changed(Case::of(points, &[]), |case| {
                case.triangles = vec![[0, 2, 3], [1, 4, 3], [1, 1, 4], [2, 5, 4]];
            })
        },
        "flat-triangle",
    ),
    (
        "constraint ignored",
        || {
            changed(constrained(), |case| {
                *case = Case {
                    edges: case.edges.clone(),
                    ..Case::of(case.points.clone(), &[])
                }
            })
        },
        "missing-edge",
    ),
    (
        "vertex beside a constraint",
        || {
            // Vertex 4 is one unit in the last place beside the edge 0-2.
            changed(
                Case::of(
                    vec![
                        [0.0, 0.0],
                        [2.0, 0.0],
                        [2.0, 2.0],
                        [0.0, 2.0],
                        [1.0, 1.0f64.next_up()],
                    ],
                    &[],
                ),
                |case| case.edges.push([0, 2]),
            )
        },
        "missing-edge",
    ),
    (
        "two hulls",
        || {
            changed(random(), |case| {
                let n = case.points.len();
                case.points
                    .extend(random().points.iter().map(|p| [p[0] + 9.0, p[1]]));
                case.triangles
                    .extend(random().triangles.iter().map(|t| t.map(|v| v + n)));
            })
        },
        "extra-boundary",
    ),
    (
        "two hulls, one over the other",
        || {
            changed(random(), |case| {
                let n = case.points.len();
                case.points
                    .extend(random().points.iter().map(|p| [p[0] + 0.1, p[1] + 0.1]));
                case.triangles
                    .extend(random().triangles.iter().map(|t| t.map(|v| v + n)));
            })
        },
        "extra-boundary",
    ),
    (
        "two hulls with a vertex in common",
        || {
            Case::literal(
                &[[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [2.0, 1.0], [2.0, 2.0]],
                &[[0, 1, 2], [1, 3, 4]],
            )
        },
        "pinched-boundary",
    ),
    (
        "vertex inside a side",
        || {
            Case::literal(
                &[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 1.0], [1.0, -1.0]],
                &[[0, 2, 3], [0, 4, 1], [1, 4, 2]],
            )
        },
        "pinched-boundary",
    ),
    (
        "unused point inside",
        || changed(random(), |case| case.points.push([0.5, 0.5])),
        "unused-point",
    ),
    (
        "unused point outside",
        || changed(random(), |case| case.points.push([9.0, 9.0])),
        "unused-point",
    ),
    (
        "unused point on the hull",
        || {
            Case::literal(
                &[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 2.0]],
                &[[0, 2, 3]],
            )
        },
        "unused-point",
    ),
    (
        "boundary that winds twice",
        || {
            let angle = |i: usize| std::f64::consts::TAU * i as f64 / 5.0;
            let mut points: Vec<[f64; 2]> =
                (0..5).map(|i| [angle(i).cos(), angle(i).sin()]).collect();
            points.push([0.0, 0.0]);
            let triangles: Vec<[usize; 3]> = (0..5).map(|i| [5, i, (i + 2) % 5]).collect();
            Case::literal(&points, &triangles)
        },
        "winding-boundary",
    ),
    (
        "hull concave by 1e-300",
        || {
            Case::literal(
                &[[0.0, 0.0], [1.0, 1e-300], [2.0, 0.0], [1.0, 2.0]],
                &[[0, 1, 3], [1, 2, 3]],
            )
        },
        "concave-boundary",
    ),
    (
        "side used backwards",
        || {
            // The boundary runs 0-1-2 and back to 1.
            Case::literal(
                &[[0.0, 0.0], [2.0, 0.0], [1.0, 2.0], [1.0, 1.0]],
                &[[0, 1, 3], [1, 2, 3]],
            )
        },
        "concave-boundary",
    ),
    (
        "no triangles",
        || Case::literal(&[[0.0, 0.0], [1.0, 0.0], [2.0, 1e-300]], &[]),
        "no-triangles",
    ),
    (
        "corner out of range",
        || changed(random(), |case| case.triangles[7][2] = 60),
        "triangle-out-of-range",
    ),
    (
        "corner far out of range",
        || changed(random(), |case| case.triangles[7][2] = usize::MAX),
        "triangle-out-of-range",
    ),
    (
        "edge out of range",
        || changed(random(), |case| case.edges.push([0, 60])),
        "edge-out-of-range",
    ),
    (
        "not a number",
        || changed(random(), |case| case.points[7][1] = f64::NAN),
        "non-finite-coordinate",
    ),
    (
        "infinite",
        || changed(random(), |case| case.points[7][0] = f64::INFINITY),
        "non-finite-coordinate",
    ),
];

fn changed(mut case: Case, change: impl FnOnce(&mut Case)) -> Case {
    case.verify().unwrap();
    change(&mut case);
    case
}

#[test]
fn every_fault_is_named() {
    for &(what, case, expected) in FAULTS {
        let case = case();
        let violations = case.verify().expect_err(what);
        assert_eq!(
            violations.list[0].name(),
            expected,
            "{what}: {:?}",
            violations.list
        );
        assert_eq!(violations.list.len(), violations.found.min(100));
        let parallel = Verifier::new().verify_parallel(&case.points, &case.edges, &case.triangles);
        assert_eq!(parallel.unwrap_err(), violations, "{what}");
        if case.points.iter().flatten().all(|x| x.is_finite()) {
            let exact: Vec<[BigRational; 2]> = case
                .points
                .iter()
                .map(|p| p.map(|x| BigRational::from_float(x).unwrap()))
                .collect();
            let exact = verify(&exact, &case.edges, &case.triangles).unwrap_err();
            assert_eq!(exact.list, violations.list, "{what}");
        }
    }
}

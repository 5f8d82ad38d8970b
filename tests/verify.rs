//! The verifier must pass what is right and name what is wrong.

use std::collections::HashSet;

use num_rational::BigRational;
use sweep_cdt::{Report, Verifier, Violation, Violations, triangulate, verify};

/// Pseudo-random numbers (a linear congruence, upper bits).
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % n
    }

    fn unit(&mut self) -> f64 {
        self.below(1 << 30) as f64 / (1u64 << 30) as f64
    }

    fn points(&mut self, n: usize) -> Vec<[f64; 2]> {
        (0..n).map(|_| [self.unit(), self.unit()]).collect()
    }
}

/// A triangulation to break.
#[derive(Clone, Default)]
struct Case {
    points: Vec<[f64; 2]>,
    edges: Vec<[usize; 2]>,
    triangles: Vec<[usize; 3]>,
}

impl Case {
    fn of(points: Vec<[f64; 2]>, edges: &[[usize; 2]]) -> Case {
        let triangles = triangulate(&points, edges).unwrap().triangles().collect();
        Case {
            points,
            edges: edges.to_vec(),
            triangles,
        }
    }

    fn literal(points: &[[f64; 2]], triangles: &[[usize; 3]]) -> Case {
        Case {
            points: points.to_vec(),
            edges: vec![],
            triangles: triangles.to_vec(),
        }
    }

    fn verify(&self) -> Result<Report, Violations> {
        verify(&self.points, &self.edges, &self.triangles)
    }

    /// A triangle and its neighbour across its first side, if that is an inner side.
    fn neighbor(&self, t: usize) -> Option<usize> {
        let [a, b, _] = self.triangles[t];
        self.triangles
            .iter()
            .position(|u| (0..3).any(|i| [u[(i + 1) % 3], u[i]] == [a, b]))
    }

    /// A triangle none of whose corners is on the hull.
    fn inner_triangle(&self) -> usize {
        let hull: HashSet<usize> = triangulate(&self.points, &[]).unwrap().hull().collect();
        self.triangles
            .iter()
            .position(|t| t.iter().all(|v| !hull.contains(v)))
            .unwrap()
    }

    /// Replaces the diagonal of two triangles by the other one, where that leaves both of them
    /// counter-clockwise.
    fn flip(&mut self) {
        for t in 0..self.triangles.len() {
            let Some(u) = self.neighbor(t) else { continue };
            let [a, b, c] = self.triangles[t];
            let d = *self.triangles[u]
                .iter()
                .find(|v| ![a, b].contains(v))
                .unwrap();
            let mut flipped = self.clone();
            flipped.triangles[t] = [c, a, d];
            flipped.triangles[u] = [d, b, c];
            if flipped
                .verify()
                .is_err_and(|e| e.list[0].name() == "not-delaunay")
            {
                *self = flipped;
                return;
            }
        }
        panic!("nothing to flip");
    }
}

fn random() -> Case {
    Case::of(Random(1).points(60), &[])
}

fn constrained() -> Case {
    let mut case = random();
    // The longest edges are no Delaunay edges.
    case.edges = (0..60).step_by(2).map(|a| [a, (a + 1) % 60]).collect();
    while let Err(sweep_cdt::Error::CrossingEdges { edges: [_, b] }) =
        triangulate(&case.points, &case.edges)
    {
        case.edges.remove(b);
    }
    Case::of(case.points, &case.edges)
}

/// A square with its upper right corner moved inwards by one unit in the last place, so that its
/// diagonal 1-3 is wrong.
fn square(size: f64) -> Case {
    let mut case = Case::literal(&[[0.0, 0.0], [size, 0.0], [size, size], [0.0, size]], &[]);
    case.points[2][0] = size.next_down();
    case.triangles = vec![[0, 1, 3], [1, 2, 3]];
    case
}

/// A fault: how it is called, a triangulation that has it, and the first violation to be reported.
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

#[test]
fn offenders() {
    let list = |case: Case| case.verify().unwrap_err().list;
    let [side, triangles, opposite] = [[3, 1], [1, 0], [2, 0]];
    assert_eq!(
        list(square(1e-150)),
        [Violation::NotDelaunay {
            side,
            triangles,
            opposite
        }]
    );
    let case = Case::literal(
        &[[0.0, 0.0], [1.0, 1e-300], [2.0, 0.0], [1.0, 2.0]],
        &[[0, 1, 3], [1, 2, 3]],
    );
    assert_eq!(
        list(case),
        [Violation::ConcaveBoundary {
            vertices: [0, 1, 2]
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
fn correct_results() {
    let mut rng = Random(2);
    for n in (3..60).chain([1000, 40_000]) {
        let uniform = Case::of(rng.points(n), &[]).verify().unwrap();
        assert_eq!((uniform.points, uniform.is_canonical()), (n, true));
        let side = n.isqrt() + 1;
        let lattice = (0..n)
            .map(|i| [(i % side) as f64, (i / side) as f64])
            .collect();
        assert!(Case::of(lattice, &[]).verify().unwrap().is_canonical());
    }
    let report = constrained().verify().unwrap();
    assert!(report.constrained_sides >= 5, "{report:?}");
    assert_eq!(report.edges, constrained().edges.len());
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
        [1.0, 0.0],
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
    let mut points: Vec<[f64; 2]> = vec![[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]];
    points.extend([[3.0, 3.0], [6.0, 3.0], [6.0, 6.0], [3.0, 6.0], [4.0, 4.0]]);
    let mut ring = vec![
        [0, 5, 4],
        [0, 1, 5],
        [1, 6, 5],
        [1, 2, 6],
        [2, 7, 6],
        [2, 3, 7],
        [3, 4, 7],
        [3, 0, 4],
    ];
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

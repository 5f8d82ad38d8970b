//! Answers of other crates to chosen inputs: which are right, and which are known to be wrong.

use num_rational::BigRational;
use sweep_cdt::triangulate;
use sweep_cdt::verify::{Verifier, Violation, verify};

use sweep_cdt_testing::peers::{cdt, delaunator, spade};

/// Points on a Weyl sequence: evenly spread, not on a lattice.
fn spread(n: usize) -> Vec<[f64; 2]> {
    let steps = [0.618_033_988_749_894_9, 0.754_877_666_246_692_7];
    (1..=n)
        .map(|i| steps.map(|step| (i as f64 * step).fract()))
        .collect()
}

fn lattice(n: usize) -> Vec<[f64; 2]> {
    (0..n * n)
        .map(|i| [(i % n) as f64, (i / n) as f64])
        .collect()
}

#[test]
fn right_results() {
    for points in [spread(10), spread(3000), lattice(20)] {
        verify(&points, &[], &spade(&points, &[]).unwrap()).unwrap();
        let clockwise = Verifier::new().accept_clockwise(true);
        clockwise
            .verify(&points, &[], &delaunator(&points, &[]).unwrap())
            .unwrap();
    }
    for points in [spread(10), spread(100), lattice(20)] {
        verify(&points, &[], &cdt(&points, &[]).unwrap()).unwrap();
    }
    // Parallel edges, longer than the points are far apart.
    let points = spread(500);
    let edges: Vec<[usize; 2]> = (0..267).map(|i| [i, i + 233]).collect();
    verify(&points, &edges, &spade(&points, &edges).unwrap()).unwrap();
}

/// The three agree up to cocircular points, where each chooses its own way.
#[test]
fn choices() {
    let points = lattice(20);
    let ours: Vec<[usize; 3]> = triangulate(&points, &[]).unwrap().triangles().collect();
    let ours = verify(&points, &[], &ours).unwrap();
    let spades = verify(&points, &[], &spade(&points, &[]).unwrap()).unwrap();
    assert_eq!(ours.cocircular_sides, 19 * 19);
    assert_eq!(spades.cocircular_sides, 19 * 19);
    assert!(ours.is_canonical() && !spades.is_canonical());
}

/// `delaunator` 1 decides the in-circle test in plain doubles, `cdt` 0.1 misses flips.
#[test]
fn wrong_results() {
    let circle: Vec<[f64; 2]> = spread(300)
        .iter()
        .map(|p| (p[0] * std::f64::consts::TAU).sin_cos())
        .map(|(sin, cos)| [3.0 + cos, 5.0 + sin])
        .collect();
    let spread = spread(3000);
    let results = [
        (&circle, delaunator(&circle, &[]).unwrap()),
        (&spread, cdt(&spread, &[]).unwrap()),
    ];
    for (points, result) in results {
        let verifier = Verifier::new().accept_clockwise(true).limit(usize::MAX);
        let violations = verifier.verify(points, &[], &result).unwrap_err();
        let is_caught = |v: &Violation| v.name() == "not-delaunay";
        assert!(violations.list.iter().all(is_caught), "{violations}");
        let rationals: Vec<[BigRational; 2]> = points
            .iter()
            .map(|p| p.map(|x| BigRational::from_float(x).unwrap()))
            .collect();
        let exact = verifier.verify(&rationals, &[], &result).unwrap_err();
        assert_eq!(exact.list, violations.list);
        let ours: Vec<[usize; 3]> = triangulate(points, &[]).unwrap().triangles().collect();
        verify(points, &[], &ours).unwrap();
    }
}

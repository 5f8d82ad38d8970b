//! Equal points are found without comparing all of them.

use std::cell::Cell;
use std::cmp::Ordering;

use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::verify;

use sweep_cdt_testing::Random;

thread_local! {
    static COMPARISONS: Cell<usize> = const { Cell::new(0) };
}

/// A double that counts its comparisons.
#[derive(Clone, Copy)]
struct Counting(f64);

impl Counting {
    fn inner(p: &[Counting; 2]) -> [f64; 2] {
        p.map(|x| x.0)
    }
}

impl Scalar for Counting {
    fn approx(&self) -> f64 {
        self.0
    }

    fn compare(&self, other: &Self) -> Ordering {
        COMPARISONS.set(COMPARISONS.get() + 1);
        self.0.compare(&other.0)
    }

    fn orient2d(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2]) -> Ordering {
        let [a, b, c] = [a, b, c].map(Counting::inner);
        f64::orient2d(&a, &b, &c)
    }

    fn in_circle(a: &[Self; 2], b: &[Self; 2], c: &[Self; 2], d: &[Self; 2]) -> Ordering {
        let [a, b, c, d] = [a, b, c, d].map(Counting::inner);
        f64::in_circle(&a, &b, &c, &d)
    }
}

/// How many distinct points there are, and how many comparisons of coordinates that took.
fn distinct(points: &[[f64; 2]]) -> (usize, usize) {
    let points: Vec<[Counting; 2]> = points.iter().map(|p| p.map(Counting)).collect();
    COMPARISONS.set(0);
    // Without triangles nothing else is compared.
    let report = match verify(&points, &[], &[]) {
        Ok(report) => report,
        Err(violations) => *violations.report,
    };
    (report.distinct_points, COMPARISONS.get())
}

#[test]
fn distinct_points_are_not_compared() {
    let n = 10_000;
    let raster = |x: f64, y: f64| -> Vec<[f64; 2]> {
        (0..n)
            .map(|i| [x * f64::from(i % 100), y * f64::from(i / 100)])
            .collect()
    };
    let on_line = |x: f64, y: f64| -> Vec<[f64; 2]> {
        (0..n)
            .map(|i| [x * f64::from(i), y * f64::from(i)])
            .collect()
    };
    for points in [
        Random::new(1).points(10_000),
        raster(1.0, 1.0),
        raster(-0.5, 1e-300),
        raster(0.1, 1e300),
        on_line(1.0, 0.0),
        on_line(0.0, -1.0),
        on_line(1.0, 1.0),
        on_line(0.1, -0.1),
    ] {
        let (found, comparisons) = distinct(&points);
        assert_eq!(found, points.len());
        // A sample is looked at for coordinates that share a double.
        assert!(comparisons < 1000, "{comparisons}: {:?}", &points[..3]);
    }
}

#[test]
fn equal_points_are_compared_with_each_other() {
    let mut points = Random::new(1).points(5000);
    points.extend_from_within(..);
    let (found, comparisons) = distinct(&points);
    assert_eq!(found, 5000);
    assert!(comparisons < 6 * 5000, "{comparisons}");
}

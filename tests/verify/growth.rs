//! Inputs that once took the verifier a time that grows with the square of their size: here seconds or minutes
//! each. The tests see that they are judged rightly; the bench `growth` of `benches/peers` takes the time. And equal points,
//! which are found without comparing all of them.

use std::cell::Cell;
use std::cmp::Ordering;

use sweep_cdt::scalar::Scalar;
use sweep_cdt::triangulate;
use sweep_cdt::verify::{Violation, verify};
use sweep_cdt_testing::Random;

type Points = Vec<[f64; 2]>;
type Edges = Vec<[usize; 2]>;

/// Verifies the triangulation of the points and edges.
fn assert_right(points: &Points, edges: &Edges) {
    let triangles: Vec<[usize; 3]> = triangulate(points, edges).unwrap().triangles().collect();
    let report = verify(points, edges, &triangles).unwrap();
    assert!(report.is_canonical());
}

#[test]
fn a_star() {
    const COUNT: usize = 150_000;
    let width = COUNT as f64;
    let mut points = vec![[width / 2.0, -width]];
    points.extend((1..COUNT).map(|i| [i as f64, (i * 7 % 11) as f64]));
    assert_right(&points, &(1..COUNT).map(|i| [i, 0]).collect());
}

/// Rays of a hub, each with two vertices, and edges through the hub from end to end. The triangles between
/// the rays are not Delaunay, but have all sides.
#[test]
fn edges_through_one_vertex() {
    const REACH: i32 = 160;
    let divisor = |mut a: i32, mut b: i32| {
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a.abs()
    };
    let all = (-REACH..=REACH).flat_map(|x| (1..=REACH).map(move |y| [x, y]));
    let mut rays: Vec<[i32; 2]> = all.filter(|&[x, y]| divisor(x, y) == 1).collect();
    rays.sort_by(|p, q| (p[1] * q[0]).cmp(&(p[0] * q[1])));
    let half = rays.len();
    rays.extend_from_within(..);
    rays[half..].iter_mut().for_each(|p| *p = p.map(|x| -x));

    // Vertex 0 is the hub; ray i has the vertices 2 i + 1 and 2 i + 2.
    let mut points = vec![[0, 0]];
    points.extend(rays.iter().flat_map(|&[x, y]| [[x, y], [2 * x, 2 * y]]));
    let edges: Vec<[usize; 2]> = (0..half).map(|i| [2 * i + 2, 2 * (i + half) + 2]).collect();
    let triangles = (0..2 * half).flat_map(|i| {
        let [a, b] = [i, (i + 1) % (2 * half)].map(|i| 2 * i + 1);
        [[0, a, b], [a, a + 1, b + 1], [a, b + 1, b]]
    });
    let triangles: Vec<[usize; 3]> = triangles.collect();
    let violations = verify(&points, &edges, &triangles).unwrap_err();
    assert_eq!(violations.report.constrained_sides, 4 * half);
    assert_eq!(violations.report.boundary_sides, 2 * half);
}

/// A row of vertices below and above which there is one.
fn row(count: usize) -> Points {
    let mut points: Points = (0..count).map(|i| [i as f64, 0.0]).collect();
    points.extend([[0.5, count as f64], [0.5, -(count as f64)]]);
    points
}

#[test]
fn edges_that_overlap() {
    const COUNT: usize = 20_000;
    let points = row(COUNT);
    let triangles: Vec<[usize; 3]> = triangulate(&points, &[]).unwrap().triangles().collect();
    let repeated = vec![[0, COUNT - 1]; COUNT];
    let reversed = (0..COUNT / 2).map(|i| [COUNT - 1 - i, i]).collect();
    let shifted = (0..COUNT / 2).map(|i| [i, i + COUNT / 2]).collect();
    for edges in [repeated, reversed, shifted] {
        let report = verify(&points, &edges, &triangles).unwrap();
        assert_eq!(report.constrained_sides, COUNT - 1);
    }
}

/// A gap in a row, as seen by edges that overlap there.
#[test]
fn edges_that_overlap_end_at_the_same_gap() {
    // Two vertices above and below the gap, from 9 to 10, are joined across it.
    let row = (0..16).map(|i| [if i < 10 { i } else { i + 4 }, 0]);
    let mut points: Vec<[i32; 2]> = row.map(|[x, y]| [2 * x, y]).collect();
    points.extend([[23, 1], [23, -1], [20, 90], [20, -90]]);
    let triangles: Vec<[usize; 3]> = triangulate(&points, &[]).unwrap().triangles().collect();
    let edges = [
        [0, 15],
        [3, 12],
        [2, 8],
        [15, 0],
        [12, 15],
        [13, 4],
        [8, 10],
        [1, 8],
        [3, 12],
    ];
    let list = verify(&points, &edges, &triangles).unwrap_err().list;
    let missing = [(0, 9), (1, 9), (3, 10), (5, 10), (6, 9), (8, 9)];
    let missing = missing.map(|(edge, after)| Violation::MissingEdge { edge, after });
    assert_eq!(list, missing);
}

/// A long boundary that begins at the left, and many short ones.
#[test]
fn many_boundaries() {
    const COUNT: usize = 60_000;
    let width = COUNT as i64;
    let mut points: Vec<[i64; 2]> = (0..width).map(|x| [x, x * x]).collect();
    points.push([width / 2, width * width]);
    let fan = (0..COUNT - 1).map(|v| [v, v + 1, COUNT]);
    let mut triangles: Vec<[usize; 3]> = fan.collect();
    for i in 0..width {
        let (v, x) = (points.len(), 2 * width + 2 * i);
        points.extend([[x, 0], [x + 1, 0], [x, 1]]);
        triangles.push([v, v + 1, v + 2]);
    }
    let violations = verify(&points, &[], &triangles).unwrap_err();
    let is_extra = |violation: &Violation| violation.name() == "extra-boundary";
    assert!(violations.list.iter().all(is_extra), "{violations}");
}

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

//! What a run reports of itself: numbers, times, memory, progress, and how good its front structure was.

use std::cell::RefCell;
use std::time::{Duration, Instant};

use sweep_cdt::Triangulator;
use sweep_cdt::front::{Domain, FrontSearch, Linear, SkipList};

use sweep_cdt_testing::Random;

/// The first points of a raster, row by row.
fn raster(count: usize) -> Vec<[f64; 2]> {
    let at = |i: usize| [i % 100, i / 100].map(|x| x as f64);
    (0..count).map(at).collect()
}

#[test]
fn numbers_and_times() {
    let mut points = raster(5000);
    points.push(points[7]);
    let edges = [[0, 1], [5000, 100]];
    let start = Instant::now();
    let run = Triangulator::new().triangulate_with_stats(&points, &edges);
    let elapsed = start.elapsed();
    let run = run.expect("no edges cross");
    let (result, stats) = (run.triangulation, run.stats);
    assert_eq!((stats.points, stats.edges, stats.duplicates), (5001, 2, 1));
    assert_eq!(
        (stats.triangles, stats.hull),
        (result.len(), result.hull().len())
    );
    let times = [stats.initialization, stats.sweeping, stats.finalization];
    assert!(times.iter().all(|time| !time.is_zero()), "{times:?}");
    assert!(times.iter().sum::<Duration>() <= elapsed, "{times:?}");
}

/// The bytes that a run reports, and those that arrays of the expected sizes have.
fn memory(points: &[[f64; 2]], edges: &[[usize; 2]]) -> [usize; 2] {
    let run = Triangulator::new().triangulate_with_stats(points, edges);
    let stats = run.expect("no edges cross").stats;
    let n = points.len();
    // Two artificial vertices and their triangles; 32 bytes a triangle, 4 an open side, 8 a node.
    let mesh = 32 * (2 * n + 2) + 4 * (n + 2);
    let vertices = 8 * (n + 2) + 16 * (n + 2) + 4 * n;
    // A start for each vertex and one more; lower end and number, and both ends.
    let listed = 4 * (n + 1) + (8 + 8) * edges.len();
    [stats.memory, mesh + vertices + listed]
}

#[test]
fn memory_for_edges_that_are_sides() {
    let [found, expected] = memory(&raster(5000), &[[0, 1], [3, 2], [0, 100]]);
    assert_eq!(found, expected);
}

#[test]
fn memory_for_edges_that_pierce_all_triangles() {
    // From each vertex of the lowest row to the one right of that above it in the uppermost.
    let edges: Vec<[usize; 2]> = (0..99).map(|i| [i, 4900 + i + 1]).collect();
    let [found, expected] = memory(&raster(5000), &edges);
    // The sides opened for one edge are closed before the next one: that array has grown once.
    assert!((expected..=expected + 4 * (5000 + 2)).contains(&found));
}

#[test]
fn progress_every_few_thousand_points() {
    let seen = RefCell::new(Vec::new());
    let progress = |swept, all| seen.borrow_mut().push((swept, all));
    let triangulator = Triangulator::new().progress(&progress);
    let result = triangulator.triangulate(&raster(10_000), &[]);
    assert!(result.is_ok());
    assert_eq!(
        seen.into_inner(),
        [0, 4096, 8192].map(|swept| (swept, 10_000))
    );
}

/// How many steps of the walk a structure left, a point.
fn steps<F: FrontSearch + Clone + Default>(points: &[[f64; 2]]) -> f64 {
    let run = Triangulator::new()
        .front(F::default())
        .triangulate_with_stats(points, &[]);
    let stats = run.expect("no edges cross").stats;
    stats.counters.front_steps as f64 / points.len() as f64
}

/// Random points in a square, x to some odd power: the higher, the more crowd around zero.
fn skewed(power: i32) -> Vec<[f64; 2]> {
    let mut random = Random::new(1);
    let mut at = || [random.integer(1 << 20).powi(power), random.integer(1 << 20)];
    (0..5000).map(|_| at()).collect()
}

#[test]
fn a_skip_list_leaves_no_steps() {
    for points in [skewed(1), skewed(5), raster(5000)] {
        assert!(steps::<SkipList>(&points) == 0.0);
    }
}

#[test]
fn the_last_node_is_near_where_points_come_in_rows() {
    assert!(steps::<Linear>(&raster(5000)) < 3.0);
}

#[test]
fn a_domain_is_the_vertices() {
    let near = [[3.0, 1.0], [2.0, 5.0]];
    let domain = Domain::new(&near);
    assert_eq!((domain.len(), domain.is_empty()), (2, false));
    assert_eq!([0, 1].map(|rank| domain.x(rank).to_string()), ["3", "2"]);
    assert!(Domain::new(&[]).is_empty());
}

//! What a [`Run`](sweep_cdt::Run) reports of itself: numbers, times, memory, progress, how good its front structure
//! was, and what it returns of its settings.

use std::cell::{Cell, RefCell};
use std::fmt::Debug;
use std::time::{Duration, Instant};

use num_bigint::BigInt;
use sweep_cdt::front::{Domain, Front, FrontNode, FrontSearch, HashTable, Linear, SkipList};
use sweep_cdt::scalar::Scalar;
use sweep_cdt::{Heuristics, Stats, Triangulator};
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
fn steps_a_point<F: FrontSearch + Clone + Default>(points: &[[f64; 2]]) -> f64 {
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
        assert!(steps_a_point::<SkipList>(&points) == 0.0);
    }
}

#[test]
fn the_last_node_is_near_where_points_come_in_rows() {
    assert!(steps_a_point::<Linear>(&raster(5000)) < 3.0);
}

#[test]
fn a_domain_is_the_vertices() {
    let near = [[3.0, 1.0], [2.0, 5.0]];
    let domain = Domain::new(&near);
    assert_eq!((domain.len(), domain.is_empty()), (2, false));
    assert_eq!([0, 1].map(|rank| domain.x(rank).to_string()), ["3", "2"]);
    assert!(Domain::new(&[]).is_empty());
}

/// So many points squared, scattered in a square.
fn square(side: usize) -> Vec<[f64; 2]> {
    let at = |i: usize| [i * 7919 % 1009, i * 6007 % 1013].map(|x| x as f64);
    (0..side * side).map(at).collect()
}

/// A structure that an earlier run has filled works as a new one does.
fn assert_forgets<F: FrontSearch + Clone + Debug + Default>() {
    let [large, small] = [70, 10].map(square);
    let count = |front: F, points: &[[f64; 2]]| {
        let triangulator = Triangulator::new().front(front);
        let run = triangulator.triangulate_with_stats(points, &[]);
        run.map(|run| (run.stats.counters, run.front))
            .expect("no edges")
    };
    for [first, second] in [[&large, &small], [&small, &large]] {
        let (_, used) = count(F::default(), first);
        let (expected, new) = count(F::default(), second);
        let (found, used) = count(used, second);
        assert_eq!(found, expected);
        assert_eq!(format!("{used:?}"), format!("{new:?}"));
    }
}

#[test]
fn every_front_forgets_an_earlier_run() {
    assert_forgets::<HashTable>();
    assert_forgets::<SkipList>();
    assert_forgets::<Linear>();
}

/// Counts what it is asked.
#[derive(Clone, Default)]
struct Counting {
    begun: usize,
    searches: usize,
}

impl FrontSearch for Counting {
    fn begin(&mut self, _: Domain<'_>) {
        self.begun += 1;
    }

    fn locate(&mut self, _: f64, front: &Front) -> FrontNode {
        self.searches += 1;
        front.left_end()
    }
}

#[test]
fn the_front_that_was_used_comes_back() {
    let points = square(5);
    let triangulator = Triangulator::new().front(Counting::default());
    let counted = triangulator.triangulate_with_stats(&points, &[]);
    let observed = triangulator.triangulate_observed(&points, &[], |_| ());
    for run in [counted, observed] {
        let front = run.expect("no edges").front;
        assert_eq!((front.begun, front.searches), (1, points.len() - 1));
    }
}

#[test]
fn settings_hold_in_any_order_and_for_every_kind_of_run() {
    let points = square(10);
    let calls = Cell::new(0);
    let progress = |_, _| calls.set(calls.get() + 1);
    let first = Triangulator::new().progress(&progress);
    let first = first.heuristics(Heuristics::OFF).front(Linear::default());
    let last = Triangulator::new().front(Linear::default());
    let last = last.heuristics(Heuristics::OFF).progress(&progress);
    for triangulator in [first, last] {
        let kinds = [
            triangulator.triangulate_with_stats(&points, &[]),
            triangulator.triangulate_observed(&points, &[], |_| ()),
        ];
        for run in kinds {
            let made = run.expect("no edges").stats.counters.made;
            assert_eq!((made.narrow_corners, made.basins), (0, 0));
        }
        triangulator.triangulate(&points, &[]).expect("no edges");
        assert_eq!(calls.replace(0), 3);
    }
}

#[test]
fn an_observed_run_has_the_statistics_of_any_other() {
    let (points, edges) = (square(20), [[0, 399], [3, 7]]);
    let timeless = |stats: Stats| {
        let times = [stats.initialization, stats.sweeping, stats.finalization];
        assert!(times.iter().all(|time| !time.is_zero()), "{times:?}");
        (stats.points, stats.triangles, stats.memory, stats.counters)
    };
    let triangulator = Triangulator::new();
    let counted = triangulator.triangulate_with_stats(&points, &edges);
    let observed = triangulator.triangulate_observed(&points, &edges, |_| ());
    let [counted, observed] = [counted, observed].map(|run| run.expect("no edges cross").stats);
    assert_eq!(timeless(observed), timeless(counted));
}

/// Sizes that differ so much that only big integers decide, and points on one line and one circle.
#[test]
fn signs_from_big_integers_are_counted_as_such() {
    let points = [
        [0.0, 0.0],
        [1e-300, 0.0],
        [1e200, 0.0],
        [2e200, 0.0],
        [0.0, 1e200],
        [1e200, 1e200],
    ];
    let run = Triangulator::new().triangulate_with_stats(&points, &[]);
    let counters = run.expect("no edges").stats.counters;
    let big = [counters.orient2d_big, counters.in_circle_big];
    assert!(big.iter().all(|&count| count > 0), "{counters:?}");
    let others = counters.orient2d_integers + counters.orient2d_expansions;
    assert_eq!(counters.orient2d_exact(), others + counters.orient2d_big);
}

/// Steps along the front for each vertex.
fn whole_steps_a_point<F: FrontSearch + Clone + Default, S: Scalar>(points: &[[S; 2]]) -> u64 {
    let triangulator = Triangulator::new().front(F::default());
    let run = triangulator.triangulate_with_stats(points, &[]);
    run.expect("no edges").stats.counters.front_steps / points.len() as u64
}

/// A fifth of the points in a millionth of the width and height: equal intervals would be crowded.
#[test]
fn a_crowded_fifth_makes_no_walk_longer() {
    let mut points = Random::new(1).points(50_000);
    for point in points.iter_mut().step_by(5) {
        *point = point.map(|x| 0.5 + 1e-6 * x);
    }
    assert!(whole_steps_a_point::<HashTable, _>(&points) < 2);
}

/// The points that the hash table samples lie all over the width, the others in a tiny part of it.
#[test]
fn points_placed_beside_the_sample_make_no_search_long() {
    const COUNT: usize = 60_000;
    let sampled = COUNT.div_ceil(4096);
    let mut points = Random::new(1).points(COUNT);
    points.sort_by(|a, b| a[1].total_cmp(&b[1]));
    for (rank, [x, y]) in points.iter_mut().enumerate() {
        *y *= 1e-9;
        if rank % sampled != 0 {
            *x = 0.5 + 1e-9 * *x;
        }
    }
    // First it bears 16 steps a vertex, then it asks for places.
    assert!(whole_steps_a_point::<HashTable, _>(&points) < 18);
}

/// A row far from most points, where doubles cannot tell its points apart, and points above it.
#[test]
fn points_with_equal_doubles_make_no_search_long() {
    let far = BigInt::from(1) << 100;
    let row = |i: i32| [&far + 1000 * i, BigInt::from(0)];
    let above = |i: i32| [&far + (i * 7919 % 1000) * 1000 + 500, BigInt::from(1 + i)];
    let near = |i: i32| [i, 10_000 + i * i % 7].map(BigInt::from);
    let mut points: Vec<[BigInt; 2]> = (0..1000).flat_map(|i| [row(i), above(i)]).collect();
    points.extend((0..3000).map(near));
    assert!(whole_steps_a_point::<HashTable, _>(&points) < 18);
    assert!(whole_steps_a_point::<SkipList, _>(&points) < 18);
}

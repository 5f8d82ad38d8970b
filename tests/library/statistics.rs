//! What a run reports of itself: numbers, times, memory, progress, the length of its front.

use std::time::{Duration, Instant};

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch};
use sweep_cdt::{Algorithm, Corners, Heuristics, Stats, Triangulator, Watch};
use sweep_cdt_testing::runs::ALGORITHMS;
use sweep_cdt_testing::{Random, counted, watched};

/// The first points of a raster, row by row.
pub(crate) fn raster(count: usize) -> Vec<[f64; 2]> {
    let at = |i: usize| [i % 100, i / 100].map(|x| x as f64);
    (0..count).map(at).collect()
}

#[test]
fn numbers_and_times() {
    let mut points = raster(5000);
    points.push(points[7]);
    let edges = [[0, 1], [5000, 100]];
    let start = Instant::now();
    let run = counted(&Triangulator::new(), &points, &edges);
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
    let run = counted(&Triangulator::new(), points, edges);
    let stats = run.expect("no edges cross").stats;
    let n = points.len();
    // Two artificial vertices and their triangles; 24 bytes a triangle, 4 an open side, 8 a node.
    let mesh = 24 * (2 * n + 2) + 4 * (n + 2);
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
    let mut seen = Vec::new();
    let mut progress = |swept, all| seen.push((swept, all));
    let watch = Watch::new().progress(&mut progress);
    let result = Triangulator::new().run(&raster(10_000), &[], watch);
    assert!(result.is_ok());
    assert_eq!(seen, [0, 4096, 8192].map(|swept| (swept, 10_000)));
}

/// So many points squared, scattered in a square.
pub(crate) fn square(side: usize) -> Vec<[f64; 2]> {
    let at = |i: usize| [i * 7919 % 1009, i * 6007 % 1013].map(|x| x as f64);
    (0..side * side).map(at).collect()
}

/// Counts what it is asked.
#[derive(Clone, Default)]
struct Counting {
    begun: usize,
    searches: usize,
}

impl FrontSearch for Counting {
    fn begin(&mut self, _: FrontInput<'_>) {
        self.begun += 1;
    }

    fn locate(&mut self, _: f64, front: &Front) -> FrontNode {
        self.searches += 1;
        front.left_end()
    }
}

/// In a session, too: each run begins the structure once.
#[test]
fn each_run_begins_its_front_anew() {
    let points = square(5);
    let (mut front, mut session) = (Counting::default(), Triangulator::new().session());
    for runs in 1..4 {
        let watch = Watch::new().front(&mut front);
        session.run(&points, &[], watch).expect("no edges");
        let searches = runs * (points.len() - 1);
        assert_eq!((front.begun, front.searches), (runs, searches));
    }
}

/// The lengths of the front that a structure sees at all searches.
#[derive(Clone, Default)]
struct Lengths {
    now: u64,
    sum: u64,
    searches: u64,
}

impl FrontSearch for Lengths {
    fn begin(&mut self, _: FrontInput<'_>) {}

    fn locate(&mut self, _: f64, front: &Front) -> FrontNode {
        self.searches += 1;
        self.sum += self.now;
        front.left_end()
    }

    fn inserted(&mut self, _: FrontNode, _: f64) {
        self.now += 1;
    }

    fn removed(&mut self, _: FrontNode, _: f64) {
        self.now -= 1;
    }
}

/// Whatever the algorithm: a triangle that a point makes is no point event, and there may be no front at all.
#[test]
fn the_mean_front_is_that_of_all_searches() {
    // The last point sees many sides of the lower hull, and makes a triangle with each where these are kept.
    let mut points = Random::new(3).points(479);
    points.extend((2..22).map(f64::from).map(|i| [i, i * i]));
    points.push([1e3, 500.0]);
    let of = |algorithm| {
        let mut front = Lengths::default();
        let triangulator = Triangulator::new().algorithm(algorithm);
        let watch = Watch::new().front(&mut front);
        let run = watched(&triangulator, &points, &[[0, 1]], watch).expect("one edge");
        let counters = run.stats.counters;
        assert_eq!(counters.survived.sum(), run.triangulation.len() as u64);
        let seen = [front.searches, front.sum];
        assert_eq!([counters.point_events, counters.front_lengths], seen);
        let mean = seen[1] as f64 / seen[0].max(1) as f64;
        assert!((counters.mean_front() - mean).abs() < 1e-9, "{algorithm:?}");
        if format!("{algorithm:?}") == "Sweep2005" {
            assert!(counters.made.middle > seen[0], "{counters:?}");
        }
        seen[0]
    };
    assert_eq!(of(Algorithm::Sweep), 499);
    for &(name, algorithm) in ALGORITHMS {
        let is_sweep = matches!(name, "the paper's order" | "sweep of 2005");
        let expected = if is_sweep { 499 } else { 0 };
        assert_eq!(of(algorithm), expected, "{name}");
    }
}

/// Two corners, one after the other on the right of the last point. The squares of their cosines are 0.037 and
/// 0.032, obtuse both; that of the second one is 0.6 before.
#[test]
fn obtuse_corners_are_closed_up_to_their_angle() {
    let points = [[0, 0], [20, 2], [23, 5], [-6, 20]];
    let closed = |corners| {
        let mut heuristics = Heuristics::OFF;
        heuristics.corners = corners;
        let run = counted(&Triangulator::new().heuristics(heuristics), &points, &[]);
        run.expect("no edges").stats.counters.made.narrow_corners
    };
    for (corners, expected) in [
        (Corners::Off, 0),
        (Corners::RightAngle, 0),
        #[cfg(feature = "comparison")]
        (Corners::OneUpTo(0), 0),
        #[cfg(feature = "comparison")]
        (Corners::AllUpTo(0), 0),
        (Corners::Wide, 1),
        #[cfg(feature = "comparison")]
        (Corners::OneUpTo(1), 1),
        #[cfg(feature = "comparison")]
        (Corners::AllUpTo(1), 2),
        #[cfg(feature = "comparison")]
        (Corners::AllUpTo(8), 2),
    ] {
        assert_eq!(closed(corners), expected, "{corners:?}");
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
    let mut steps = 0;
    let mut observer = |_| steps += 1;
    let mut observed = Stats::default();
    let watch = Watch::new().events(&mut observer).stats(&mut observed);
    let result = triangulator.run(&points, &edges, watch);
    result.expect("no edges cross");
    let others = counted(&triangulator, &points, &edges).expect("no edges cross");
    assert_eq!(timeless(observed), timeless(others.stats));
    assert!(steps > 1000);
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
    let run = counted(&Triangulator::new(), &points, &[]);
    let counters = run.expect("no edges").stats.counters;
    let big = [counters.orient2d_big, counters.in_circle_big];
    assert!(big.iter().all(|&count| count > 0), "{counters:?}");
    let others = counters.orient2d_integers + counters.orient2d_expansions;
    assert_eq!(counters.orient2d_exact(), others + counters.orient2d_big);
}
